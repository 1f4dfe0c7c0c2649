#ifndef PLACE_MEMORY_NODE_INPUT_MESSAGE_LENGTHS_H
#define PLACE_MEMORY_NODE_INPUT_MESSAGE_LENGTHS_H

#include <ros/serialization.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace place_memory::node {

/// Goes over what a message is made of, and notices where its lists say they are longer than it is:
/// roscpp makes room for a list before it looks, some gigabytes for a message of forty bytes.
class LengthCheck {
 public:
  explicit LengthCheck(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  bool check(const sensor_msgs::LaserScan* type);
  bool check(const sensor_msgs::PointCloud* type);
  bool check(const sensor_msgs::PointCloud2* type);
  bool check(const tf2_msgs::TFMessage* type);
  /// Texts and single numbers alone: those roscpp looks after.
  bool check(const void* /*type*/) const { return true; }

 private:
  void skip(std::uint64_t size);
  std::uint32_t number();
  void text();
  void header();
  /// Of elements of that size.
  void list(std::uint64_t size);

  const std::vector<std::uint8_t>& bytes_;
  std::size_t at_ = 0;
  bool good_ = true;
};

/// The message that the bytes are, of a type that has a field. Throws
/// ros::serialization::StreamOverrunException where they are cut short, or a list in them says it
/// is longer.
template <class Content>
void readContent(const std::vector<std::uint8_t>& bytes, Content& content) {
  // Of nothing there is no address from which roscpp could read on.
  if (bytes.empty()) throw ros::serialization::StreamOverrunException("it is empty");
  if (!LengthCheck(bytes).check(static_cast<const Content*>(nullptr))) {
    throw ros::serialization::StreamOverrunException("a list in it is longer than the message");
  }
  // The stream reads alone, whatever its type says.
  ros::serialization::IStream stream(const_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::deserialize(stream, content);
}

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_INPUT_MESSAGE_LENGTHS_H
