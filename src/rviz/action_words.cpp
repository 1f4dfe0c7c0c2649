#include "rviz/action_words.h"

#include <cmath>

#include "rviz/verdict_words.h"

namespace place_memory::panel {
namespace {

std::string joined(const std::string& first, const std::string& then) {
  if (first.empty() || then.empty()) return first + then;
  return first + "; " + then;
}

std::string rounded(double number) { return std::to_string(std::lround(number)); }

}  // namespace

GoalProgress progressOf(const ScanPlaceFeedback& feedback) {
  return {feedback.fraction, {}, feedback.message};
}

GoalProgress progressOf(const GoToPlaceFeedback& feedback) {
  const std::string words =
      feedback.leg.empty() ? feedback.message : joined(feedback.leg, feedback.message);
  if (!std::isfinite(feedback.time_left) || feedback.time_left < 0.0) return {{}, {}, words};
  const std::string left =
      counted(feedback.legs_left, "leg") + " and some " + rounded(feedback.time_left) + " s left";
  return {{}, feedback.time_left, joined(words, left)};
}

GoalProgress progressOf(const ExploreFeedback& feedback) {
  const std::string so_far = counted(feedback.places, "place") + " made, " +
                             counted(feedback.frontiers, "opening") + " to be seen";
  if (!std::isfinite(feedback.distance)) return {{}, {}, joined(feedback.message, so_far)};
  return {
      {}, {}, joined(feedback.message, so_far + ", " + rounded(feedback.distance) + " m driven")};
}

}  // namespace place_memory::panel
