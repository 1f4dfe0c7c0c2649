#include "node/go/goal_watch.h"

#include "node/base/ros_time.h"
#include "node/drive/drive_publisher.h"

namespace place_memory::node {
namespace {

constexpr double kClockPatience = 10.0;  // with simulated time that stands [s]

}  // namespace

void GoalWatch::begin(std::chrono::nanoseconds now, config::Mode mode) {
  clock_.observe(now, steadyNow());
  clock_.restart(steadyNow());
  time_jumped_ = false;
  mode_ = mode;
}

std::optional<GoalWatch::End> GoalWatch::update(std::chrono::nanoseconds now, config::Mode mode) {
  clock_.observe(now, steadyNow());
  if (time_jumped_.exchange(false)) {
    return End{Kind::kTimeJumped,
               "time ran backwards: where the robot is, is not known any more; send the goal again "
               "once it is"};
  }
  if (toSeconds(clock_.standing(steadyNow())) > kClockPatience) {
    return End{Kind::kTimeStands, "simulated time stands still: is anything published on /clock?"};
  }
  if (mode == mode_) return std::nullopt;
  return End{Kind::kModeChanged, std::string("the mode was set to ") + nameOf(mode) +
                                     " on the way: where the robot is, is told otherwise from now "
                                     "on; send the goal again"};
}

}  // namespace place_memory::node
