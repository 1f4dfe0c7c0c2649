#include "node/input/reject.h"

#include <algorithm>

namespace place_memory::node {
namespace {

struct Words {
  const char* reason;
  const char* advice;
};

constexpr std::array<Words, kRejects> kWords = {{
    {"range is NaN", "the driver measures nothing: look at the sensor and its wiring"},
    {"too close", "something is nearer than its min_range: is it covered, or blocked?"},
    {"below min_range", "are its ranges in metres, and is its min_range right?"},
    {"above max_range",
     "are its ranges in metres? scan/over_range_is_no_echo takes them as no echo"},
    {"fixed distance", "its min_range is its max_range: it may only say +inf or -inf (REP 117)"},
    {"bad sensor", "mend what its driver says of the sensor"},
    {"no stamp", "its driver must fill in header.stamp"},
    {"old stamp", "is the clock right where they are stamped?"},
    {"mount unknown", "it has heard no echo yet: say in cloud/mounts where it looks"},
    {"looks up or down", "is its frame mounted right? its x axis is where it looks"},
    {"no transform",
     "publish where it is mounted: robot_state_publisher or static_transform_publisher"},
    {"no odometry", "is odometry published on tf, and its clock right?"},
    {"no heading", "is the compass published?"},
    {"scan is full", "ask for fewer headings"},
}};

const Words& wordsOf(Reject reject) { return kWords.at(static_cast<std::size_t>(reject)); }

}  // namespace

const char* toString(Reject reject) { return wordsOf(reject).reason; }

const char* adviceOn(Reject reject) { return wordsOf(reject).advice; }

Reject mostFrequent(const RejectCounts& rejected) {
  const auto most = std::max_element(rejected.begin(), rejected.end());
  return static_cast<Reject>(most - rejected.begin());
}

std::string inWords(const RejectCounts& rejected) {
  std::string text;
  for (std::size_t i = 0; i < kRejects; ++i) {
    if (rejected[i] == 0) continue;
    if (!text.empty()) text += ", ";
    text += std::to_string(rejected[i]) + ' ' + toString(static_cast<Reject>(i));
  }
  return text;
}

}  // namespace place_memory::node
