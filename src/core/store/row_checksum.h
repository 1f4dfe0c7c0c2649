#ifndef PLACE_MEMORY_CORE_STORE_ROW_CHECKSUM_H
#define PLACE_MEMORY_CORE_STORE_ROW_CHECKSUM_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// The checksum of a row, its key included: FNV-1a over words of 64 bits. It changes with any one
/// word, and takes a tenth of a CRC-32's time, which is what the start with a million places would
/// otherwise consist of. The same on every machine.
class RowChecksum {
 public:
  explicit RowChecksum(std::uint64_t seed = 0xcbf29ce484222325U) : sum_(seed) {}

  RowChecksum& add(std::uint64_t word) {
    sum_ = (sum_ ^ word) * 0x100000001b3U;
    return *this;
  }
  RowChecksum& add(std::int64_t number) { return add(static_cast<std::uint64_t>(number)); }
  RowChecksum& add(double number) {
    const double stored = number == 0.0 ? 0.0 : number;  // SQLite keeps no sign of a zero
    std::uint64_t bits = 0;
    std::memcpy(&bits, &stored, sizeof(bits));
    return add(bits);
  }
  RowChecksum& add(const Pose2d& pose) { return add(pose.x).add(pose.y).add(pose.yaw); }
  /// With their number.
  RowChecksum& add(const void* bytes, std::size_t size) {
    add(static_cast<std::uint64_t>(size));
    const auto* next = static_cast<const unsigned char*>(bytes);
    for (; size >= sizeof(std::uint64_t); size -= sizeof(std::uint64_t)) {
      add(word(next, sizeof(std::uint64_t)));
      next += sizeof(std::uint64_t);
    }
    return size == 0 ? *this : add(word(next, size));
  }
  RowChecksum& add(const std::string& text) { return add(text.data(), text.size()); }

  std::uint64_t value() const { return sum_; }

 private:
  static std::uint64_t word(const unsigned char* bytes, std::size_t size) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value |= std::uint64_t{bytes[i]} << 8 * i;
    return value;
  }

  std::uint64_t sum_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_STORE_ROW_CHECKSUM_H
