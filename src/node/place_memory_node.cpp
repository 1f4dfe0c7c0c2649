#include "node/place_memory_node.h"

#include <ros/console.h>

#include "config/memory_options.h"
#include "node/map/memory_diagnostics.h"
#include "node/scan/sonar_diagnostics.h"

namespace place_memory::node {
namespace {

const ros::WallDuration kDiagnosticsPeriod(1.0);
constexpr int kTicksBetweenWarnings = 10;

}  // namespace

PlaceMemoryNode::PlaceMemoryNode(const ros::NodeHandle& names, const ros::NodeHandle& private_names,
                                 const config::Parameters& parameters)
    : names_(names),
      private_names_(private_names),
      parameters_(parameters),
      memory_(openMemory()),
      publisher_(private_names_, *memory_, parameters_),
      listener_(buffer_, names_),
      scan_server_(names_, private_names_, parameters_, buffer_, scanCallbacks()),
      services_(private_names_, {*memory_, publisher_, scan_, parameters_, store_problem_}),
      diagnostics_(names_, private_names_) {
  diagnostics_.setHardwareID("none");
  diagnostics_.add("memory", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    diagnoseMemory(*memory_, parameters_.store, store_problem_, status);
  });
  diagnostics_.add("sensors", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
    diagnoseSonars(scan_server_.health(), ros::Time::now(), status);
  });
  // Forced, because the updater's own pace is that of simulated time, which may stand still.
  diagnostics_timer_ = names_.createSteadyTimer(
      kDiagnosticsPeriod, [this](const ros::SteadyTimerEvent&) { onDiagnosticsTimer(); });
}

void PlaceMemoryNode::onDiagnosticsTimer() {
  diagnostics_.force_update();
  if (ros::Time::isValid()) return;
  if (ticks_without_time_++ % kTicksBetweenWarnings == 0) {
    ROS_WARN("Waiting for simulated time on /clock");  // throttled logging needs a time itself
  }
}

void PlaceMemoryNode::stop() { scan_server_.stop(); }

std::unique_ptr<core::PlaceMemory> PlaceMemoryNode::openMemory() {
  core::PlaceMemoryOptions options = config::memoryOptions(parameters_);
  options.opening.progress = [](const std::string& sentence) { ROS_INFO("%s", sentence.c_str()); };
  try {
    auto memory = std::make_unique<core::PlaceMemory>(options);
    ROS_INFO("%zu places are known", memory->size());
    return memory;
  } catch (const core::StoreError& error) {
    store_problem_ = error.what();
    ROS_ERROR("Places are kept in memory only: %s", error.what());
  }
  options.store_path.clear();
  return std::make_unique<core::PlaceMemory>(options);
}

ScanServer::Callbacks PlaceMemoryNode::scanCallbacks() {
  ScanServer::Callbacks callbacks;
  callbacks.finished = [this](std::shared_ptr<const core::Scan> scan) {
    publisher_.publishScan(*scan);
    scan_.set(std::move(scan));
  };
  callbacks.partial = [this](const core::Scan& scan) { publisher_.publishScan(scan); };
  callbacks.time_jump = [this] { dropScan(); };
  return callbacks;
}

void PlaceMemoryNode::dropScan() {
  scan_.drop();
  memory_->forgetWhereabouts();
  ROS_WARN("The newest scan is dropped, and the next place will be linked to none");
}

}  // namespace place_memory::node
