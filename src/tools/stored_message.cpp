#include "tools/stored_message.h"

#include <rosbag/exceptions.h>

#include <algorithm>
#include <exception>
#include <sstream>

namespace place_memory::tools {
namespace {

// No message that is read is as large: its size is damaged.
constexpr std::uint32_t kMostBytes = 1U << 28U;

/// Reads what messages are made of, little-endian, and stops where there is no more.
class ByteReader {
 public:
  explicit ByteReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  std::optional<std::uint32_t> number() {
    if (bytes_.size() - at_ < sizeof(std::uint32_t)) return std::nullopt;
    std::uint32_t value = 0;
    for (std::size_t i = sizeof(value); i-- > 0;) value = value << 8U | bytes_[at_ + i];
    at_ += sizeof(value);
    return value;
  }

  std::optional<std::string> text() {
    const auto size = number();
    if (!size || bytes_.size() - at_ < *size) return std::nullopt;
    const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
    at_ += *size;
    return std::string(begin, begin + static_cast<std::ptrdiff_t>(*size));
  }

  /// std_msgs/Header.
  std::optional<Origin> header() {
    constexpr std::uint32_t kNanoseconds = 1000000000;
    const auto sequence = number();
    const auto seconds = number();
    const auto nanoseconds = number();
    const auto frame = text();
    if (!sequence || !seconds || !frame || *nanoseconds >= kNanoseconds) return std::nullopt;
    return Origin{ros::Time(*seconds, *nanoseconds), *frame};
  }

 private:
  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string withoutSlash(const std::string& name) {
  return name.substr(std::min(name.find_first_not_of('/'), name.size()));
}

StoredMessage load(const rosbag::MessageInstance& message) {
  StoredMessage stored{withoutSlash(message.getTopic()),
                       message.getDataType(),
                       message.getMD5Sum(),
                       message.getTime(),
                       {}};
  const std::uint32_t size = message.size();
  if (size > kMostBytes)
    throw rosbag::BagFormatException("a message of " + std::to_string(size) + " bytes");
  stored.bytes.resize(size);
  ros::serialization::OStream stream(stored.bytes.data(),
                                     static_cast<std::uint32_t>(stored.bytes.size()));
  message.write(stream);
  return stored;
}

std::optional<StoredMessage> tryLoad(const rosbag::MessageInstance& message) try {
  return load(message);
} catch (const std::exception&) {  // of rosbag, and of what decompresses
  return std::nullopt;
}

StampLayout stampLayout(const std::string& type, const std::string& definition) {
  if (type == "tf2_msgs/TFMessage" || type == "tf/tfMessage") return StampLayout::kTransforms;
  std::istringstream lines(definition);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string field;
    std::string name;
    words >> field >> name;
    const bool is_constant = line.substr(0, line.find('#')).find('=') != std::string::npos;
    if (field.empty() || is_constant) continue;
    const bool is_header = field == "Header" || field == "std_msgs/Header";
    return is_header && !name.empty() ? StampLayout::kHeader : StampLayout::kNone;
  }
  return StampLayout::kNone;
}

std::optional<Origin> originOf(const StoredMessage& message, StampLayout layout) {
  ByteReader reader(message.bytes);
  if (layout == StampLayout::kNone) return std::nullopt;
  if (layout == StampLayout::kHeader) return reader.header();
  const auto transforms = reader.number();
  if (!transforms || *transforms == 0) return std::nullopt;
  auto origin = reader.header();
  const auto child = origin ? reader.text() : std::nullopt;
  if (!child) return std::nullopt;
  origin->frame = *child;
  return origin;
}

}  // namespace place_memory::tools
