#include "picture/line_font.h"

#include <algorithm>
#include <map>

namespace place_memory::picture {
namespace {

// Each letter lies on a lattice, x from 0 to 4 and y from 0 to 8: the base line is at 2, capitals
// reach to 8, small letters to 6. A stroke is a row of points, two digits each; strokes are parted
// by blanks.
const std::map<char, const char*>& letters() {
  static const std::map<char, const char*> letters{
      {' ', ""},
      {'0', "123243473818070312"},
      {'1', "172822 1232"},
      {'2', "07183847460242"},
      {'3', "0718384746354443321203 2535"},
      {'4', "32380444"},
      {'5', "480805354443321203"},
      {'6', "4738180703123243443505"},
      {'7', "084822"},
      {'8', "15040312324344351506071838474635"},
      {'9', "0312324347381807061545"},
      {'A', "022842 1434"},
      {'B', "02083847463505 3544433202"},
      {'C', "4738180703123243"},
      {'D', "02082846442202"},
      {'E', "48080242 0535"},
      {'F', "480802 0535"},
      {'G', "47381807031232434525"},
      {'H', "0802 4842 0545"},
      {'I', "1838 2822 1232"},
      {'J', "4843321203"},
      {'K', "0802 480542"},
      {'L', "080242"},
      {'M', "0208254842"},
      {'N', "02084248"},
      {'O', "123243473818070312"},
      {'P', "02083847463505"},
      {'Q', "123243473818070312 2442"},
      {'R', "02083847463505 2542"},
      {'S', "473818070615354443321203"},
      {'T', "0848 2822"},
      {'U', "080312324348"},
      {'V', "082248"},
      {'W', "0812253248"},
      {'X', "0842 4802"},
      {'Y', "082548 2522"},
      {'Z', "08480242"},
      {'a', "4642 4536160503123243"},
      {'b', "0802 0516364543321203"},
      {'c', "4536160503123243"},
      {'d', "4842 4536160503123243"},
      {'e', "04444536160503123243"},
      {'f', "48382722 1636"},
      {'g', "4641301001 4536160503123243"},
      {'h', "0802 0516364542"},
      {'i', "2622 2828"},
      {'j', "36312010 3838"},
      {'k', "0802 460442"},
      {'l', "182822 1232"},
      {'m', "0602 05162522 25364542"},
      {'n', "0602 0516364542"},
      {'o', "163645433212030516"},
      {'p', "0600 0516364543321203"},
      {'q', "4640 4536160503123243"},
      {'r', "0602 05163645"},
      {'s', "45361605143443321203"},
      {'t', "28233242 1646"},
      {'u', "0603123243 4642"},
      {'v', "062246"},
      {'w', "0612243246"},
      {'x', "0642 4602"},
      {'y', "0622 4610"},
      {'z', "06460242"},
      {'.', "2222"},
      {',', "2211"},
      {':', "2525 2222"},
      {';', "2525 2211"},
      {'!', "2824 2222"},
      {'?', "07183847462524 2222"},
      {'\'', "2827"},
      {'"', "1817 3837"},
      {'(', "38272332"},
      {')', "18272312"},
      {'[', "38282232"},
      {']', "18282212"},
      {'/', "0248"},
      {'\\', "0842"},
      {'|', "2822"},
      {'-', "1535"},
      {'_', "0141"},
      {'+', "0545 2723"},
      {'=', "0444 0646"},
      {'<', "470543"},
      {'>', "074503"},
      {'*', "2723 0644 4604"},
      {'#', "1218 3238 0444 0646"},
      {'%', "0248 0808 4242"},
  };
  return letters;
}

constexpr char kBox[] = "0208484202";
constexpr double kUnit = 0.7 / 6.0;  // capitals are 0.7 high
constexpr int kBaseLine = 2;

/// Bytes of UTF-8 within a letter.
bool continues(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

void addStrokes(const char* lattice, double left, std::vector<std::vector<Point>>& strokes) {
  bool begins = true;
  for (const char* at = lattice; *at != '\0'; ++at) {
    if (*at == ' ') {
      begins = true;
      continue;
    }
    if (begins) strokes.emplace_back();
    begins = false;
    const int x = *at - '0';
    const int y = *++at - '0';
    strokes.back().push_back({left + kUnit * x, kUnit * (y - kBaseLine)});
  }
}

}  // namespace

std::size_t countLetters(const std::string& text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues));
}

double widthOf(const std::string& text, double size) {
  return kAdvance * size * static_cast<double>(countLetters(text));
}

std::vector<std::vector<Point>> strokes(const std::string& text) {
  std::vector<std::vector<Point>> found;
  double left = 0.0;
  for (const char letter : text) {
    if (continues(letter)) continue;
    const auto lattice = letters().find(letter);
    addStrokes(lattice == letters().end() ? kBox : lattice->second, left, found);
    left += kAdvance;
  }
  return found;
}

}  // namespace place_memory::picture
