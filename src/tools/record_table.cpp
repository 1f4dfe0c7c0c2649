#include "tools/record_table.h"

#include <algorithm>
#include <cmath>

#include "picture/svg_text.h"
#include "support/text.h"

namespace place_memory::tools {
namespace {

constexpr char kGap[] = "  ";

std::string inWords(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return support::printable(*text);
  if (const auto* number = std::get_if<std::int64_t>(&cell)) return std::to_string(*number);
  if (const auto* number = std::get_if<Decimal>(&cell)) {
    return std::isfinite(number->number) ? picture::decimal(number->number, number->decimals) : "-";
  }
  return std::get<bool>(cell) ? "yes" : "no";
}

std::string asJson(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return jsonText(*text);
  if (const auto* yes = std::get_if<bool>(&cell)) return *yes ? "true" : "false";
  const std::string number = inWords(cell);
  return number == "-" ? "null" : number;
}

bool isNumber(const Cell& cell) {
  return std::holds_alternative<std::int64_t>(cell) || std::holds_alternative<Decimal>(cell);
}

/// Letters, not bytes.
std::size_t widthOf(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
  }));
}

std::string padded(const std::string& text, std::size_t width, bool to_the_right) {
  const std::string blanks(width - std::min(width, widthOf(text)), ' ');
  return to_the_right ? blanks + text : text + blanks;
}

std::string withoutTrailingBlanks(const std::string& line) {
  return line.substr(0, line.find_last_not_of(' ') + 1);
}

}  // namespace

void RecordTable::print(std::ostream& out) const {
  if (rows_.empty()) return;
  std::vector<std::size_t> widths;
  for (std::size_t column = 0; column < names_.size(); ++column) {
    std::size_t width = widthOf(names_[column]);
    for (const auto& row : rows_) width = std::max(width, widthOf(inWords(row[column])));
    widths.push_back(width);
  }
  std::string line;
  for (std::size_t column = 0; column < names_.size(); ++column) {
    line += padded(names_[column], widths[column], isNumber(rows_.front()[column])) + kGap;
  }
  out << withoutTrailingBlanks(line) << '\n';
  for (const auto& row : rows_) {
    line.clear();
    for (std::size_t column = 0; column < names_.size(); ++column) {
      line += padded(inWords(row[column]), widths[column], isNumber(row[column])) + kGap;
    }
    out << withoutTrailingBlanks(line) << '\n';
  }
}

void RecordTable::printJson(std::ostream& out) const {
  out << '[';
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    out << (i == 0 ? "\n" : ",\n") << "  {";
    for (std::size_t column = 0; column < names_.size(); ++column) {
      out << (column == 0 ? "" : ", ") << jsonText(names_[column]) << ": "
          << asJson(rows_[i][column]);
    }
    out << '}';
  }
  out << (rows_.empty() ? "]\n" : "\n]\n");
}

std::string jsonText(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : support::printable(text)) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace place_memory::tools
