#ifndef PLACE_MEMORY_CORE_STORE_PACKED_BYTES_H
#define PLACE_MEMORY_CORE_STORE_PACKED_BYTES_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

namespace place_memory::core {

/// Numbers in a row of bytes, the least significant byte of each first on every machine.
class BytePacker {
 public:
  template <typename Number>
  BytePacker& add(Number number) {
    static_assert(std::is_arithmetic_v<Number>, "numbers only");
    std::uint64_t bits = 0;
    if constexpr (std::is_same_v<Number, double>) {
      std::memcpy(&bits, &number, sizeof(number));
    } else if constexpr (std::is_same_v<Number, float>) {
      std::uint32_t half = 0;
      std::memcpy(&half, &number, sizeof(number));
      bits = half;
    } else {
      bits = static_cast<std::uint64_t>(number);
    }
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      bytes_.push_back(static_cast<unsigned char>(bits >> 8 * i & 0xffU));
    }
    return *this;
  }

  /// With its length.
  BytePacker& add(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    return *this;
  }

  const std::vector<unsigned char>& bytes() const { return bytes_; }

 private:
  std::vector<unsigned char> bytes_;
};

/// Takes them out again, in the same order.
class ByteUnpacker {
 public:
  ByteUnpacker(const void* bytes, std::size_t size)
      : next_(static_cast<const unsigned char*>(bytes)), left_(bytes == nullptr ? 0 : size) {}

  /// 0, and good() no more, where there are not enough bytes.
  template <typename Number>
  Number take() {
    static_assert(std::is_arithmetic_v<Number>, "numbers only");
    if (left_ < sizeof(Number)) {
      good_ = false;
      return Number{};
    }
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) bits |= std::uint64_t{*next_++} << 8 * i;
    left_ -= sizeof(Number);
    Number number{};
    if constexpr (std::is_same_v<Number, double>) {
      std::memcpy(&number, &bits, sizeof(number));
    } else if constexpr (std::is_same_v<Number, float>) {
      const auto half = static_cast<std::uint32_t>(bits);
      std::memcpy(&number, &half, sizeof(number));
    } else {
      number = static_cast<Number>(bits);
    }
    return number;
  }

  /// As BytePacker adds it.
  std::string takeText() {
    const std::size_t size = take<std::uint32_t>();
    if (left_ < size) {
      good_ = false;
      return {};
    }
    const std::string text(next_, next_ + size);
    next_ += size;
    left_ -= size;
    return text;
  }

  std::size_t left() const { return left_; }
  bool good() const { return good_; }

 private:
  const unsigned char* next_;
  std::size_t left_;
  bool good_ = true;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_PACKED_BYTES_H
