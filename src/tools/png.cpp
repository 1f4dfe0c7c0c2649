// Layout of the file: https://www.w3.org/TR/png-3/, of its data RFC 1950 and 1951.
#include "tools/png.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace place_memory::tools {
namespace {

constexpr std::size_t kLongestBlock = 65535;  // that is stored uncompressed
constexpr std::uint32_t kAdlerPrime = 65521;

std::string bigEndian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes += static_cast<char>(static_cast<unsigned char>(number >> shift & 0xffU));
  }
  return bytes;
}

std::uint32_t crc32(const std::string& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1U ^ (crc % 2 == 1 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

std::uint32_t adler32(const std::string& bytes) {
  std::uint32_t low = 1;
  std::uint32_t high = 0;
  for (const char byte : bytes) {
    low = (low + static_cast<unsigned char>(byte)) % kAdlerPrime;
    high = (high + low) % kAdlerPrime;
  }
  return high << 16U | low;
}

std::string chunk(const std::string& kind, const std::string& data) {
  return bigEndian(static_cast<std::uint32_t>(data.size())) + kind + data +
         bigEndian(crc32(kind + data));
}

std::string littleEndian(std::size_t number) {
  return {static_cast<char>(static_cast<unsigned char>(number & 0xffU)),
          static_cast<char>(static_cast<unsigned char>(number >> 8U & 0xffU))};
}

std::string stored(const std::string& data) {
  std::string text = "\x78\x01";
  for (std::size_t begin = 0; begin < data.size(); begin += kLongestBlock) {
    const std::size_t size = std::min(kLongestBlock, data.size() - begin);
    text += begin + size == data.size() ? '\1' : '\0';
    text += littleEndian(size) + littleEndian(~size) + data.substr(begin, size);
  }
  return text + bigEndian(adler32(data));
}

}  // namespace

std::string asPng(const GreyPicture& picture) {
  std::string rows;
  for (std::uint32_t row = 0; row < picture.height; ++row) {
    rows += '\0';  // no filter
    const auto begin =
        picture.pixels.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * picture.width);
    rows.append(begin, begin + static_cast<std::ptrdiff_t>(picture.width));
  }
  const std::string eight_bits_of_grey{'\10', '\0', '\0', '\0', '\0'};
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR", bigEndian(picture.width) + bigEndian(picture.height) + eight_bits_of_grey) +
         chunk("IDAT", stored(rows)) + chunk("IEND", "");
}

GreyPicture pictureOf(const core::EvidenceGrid& grid, std::uint32_t scale) {
  constexpr double kWhite = 255.0;
  constexpr double kPrior = 0.5;
  GreyPicture picture;
  picture.width = scale * core::kGridSize;
  picture.height = picture.width;
  picture.pixels.reserve(std::size_t{picture.width} * picture.height);
  for (std::uint32_t y = 0; y < picture.height; ++y) {
    const int row = core::kGridSize - 1 - static_cast<int>(y / scale);
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const double occupied =
          core::EvidenceGrid::probability(grid.at(row, static_cast<int>(x / scale)), kPrior);
      picture.pixels.push_back(static_cast<std::uint8_t>(std::lround(kWhite * (1.0 - occupied))));
    }
  }
  return picture;
}

}  // namespace place_memory::tools
