#include "node/map/fused_map_publisher.h"

#include <diagnostic_msgs/DiagnosticStatus.h>
#include <nav_msgs/MapMetaData.h>
#include <ros/console.h>

#include <chrono>
#include <utility>

#include "config/memory_options.h"
#include "node/base/conversions.h"
#include "node/base/ros_time.h"
#include "node/map/fused_map_message.h"
#include "node/names/node_names.h"

namespace place_memory::node {
namespace {

std::chrono::nanoseconds pauseOf(const config::MapOptions& parameters) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(parameters.pause));
}

}  // namespace

FusedMapPublisher::FusedMapPublisher(const ros::NodeHandle& private_node, core::PlaceMemory& memory,
                                     const config::Parameters& parameters)
    : memory_(memory),
      parameters_(parameters),
      fused_(config::fusedMapOptions(parameters), parameters.grid,
             [this](core::PlaceId id) { return gridOf(id); }),
      spinner_(1, &queue_),
      task_(
          "The building's map is not published", [this] { publish(); }, pauseOf(parameters.map)) {
  ros::NodeHandle node(private_node);
  node.setCallbackQueue(&queue_);
  map_ = node.advertise<nav_msgs::OccupancyGrid>(kMapTopic, 1, true);
  metadata_ = node.advertise<nav_msgs::MapMetaData>(kMapMetadataTopic, 1, true);
  server_ = node.advertiseService(kStaticMapService, &FusedMapPublisher::answer, this);
  memory_.listen([this](const core::MapChange& change) { collect(change); });
  task_.request();
  spinner_.start();
}

FusedMapPublisher::~FusedMapPublisher() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopped_ = true;
  }
  published_.notify_all();
  spinner_.stop();
}

void FusedMapPublisher::collect(const core::MapChange& change) {
  if (!core::showsInFusedMap(change)) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    changes_.push_back(change);
  }
  task_.request();
}

std::shared_ptr<const core::EvidenceGrid> FusedMapPublisher::gridOf(core::PlaceId id) const {
  try {
    return std::make_shared<const core::EvidenceGrid>(memory_.grid(id));
  } catch (const core::PlaceMemoryError& error) {
    // One that is gone by now is none to speak of: its removal comes.
    if (error.reason() != core::PlaceMemoryError::Reason::kUnknownPlace) {
      ROS_WARN("Place %ld is not on the building's map: %s", static_cast<long>(id), error.what());
    }
    return nullptr;
  }
}

void FusedMapPublisher::follow() {
  if (!begun_) {
    begun_ = true;
    // Changes that came before are in it already: following them once more leads to the same end.
    for (const core::Place& place : memory_.map().places) fused_.add(place);
  }
  std::vector<core::MapChange> changes;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    changes.swap(changes_);
  }
  for (const core::MapChange& change : changes) fused_.apply(change);
  fused_.update();
}

void FusedMapPublisher::publish() {
  follow();
  const auto message = boost::make_shared<const nav_msgs::OccupancyGrid>(
      toMessage(fused_.cells(), parameters_.map, parameters_.sonar.prior,
                makeHeader(parameters_.map_frame, toRosTime(rosNow()))));
  map_.publish(message);
  metadata_.publish(message->info);
  warnOfLeftOut(fused_.leftOut());
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = message;
    left_out_ = fused_.leftOut();
  }
  published_.notify_all();
}

void FusedMapPublisher::warnOfLeftOut(std::size_t left_out) const {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (left_out == left_out_) return;
  }
  if (left_out == 0) {
    ROS_INFO("Every place is on the building's map");
  } else {
    ROS_WARN("%zu places lie too far off to be on the building's map: see map/max_cells", left_out);
  }
}

bool FusedMapPublisher::answer(nav_msgs::GetMap::Request& /*request*/,
                               nav_msgs::GetMap::Response& response) {
  std::unique_lock<std::mutex> lock(mutex_);
  published_.wait(lock, [this] { return newest_ != nullptr || stopped_; });
  const nav_msgs::OccupancyGridConstPtr newest = newest_;
  lock.unlock();
  if (newest) response.map = *newest;
  return newest != nullptr;
}

void FusedMapPublisher::diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const {
  using diagnostic_msgs::DiagnosticStatus;
  nav_msgs::OccupancyGridConstPtr newest;
  std::size_t left_out = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    newest = newest_;
    left_out = left_out_;
  }
  if (!newest) {
    status.summary(DiagnosticStatus::OK, "the building's map is being made");
    return;
  }
  const nav_msgs::MapMetaData& info = newest->info;
  if (left_out > 0) {
    status.summary(DiagnosticStatus::WARN,
                   std::to_string(left_out) +
                       " places lie too far off to be on the building's map: are they where they "
                       "belong? If so, raise map/max_cells or map/resolution");
  } else {
    const auto resolution = static_cast<double>(info.resolution);
    status.summaryf(DiagnosticStatus::OK, "%.1f m by %.1f m", info.width * resolution,
                    info.height * resolution);
  }
  status.add("cells", static_cast<std::size_t>(info.width) * info.height);
  status.add("resolution [m]", info.resolution);
  status.add("places left out", left_out);
}

}  // namespace place_memory::node
