#include "tools/drive_reader.h"

#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "node/base/ros_time.h"
#include "node/drive/drive_moment.h"
#include "node/input/transform_filter.h"

namespace place_memory::tools {
namespace {

using std::chrono::nanoseconds;

/// Everything of the bags that a drive consists of.
class BagContents {
 public:
  BagContents(const BagSet& bags, BagScanner& scanner) : scanner_(scanner) {
    for (const auto& transform : scanner.staticTransforms()) {
      node::addTransform(transform, true, nanoseconds(0), mounts_);
    }
    bags.read(scanner.topics(), bags.first(), bags.last(),
              [this](const TimedMessage& timed) { take(timed); });
    std::stable_sort(moments.begin(), moments.end());
  }

  std::vector<node::DriveMoment> moments;
  node::DriveLosses losses;

 private:
  void take(const TimedMessage& timed) {
    const nanoseconds received = node::toNanoseconds(timed.time);
    if (const auto moved = timed.message->as<tf2_msgs::TFMessage>()) {
      for (const auto& transform : moved->transforms) {
        moments.push_back(node::momentOf(transform, received));
      }
      return;
    }
    for (node::DriveMoment& moment :
         node::momentsOf(scanner_.take(timed, mounts_), received, losses)) {
      moments.push_back(std::move(moment));
    }
  }

  BagScanner& scanner_;
  tf2::BufferCore mounts_;  // of compasses
};

}  // namespace

node::DriveLosses readDrive(const BagSet& bags, BagScanner& scanner,
                            const config::Parameters& parameters, node::DriveListener& listener) {
  if (parameters.odom_frame.empty()) {
    throw std::runtime_error(
        "a drive needs odometry, but odom_frame is empty: name the frame in which the robot's "
        "odometry gives " +
        parameters.base_frame);
  }
  BagContents contents(bags, scanner);
  node::DriveFeed feed(parameters, contents.losses, listener);
  for (const auto& transform : scanner.staticTransforms()) feed.addStatic(transform);
  for (const node::DriveMoment& moment : contents.moments) feed.take(moment);
  feed.end();
  return contents.losses;
}

}  // namespace place_memory::tools
