#include "tools/bag_clock.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace place_memory::tools {
namespace {

// Between stamp and record lies as much on a robot whose recorder has the same clock.
constexpr double kLeastOffset = 0.2;

// A stamp lies at most so long after the message came, and before it.
constexpr double kMaxAhead = 1.0;
constexpr double kMaxLate = 10.0;

// An input whose stamps lie so far from those of the others has a clock of its own.
constexpr double kStray = 1.0;

// More frames than a robot has are no names of sensors.
constexpr std::size_t kMaxInputs = 1000;

// Messages are held up, never sent before their time: the clocks show in the least lags, those of
// this share, less what cannot be right.
constexpr double kPrompt = 0.1;

double promptLag(const QuantileSample& lags) {
  return lags.quantile(kPrompt, lags.quantile(0.5) - kMaxLate);
}

double median(const std::vector<double>& values) {
  QuantileSample sample;
  for (const double value : values) sample.add(value);
  return sample.quantile(0.5);
}

double lagOf(const ros::Time& stamp, const ros::Time& recorded) {
  return 1e-9 * static_cast<double>(static_cast<std::int64_t>(recorded.toNSec()) -
                                    static_cast<std::int64_t>(stamp.toNSec()));
}

}  // namespace

ros::Time later(const ros::Time& time, double seconds) {
  const auto step = static_cast<std::int64_t>(std::llround(seconds * 1e9));
  const auto first = static_cast<std::int64_t>(ros::TIME_MIN.toNSec());
  const auto last = static_cast<std::int64_t>(ros::TIME_MAX.toNSec());
  const auto sum = static_cast<std::int64_t>(time.toNSec()) + step;
  return ros::Time().fromNSec(static_cast<std::uint64_t>(std::clamp(sum, first, last)));
}

bool BagClock::credible(const ros::Time& stamp, const ros::Time& recorded) const {
  const double late = lagOf(stamp, recorded) - offset;
  return !stamp.isZero() && late >= -kMaxAhead && late <= kMaxLate;
}

void ClockMeasurement::note(const StoredMessage& message, const Origin& origin, bool rules) {
  const InputName name{message.topic, origin.frame};
  if (origin.stamp.isZero() || (inputs_.size() >= kMaxInputs && inputs_.count(name) == 0)) return;
  Input& input = inputs_[name];
  input.rules = rules;
  const double lag = lagOf(origin.stamp, message.recorded);
  input.lag.add(lag);
  const auto second = static_cast<std::int64_t>(std::floor(lag));
  Span& span = input.spans.emplace(second, Span{origin.stamp, origin.stamp}).first->second;
  span.first = std::min(span.first, origin.stamp);
  span.last = std::max(span.last, origin.stamp);
}

void ClockMeasurement::note(const ros::Time& recorded) {
  recorded_.first = std::min(recorded_.first, recorded);
  recorded_.last = std::max(recorded_.last, recorded);
}

// Neither a topic of many messages nor one of many sensors outweighs the others.
double ClockMeasurement::offset() const {
  std::map<std::string, std::vector<double>> of_topics;
  for (const auto& [name, input] : inputs_) {
    if (input.rules) of_topics[name.first].push_back(promptLag(input.lag));
  }
  std::vector<double> lags;
  for (const auto& [topic, of_inputs] : of_topics) lags.push_back(median(of_inputs));
  if (lags.empty()) return 0.0;
  const double offset = median(lags);
  return std::fabs(offset) < kLeastOffset ? 0.0 : offset;
}

BagClock ClockMeasurement::clock() const {
  BagClock clock;
  clock.offset = offset();
  clock.first = ros::TIME_MAX;
  for (const auto& [name, input] : inputs_) {
    const double stray = promptLag(input.lag) - clock.offset;
    if (std::fabs(stray) > kStray) {
      if (input.rules) clock.strays[name] = stray;
      continue;
    }
    for (const auto& [second, span] : input.spans) {
      const double late = static_cast<double>(second) - clock.offset;  // and up to a second more
      if (late + 1.0 <= -kMaxAhead || late > kMaxLate) continue;
      clock.first = std::min(clock.first, span.first);
      clock.last = std::max(clock.last, span.last);
      if (input.rules) clock.lateness = std::clamp(late + 1.0, clock.lateness, kMaxLate);
    }
  }
  if (clock.last < clock.first) {  // no stamps
    clock.first = clock.received(recorded_.first);
    clock.last = clock.received(recorded_.last);
  }
  return clock;
}

}  // namespace place_memory::tools
