#ifndef PLACE_MEMORY_NODE_INPUT_RAW_MESSAGE_H
#define PLACE_MEMORY_NODE_INPUT_RAW_MESSAGE_H

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <boost/make_shared.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "node/input/message_lengths.h"

namespace place_memory::node {

/// A message of whatever type its publisher has, not yet read: what to subscribe where a topic may
/// carry several types. It is read as a rosbag::MessageInstance is.
class RawMessage {
 public:
  using ConstPtr = boost::shared_ptr<const RawMessage>;

  const std::string& getDataType() const { return type_; }

  /// Nothing where it is of another definition. Throws what readContent() throws.
  template <class Content>
  boost::shared_ptr<Content> instantiate() const {
    if (md5sum_ != ros::message_traits::MD5Sum<Content>::value()) return nullptr;
    auto content = boost::make_shared<Content>();
    readContent(bytes_, *content);
    return content;
  }

  void describe(const std::string& type, const std::string& md5sum) {
    type_ = type;
    md5sum_ = md5sum;
  }
  void fill(const std::uint8_t* begin, std::uint32_t size) { bytes_.assign(begin, begin + size); }

 private:
  std::string type_;
  std::string md5sum_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace place_memory::node

namespace ros {
namespace message_traits {

template <>
struct IsMessage<place_memory::node::RawMessage> : TrueType {};

template <>
struct MD5Sum<place_memory::node::RawMessage> {
  static const char* value() { return "*"; }  // of every type
  static const char* value(const place_memory::node::RawMessage& /*message*/) { return "*"; }
};

template <>
struct DataType<place_memory::node::RawMessage> {
  static const char* value() { return "*"; }
  static const char* value(const place_memory::node::RawMessage& /*message*/) { return "*"; }
};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<place_memory::node::RawMessage> {
  template <class Stream>
  static void read(Stream& stream, place_memory::node::RawMessage& message) {
    message.fill(stream.getData(), stream.getLength());
  }
};

template <>
struct PreDeserialize<place_memory::node::RawMessage> {
  static void notify(const PreDeserializeParams<place_memory::node::RawMessage>& params) {
    params.message->describe((*params.connection_header)["type"],
                             (*params.connection_header)["md5sum"]);
  }
};

}  // namespace serialization
}  // namespace ros

#endif  // PLACE_MEMORY_NODE_INPUT_RAW_MESSAGE_H
