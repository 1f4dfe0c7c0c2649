#include "node/scan/scan_goal.h"

namespace place_memory::node {
namespace {

constexpr std::uint32_t kMostHeadings = 3600;
constexpr double kLongest = 3600.0;  // [s]

}  // namespace

std::optional<ScanRequest> readGoal(const ScanPlaceGoal& goal, const config::ScanOptions& defaults,
                                    std::string& problem) {
  const double timeout = goal.timeout.toSec();
  if (goal.headings > kMostHeadings) {
    problem = "headings must be at most 3600, not " + std::to_string(goal.headings);
  } else if (goal.step != 0.0 && !(goal.step >= config::kLeastStep && goal.step <= core::kPi)) {
    problem = "step must be in [0.001, pi] rad, or 0, not " + std::to_string(goal.step);
  } else if (goal.turn > ScanPlaceGoal::TURN_CMD_VEL) {
    problem = "turn must be one of TURN_..., not " + std::to_string(goal.turn);
  } else if (!(timeout >= 0.0 && timeout <= kLongest)) {
    problem = "timeout must be in (0, 3600] s, or 0, not " + std::to_string(timeout);
  } else {
    ScanRequest request;
    request.headings = goal.headings == 0 ? defaults.headings : static_cast<int>(goal.headings);
    const double step = request.headings == 0 ? 0.0 : defaults.step;
    request.step = goal.step == 0.0 ? step : goal.step;
    request.timeout = timeout == 0.0 ? defaults.timeout : timeout;
    request.longer_if_needed = timeout == 0.0;
    request.turn = defaults.turn;
    if (goal.turn == ScanPlaceGoal::TURN_LISTEN) request.turn = config::Turn::kListen;
    if (goal.turn == ScanPlaceGoal::TURN_CMD_VEL) request.turn = config::Turn::kCmdVel;
    return request;
  }
  return std::nullopt;
}

std::vector<RejectCount> toMessage(const RejectCounts& rejected) {
  std::vector<RejectCount> messages;
  for (std::size_t i = 0; i < kRejects; ++i) {
    if (rejected[i] == 0) continue;
    RejectCount message;
    message.reason = toString(static_cast<Reject>(i));
    message.count = rejected[i];
    messages.push_back(message);
  }
  return messages;
}

}  // namespace place_memory::node
