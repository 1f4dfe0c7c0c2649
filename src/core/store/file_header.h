#ifndef PLACE_MEMORY_CORE_STORE_FILE_HEADER_H
#define PLACE_MEMORY_CORE_STORE_FILE_HEADER_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace place_memory::core {

/// The start of every SQLite file: https://www.sqlite.org/fileformat2.html section 1.3.
class FileHeader {
 public:
  static constexpr std::size_t kSize = 100;

  /// False where the file is too short to have a header.
  bool read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return static_cast<bool>(file.read(bytes_.data(), kSize));
  }

  bool isSqlite() const {
    constexpr std::string_view kMagic("SQLite format 3\0", 16);
    return std::equal(kMagic.begin(), kMagic.end(), bytes_.begin());
  }
  std::uint32_t applicationId() const { return number(68, 4); }
  std::uint32_t userVersion() const { return number(60, 4); }
  std::uint32_t pageSize() const {
    const std::uint32_t page_size = number(16, 2);
    return page_size == 1 ? 65536 : page_size;
  }
  std::uint64_t fileSize() const { return std::uint64_t{pageSize()} * number(28, 4); }

 private:
  std::uint32_t number(std::size_t offset, std::size_t size) const {
    std::uint32_t value = 0;
    for (std::size_t i = offset; i < offset + size; ++i) {
      value = value << 8U | static_cast<unsigned char>(bytes_[i]);
    }
    return value;
  }

  std::array<char, kSize> bytes_{};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_FILE_HEADER_H
