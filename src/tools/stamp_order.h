#ifndef PLACE_MEMORY_TOOLS_STAMP_ORDER_H
#define PLACE_MEMORY_TOOLS_STAMP_ORDER_H

#include <ros/time.h>
#include <rosbag/view.h>

#include <cstddef>
#include <map>
#include <memory>
#include <queue>
#include <string>
#include <vector>

#include "tools/bag_clock.h"
#include "tools/stored_message.h"

namespace place_memory::tools {

/// A message and when it counts as received, by the robot's clock: at its stamp; where that cannot
/// be right, or its sensor's clock is wrong, when it was recorded.
struct TimedMessage {
  ros::Time time;
  std::shared_ptr<const StoredMessage> message;
  bool trusted = false;  ///< by its stamp
};

/// The messages of one bag by rising time. Of a bag that was recorded late, as over a slow network,
/// so much is held as is recorded within BagClock::lateness.
class StampOrder {
 public:
  /// Of the messages that came from `start` to `end`. All but the times must outlive this.
  StampOrder(const rosbag::Bag& bag, const std::vector<std::string>& topics, const BagClock& clock,
             const std::map<std::string, StampLayout>& layouts, const ros::Time& start,
             const ros::Time& end);

  /// The next one, which stays until it is taken; null: there is no more. Throws std::exception
  /// where the bag is damaged.
  const TimedMessage* peek();
  TimedMessage take();

 private:
  struct Waiting {
    TimedMessage timed;
    std::size_t number = 0;  // of equal times what was recorded first comes first

    bool operator<(const Waiting& other) const {
      return timed.time == other.timed.time ? number > other.number : timed.time > other.timed.time;
    }
  };

  void readAhead();
  TimedMessage timed(const rosbag::MessageInstance& instance);
  bool inOrder(const StoredMessage& message, const Origin& origin);

  const BagClock& clock_;
  const std::map<std::string, StampLayout>& layouts_;
  std::unique_ptr<rosbag::View> view_;
  rosbag::View::iterator at_;
  ros::Time start_;
  ros::Time end_;
  std::priority_queue<Waiting> waiting_;
  std::size_t number_ = 0;
  std::map<InputName, ros::Time> newest_;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_STAMP_ORDER_H
