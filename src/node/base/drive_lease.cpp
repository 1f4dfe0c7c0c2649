#include "node/base/drive_lease.h"

#include <geometry_msgs/Twist.h>

#include "node/names/node_names.h"

namespace place_memory::node {

DriveLease::Hold::~Hold() {
  stop();
  lease_.give();
}

void DriveLease::Hold::drive(double forward, double turn) {
  moves_ = true;
  geometry_msgs::Twist twist;
  twist.linear.x = forward;
  twist.angular.z = turn;
  lease_.publisher_.publish(twist);
}

void DriveLease::Hold::stop() {
  if (!moves_) return;
  drive(0.0, 0.0);
  moves_ = false;
}

DriveLease::DriveLease(const ros::NodeHandle& names)
    : topic_(names.resolveName(kCommandTopic)),
      publisher_(ros::NodeHandle(names).advertise<geometry_msgs::Twist>(kCommandTopic, 1)) {}

std::unique_ptr<DriveLease::Hold> DriveLease::take(const std::string& who, std::string& refusal) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!holder_.empty()) {
    refusal = holder_ + " moves the robot now: wait until that is over, or cancel it";
    return nullptr;
  }
  holder_ = who;
  return std::make_unique<Hold>(*this);
}

void DriveLease::give() {
  const std::lock_guard<std::mutex> lock(mutex_);
  holder_.clear();
}

}  // namespace place_memory::node
