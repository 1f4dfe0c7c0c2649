#include "node/input/message_lengths.h"

namespace place_memory::node {
namespace {

// On the wire.
constexpr std::uint64_t kStampAndSequence = 12;
constexpr std::uint64_t kFloat = 4;
constexpr std::uint64_t kPoint = 3 * kFloat;
constexpr std::uint64_t kTransform = 7 * 8;

}  // namespace

bool LengthCheck::check(const sensor_msgs::LaserScan* /*type*/) {
  header();
  skip(7 * kFloat);  // angles, times and the range
  list(kFloat);      // ranges
  list(kFloat);      // intensities
  return good_;
}

bool LengthCheck::check(const sensor_msgs::PointCloud* /*type*/) {
  header();
  list(kPoint);
  for (std::uint32_t channels = number(); channels > 0 && good_; --channels) {
    text();
    list(kFloat);
  }
  return good_;
}

bool LengthCheck::check(const sensor_msgs::PointCloud2* /*type*/) {
  header();
  skip(4 + 4);  // height and width
  for (std::uint32_t fields = number(); fields > 0 && good_; --fields) {
    text();
    skip(4 + 1 + 4);  // offset, type and count
  }
  skip(1 + 4 + 4);  // the order of bytes, and steps
  list(1);
  return good_;
}

bool LengthCheck::check(const tf2_msgs::TFMessage* /*type*/) {
  for (std::uint32_t transforms = number(); transforms > 0 && good_; --transforms) {
    header();
    text();
    skip(kTransform);
  }
  return good_;
}

void LengthCheck::skip(std::uint64_t size) {
  good_ = good_ && size <= bytes_.size() - at_;
  if (good_) at_ += static_cast<std::size_t>(size);
}

std::uint32_t LengthCheck::number() {
  const std::size_t begin = at_;
  skip(sizeof(std::uint32_t));
  if (!good_) return 0;
  std::uint32_t value = 0;
  for (std::size_t i = sizeof(value); i-- > 0;) value = value << 8U | bytes_[begin + i];
  return value;
}

void LengthCheck::text() { skip(number()); }

void LengthCheck::header() {
  skip(kStampAndSequence);
  text();
}

void LengthCheck::list(std::uint64_t size) { skip(number() * size); }

}  // namespace place_memory::node
