#ifndef PLACE_MEMORY_NODE_SCAN_COMPASS_OFFSET_H
#define PLACE_MEMORY_NODE_SCAN_COMPASS_OFFSET_H

#include <ros/time.h>

#include <deque>
#include <functional>
#include <optional>

namespace place_memory::node {

/// By how much the compass reads more than odometry's yaw, over one scan. Headings whose odometry
/// is not there yet wait for it.
class CompassOffset {
 public:
  /// Yaw of the base in odometry's frame at a stamp, where it is known [rad].
  using YawAt = std::function<std::optional<double>(const ros::Time& stamp)>;

  /// Waits until `deadline` at the latest.
  void add(const ros::Time& stamp, const ros::Time& deadline, double heading);
  void process(const ros::Time& now, const YawAt& yaw_at);
  void clearWaiting() { waiting_.clear(); }

  /// [rad]; nothing before a heading could be used.
  std::optional<double> mean() const;

 private:
  struct Waiting {
    ros::Time stamp;
    ros::Time deadline;
    double heading;
  };

  std::deque<Waiting> waiting_;
  double sum_sin_ = 0.0;
  double sum_cos_ = 0.0;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_COMPASS_OFFSET_H
