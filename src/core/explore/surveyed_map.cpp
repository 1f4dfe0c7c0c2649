#include "core/explore/surveyed_map.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

namespace place_memory::core {
namespace {

constexpr PlaceId kNewest = -1;          // no place has this id
constexpr double kReachesBack = 4.0;     // way of which readings are kept [m]
constexpr double kNewSpot = 0.1;         // [m]
constexpr double kNewHeading = 0.2;      // [rad]
constexpr std::size_t kMostAtSpot = 24;  // readings
constexpr double kHangsOn = 5.0;         // on a place that is not further off [m]
constexpr double kMoved = 0.08;          // by less a place does not move what hangs on it [m]
constexpr double kTurned = 0.03;         // [rad]
constexpr double kStands = 0.2;          // of the robot, to the side [m]

}  // namespace

SurveyedMap::SurveyedMap(const FusedMapOptions& options, const GridGeometry& geometry,
                         const SonarModelOptions& sonar, FusedMap::GridOf grid_of)
    : geometry_(geometry),
      sonar_(sonar),
      fused_(options, geometry, std::move(grid_of)),
      walls_(fused_.resolution()) {}

void SurveyedMap::add(const Place& place, std::shared_ptr<const EvidenceGrid> grid) {
  fused_.add(place, std::move(grid));
  moveTo(place.id, place.map_from_place);
}

void SurveyedMap::apply(const MapChange& change) {
  fused_.apply(change);
  for (const MapEdit& edit : change.edits) {
    if (const auto* added = std::get_if<PlaceAdded>(&edit)) {
      moveTo(added->place.id, added->place.map_from_place);
    } else if (const auto* moved = std::get_if<PlaceMoved>(&edit)) {
      moveTo(moved->id, moved->map_from_place);
    } else if (const auto* removed = std::get_if<PlaceRemoved>(&edit)) {
      loosen(removed->id);
    } else if (std::get_if<MapCleared>(&edit)) {
      poses_.clear();
      stations_.clear();
      walls_.clear();
    }
  }
}

void SurveyedMap::moveTo(PlaceId id, const Pose2d& map_from_place) {
  const auto [laid, is_new] = poses_.emplace(id, map_from_place);
  const Pose2d motion = laid->second.inverse() * map_from_place;
  if (is_new || (std::hypot(motion.x, motion.y) < kMoved && std::abs(motion.yaw) < kTurned)) return;
  laid->second = map_from_place;
  moved_ = true;
}

Pose2d SurveyedMap::placePose(PlaceId id) const {
  const auto found = poses_.find(id);
  return found == poses_.end() ? Pose2d{} : found->second;
}

PlaceId SurveyedMap::nearest(const Pose2d& spot) const {
  PlaceId nearest = kNoPlace;
  double least = kHangsOn;
  for (const auto& [id, pose] : poses_) {
    const double distance = std::hypot(pose.x - spot.x, pose.y - spot.y);
    if (distance >= least) continue;
    least = distance;
    nearest = id;
  }
  return nearest;
}

// What hung on a place that goes hangs on the next one.
void SurveyedMap::loosen(PlaceId id) {
  const Pose2d pose = placePose(id);
  poses_.erase(id);
  for (Anchored& station : stations_) {
    if (station.place != id) continue;
    const Pose2d spot = pose * station.place_from_base;
    station.place = nearest(spot);
    station.place_from_base = placePose(station.place).inverse() * spot;
  }
}

void SurveyedMap::restart() {
  newest_.clear();
  anchored_of_newest_ = 0;
  fused_.apply({0, std::chrono::nanoseconds(0), {PlaceRemoved{kNewest}}});
}

void SurveyedMap::hear(const Pose2d& odom_from_base, const SonarReading& reading) {
  bool is_new = newest_.empty();
  double way = 0.0;
  if (!is_new) {
    const Pose2d motion = newest_.back().odom_from_base.inverse() * odom_from_base;
    const double step = std::hypot(motion.x, motion.y);
    is_new = step > kNewSpot || std::abs(motion.yaw) > kNewHeading;
    way = newest_.back().way + step;
  }
  if (is_new) newest_.push_back({odom_from_base, way, {}});
  std::vector<SonarReading>& readings = newest_.back().readings;
  if (readings.size() >= kMostAtSpot) readings.erase(readings.begin());
  SonarReading in_station = reading;
  in_station.sensor_pose =
      newest_.back().odom_from_base.inverse() * odom_from_base * reading.sensor_pose;
  readings.push_back(in_station);
}

void SurveyedMap::layNewest(const Pose2d& map_from_odom) {
  const Pose2d newest = newest_.back().odom_from_base;
  EvidenceGrid grid(geometry_);
  for (const Station& station : newest_) {
    const Pose2d newest_from_station = newest.inverse() * station.odom_from_base;
    for (SonarReading reading : station.readings) {
      reading.sensor_pose = newest_from_station * reading.sensor_pose;
      sonar_.add(reading, grid);
    }
  }
  Place place;
  place.id = kNewest;
  place.session = kFirstSession;
  place.map_from_place = map_from_odom * newest;
  fused_.add(place, std::make_shared<const EvidenceGrid>(grid));
}

void SurveyedMap::layWalls(const Anchored& station) {
  const Pose2d base = placePose(station.place) * station.place_from_base;
  for (const SonarReading& reading : station.readings) {
    walls_.add(base * reading.sensor_pose, reading.spec, reading.range);
  }
  walls_.clearAround(base.x, base.y, kStands);
}

// The newest station may hear more yet.
void SurveyedMap::anchor(const Pose2d& map_from_odom) {
  for (; anchored_of_newest_ + 1 < newest_.size(); ++anchored_of_newest_) {
    const Station& station = newest_[anchored_of_newest_];
    const Pose2d spot = map_from_odom * station.odom_from_base;
    Anchored anchored;
    anchored.place = nearest(spot);
    anchored.place_from_base = placePose(anchored.place).inverse() * spot;
    anchored.readings = station.readings;
    if (!moved_) layWalls(anchored);
    stations_.push_back(std::move(anchored));
  }
  while (anchored_of_newest_ > 0 && newest_.front().way < newest_.back().way - kReachesBack) {
    newest_.pop_front();
    --anchored_of_newest_;
  }
  if (!moved_) return;
  moved_ = false;
  walls_.clear();
  for (const Anchored& station : stations_) layWalls(station);
}

SurveyedCells SurveyedMap::cells(const Pose2d& map_from_odom) {
  if (!newest_.empty()) layNewest(map_from_odom);
  anchor(map_from_odom);
  fused_.update();
  SurveyedCells survey{fused_.cells(), {}};
  for (const Anchored& station : stations_) {
    survey.trail.push_back(placePose(station.place) * station.place_from_base);
  }
  FusedCells& cells = survey.cells;
  std::size_t at = 0;
  for (int row = 0; row < cells.rows; ++row) {
    for (int column = 0; column < cells.columns; ++column, ++at) {
      const double x = cells.left + (column + 0.5) * cells.resolution;
      const double y = cells.bottom + (row + 0.5) * cells.resolution;
      if (walls_.isWall(x, y)) cells.evidence[at] = EvidenceGrid::kLimit;
    }
  }
  return survey;
}

}  // namespace place_memory::core
