#include "node/drive/drive_diagnostics.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

#include <string>

#include "node/drive/drive_publisher.h"

namespace place_memory::node {

void diagnoseDrive(const MapDriver::Health& health,
                   diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const std::string mode = std::string("mode ") + nameOf(health.mode);
  const std::string left_out = inWords(health.losses.rejected);
  if (!health.keep_problem.empty()) {
    status.summary(DiagnosticStatus::ERROR, "the map cannot be kept: " + health.keep_problem);
  } else if (health.losses.readings == 0 && !left_out.empty()) {
    status.summary(DiagnosticStatus::WARN,
                   mode + ", but no reading could be used yet: " + left_out +
                       (health.losses.problem.empty() ? "" : "; " + health.losses.problem));
  } else {
    status.summary(DiagnosticStatus::OK, mode);
  }
  status.add("mode", nameOf(health.mode));
  if (health.mode == config::Mode::kOff) return;
  status.add("p_lost", health.lost);
  status.add("readings used", health.losses.readings);
  for (std::size_t i = 0; i < kRejects; ++i) {
    if (health.losses.rejected[i] == 0) continue;
    status.add(std::string("readings left out: ") + toString(static_cast<Reject>(i)),
               health.losses.rejected[i]);
  }
  status.add("waiting", health.waiting);
  if (!health.losses.problem.empty()) status.add("newest problem", health.losses.problem);
}

}  // namespace place_memory::node
