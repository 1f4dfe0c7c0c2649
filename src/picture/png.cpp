#include "picture/png.h"

#include <boost/crc.hpp>
#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <cstdint>
#include <sstream>

namespace place_memory::picture {
namespace {

constexpr char kSignature[] = "\x89PNG\r\n\x1a\n";
constexpr char kBitsAndKind[] = {8, 2, 0, 0, 0};  // 8 bits, RGB; the only methods; not interlaced

std::string bigEndian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift);
  return bytes;
}

std::string chunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  boost::crc_32_type sum;
  sum.process_bytes(body.data(), body.size());
  return bigEndian(static_cast<std::uint32_t>(data.size())) + body + bigEndian(sum.checksum());
}

std::string compressed(const std::string& bytes) {
  namespace io = boost::iostreams;
  std::istringstream source(bytes);
  std::ostringstream result;
  io::filtering_ostream stream;
  stream.push(io::zlib_compressor(io::zlib::best_compression));
  stream.push(result);
  io::copy(source, stream);
  return result.str();
}

}  // namespace

std::string encodePng(const std::vector<Color>& pixels, int width) {
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t rows = pixels.size() / columns;
  std::string lines;
  lines.reserve(rows * (3 * columns + 1));
  for (std::size_t i = 0; i < rows * columns; ++i) {
    if (i % columns == 0) lines += '\0';  // unfiltered: few colours compress best so
    lines += static_cast<char>(pixels[i].red);
    lines += static_cast<char>(pixels[i].green);
    lines += static_cast<char>(pixels[i].blue);
  }
  return std::string(kSignature, sizeof kSignature - 1) +
         chunk("IHDR", bigEndian(static_cast<std::uint32_t>(columns)) +
                           bigEndian(static_cast<std::uint32_t>(rows)) +
                           std::string(kBitsAndKind, sizeof kBitsAndKind)) +
         chunk("IDAT", compressed(lines)) + chunk("IEND", "");
}

}  // namespace place_memory::picture
