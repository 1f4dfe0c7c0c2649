#include "node/map/memory_diagnostics.h"

#include <diagnostic_msgs/DiagnosticStatus.h>

namespace place_memory::node {

void diagnoseMemory(const core::PlaceMemory& memory, const std::string& store_path,
                    const std::string& store_problem,
                    diagnostic_updater::DiagnosticStatusWrapper& status) {
  using diagnostic_msgs::DiagnosticStatus;
  if (store_problem.empty()) {
    status.summary(DiagnosticStatus::OK, std::to_string(memory.size()) + " places");
  } else {
    status.summary(DiagnosticStatus::ERROR, "places are kept in memory only: " + store_problem);
  }
  status.add("store", store_path.empty() ? "in memory only" : store_path);
}

}  // namespace place_memory::node
