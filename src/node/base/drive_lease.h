#ifndef PLACE_MEMORY_NODE_BASE_DRIVE_LEASE_H
#define PLACE_MEMORY_NODE_BASE_DRIVE_LEASE_H

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include <memory>
#include <mutex>
#include <string>

namespace place_memory::node {

/// The one owner of cmd_vel: who wants to move the robot takes a hold on it, and while that is
/// there nobody else gets one. Thread-safe.
class DriveLease {
 public:
  /// The robot is its owner's to move. Ends, and the robot stands, when it is destroyed.
  class Hold {
   public:
    explicit Hold(DriveLease& lease) : lease_(lease) {}
    ~Hold();
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

    /// Publishes a velocity: forward [m/s], turn counter-clockwise [rad/s].
    void drive(double forward, double turn);
    /// Publishes a zero velocity where the newest one was another.
    void stop();

   private:
    DriveLease& lease_;
    bool moves_ = false;
  };

  explicit DriveLease(const ros::NodeHandle& names);

  /// `who`: for people, as "a scan that turns the robot". nullptr: somebody else moves the robot
  /// now, which `refusal` says in a sentence.
  std::unique_ptr<Hold> take(const std::string& who, std::string& refusal);

  bool isListenedTo() const { return publisher_.getNumSubscribers() > 0; }
  /// Where velocities go, for people.
  const std::string& topic() const { return topic_; }

 private:
  void give();

  const std::string topic_;
  ros::Publisher publisher_;
  std::mutex mutex_;
  std::string holder_;  // empty: nobody
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_BASE_DRIVE_LEASE_H
