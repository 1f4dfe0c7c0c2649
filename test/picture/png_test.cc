#include "picture/png.h"

#include <gtest/gtest.h>

#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>
#include <sstream>

namespace place_memory::picture {
namespace {

std::string inflated(const std::string& bytes) {
  namespace io = boost::iostreams;
  std::istringstream source(bytes);
  std::ostringstream result;
  io::filtering_istream stream;
  stream.push(io::zlib_decompressor());
  stream.push(source);
  io::copy(stream, result);
  return result.str();
}

std::size_t numberAt(const std::string& bytes, std::size_t at) {
  std::size_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = 256 * number + static_cast<unsigned char>(bytes[at + i]);
  return number;
}

TEST(Png, HoldsThePixelsRowByRow) {
  const std::string png = encodePng({{1, 2, 3}, {255, 0, 7}, {4, 5, 6}, {8, 9, 10}}, 2);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(12, 4), "IHDR");
  EXPECT_EQ(numberAt(png, 16), 2U);
  EXPECT_EQ(numberAt(png, 20), 2U);
  const std::size_t data = png.find("IDAT");
  ASSERT_NE(data, std::string::npos);
  EXPECT_EQ(inflated(png.substr(data + 4, numberAt(png, data - 4))),
            std::string("\0\1\2\3\xff\0\7\0\4\5\6\10\11\12", 14));
}

TEST(Png, EndsAsTheStandardSays) {
  const std::string png = encodePng({{0, 0, 0}}, 1);
  // The sum of the last chunk, which holds nothing, is that of its name alone.
  EXPECT_EQ(png.substr(png.size() - 12), std::string("\0\0\0\0IEND\xae\x42\x60\x82", 12));
}

}  // namespace
}  // namespace place_memory::picture
