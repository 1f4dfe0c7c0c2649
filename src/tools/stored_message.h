#ifndef PLACE_MEMORY_TOOLS_STORED_MESSAGE_H
#define PLACE_MEMORY_TOOLS_STORED_MESSAGE_H

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <ros/time.h>
#include <rosbag/message_instance.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "node/input/message_lengths.h"

namespace place_memory::tools {

/// Names are the same with and without the slash: a bag has them resolved, parameters do not.
std::string withoutSlash(const std::string& name);

/// A message as a bag holds it.
struct StoredMessage {
  std::string topic;  ///< without its slash
  std::string type;   ///< as "sensor_msgs/Range"
  std::string md5sum;
  ros::Time recorded;  ///< by the recorder's clock
  std::vector<std::uint8_t> bytes;

  /// The message, or null where it is of another type: types are told apart by their definition,
  /// as tf/tfMessage has that of tf2_msgs/TFMessage. Throws ros::Exception where it is damaged.
  template <class Message>
  std::shared_ptr<Message> as() const {
    if (md5sum != ros::message_traits::MD5Sum<Message>::value()) return nullptr;
    auto message = std::make_shared<Message>();
    node::readContent(bytes, *message);
    return message;
  }
};

/// Throws std::exception where the bag is damaged there.
StoredMessage load(const rosbag::MessageInstance& message);
/// Nothing where the bag is damaged there.
std::optional<StoredMessage> tryLoad(const rosbag::MessageInstance& message);

/// Where messages of a type have their stamp.
enum class StampLayout {
  kNone,        ///< nowhere
  kHeader,      ///< in the header that they begin with
  kTransforms,  ///< in the header of the first transform of a list
};

/// Of a type by its name and its definition.
StampLayout stampLayout(const std::string& type, const std::string& definition);

/// What a message says of when and where it is from.
struct Origin {
  ros::Time stamp;
  std::string frame;  ///< of its header; of transforms that of the first child
};

/// Nothing where the message has no stamp, is empty, or is cut.
std::optional<Origin> originOf(const StoredMessage& message, StampLayout layout);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_STORED_MESSAGE_H
