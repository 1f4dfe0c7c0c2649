#include "node/scan/turn_words.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace place_memory::node {
namespace {

constexpr double kTurned = 0.02;  // [rad]; less is noise

// Which of two signs is wrong, as far as the compass can tell.
std::string whichSign(const core::BaseWatch& base, const TurnSources& sources) {
  const std::string command = "swap the sign of angular.z in the base's driver";
  if (sources.yaw_is_compass) return command + ", or of the compass";
  if (!sources.compass || std::abs(*sources.compass) < kTurned) {
    return command + ", or of odometry's yaw";
  }
  const bool as_sent = (*sources.compass > 0.0) == (base.highestSent() > 0.0);
  return as_sent ? "the compass turned as was sent: swap the sign of odometry's yaw"
                 : command + "; the compass turned as odometry did";
}

}  // namespace

std::string sentAndTurned(const core::BaseWatch& base, const TurnSources& sources) {
  if (base.highestSent() == 0.0) return {};
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << "up to " << base.highestSent()
       << " rad/s were sent on " << sources.command_topic << " for " << std::setprecision(1)
       << base.seconds() << " s, " << std::setprecision(2) << base.sentWay() << " rad in all, and "
       << sources.yaw << " turned by " << std::max(base.turnedWay(), std::abs(base.turned()))
       << " rad";
  return text.str();
}

std::string faultInWords(const core::BaseWatch& base, const TurnSources& sources) {
  const std::string facts = sentAndTurned(base, sources);
  if (base.fault() == core::BaseWatch::Fault::kOtherWay) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(2)
         << "the robot was stopped, it turns the other way: " << facts << ", to " << base.turned()
         << ": " << whichSign(base, sources);
    return text.str();
  }
  if (!sources.listened) {
    return "the robot does not turn: nothing listens to " + sources.command_topic +
           ": does the base's driver run, and is that its topic of velocity commands?";
  }
  const bool moves = sources.compass && std::abs(*sources.compass) > 0.1;
  return "the robot does not turn: " + facts + ": " +
         (moves ? "but the compass turned; does the base publish odometry, and count its wheels?"
                : "is the base switched on, does its driver obey that topic, and is it free to "
                  "move? A base that needs a higher rate: scan/turn_rate");
}

}  // namespace place_memory::node
