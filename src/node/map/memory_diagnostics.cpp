#include "node/map/memory_diagnostics.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

namespace place_memory::node {

void diagnoseMemory(std::size_t places, const core::StoreHealth& health,
                    const std::string& store_path, const std::string& store_problem,
                    diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  const std::string count = std::to_string(places) + (places == 1 ? " place" : " places");
  if (!store_problem.empty()) {
    status.summary(DiagnosticStatus::ERROR, "places are kept in memory only: " + store_problem);
  } else if (!health.ok) {
    status.summary(DiagnosticStatus::ERROR,
                   "the map cannot be changed, the last change was refused: " + health.problem +
                       "; once that is mended, ask for the change again");
  } else if (!health.set_aside.empty()) {
    status.summary(DiagnosticStatus::WARN,
                   count + "; damaged in the store, and left out: " + health.set_aside.front());
  } else {
    status.summary(DiagnosticStatus::OK, count);
  }
  for (const std::string& sentence : health.set_aside) status.add("left out", sentence);
  status.add("places", places);
  status.add("store", store_path.empty() ? "in memory only" : store_path);
}

}  // namespace place_memory::node
