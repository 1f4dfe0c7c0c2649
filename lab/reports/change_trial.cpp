#include "reports/change_trial.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "config/memory_options.h"
#include "core/sensing/moved_readings.h"
#include "core/sensing/scan_changes.h"
#include "place_memory/core/place_memory.h"
#include "place_memory/core/sonar_model.h"
#include "sim/scene/scene.h"
#include "sim/scene/world_changes.h"
#include "sim/scene/world_loader.h"
#include "sim/senses/simulated_scan.h"
#include "sim/world/random.h"

namespace place_memory::reports {
namespace {

using sim::Vec2;

// A sonar hears a smooth door from straight before it alone; so far, and so far aside for each
// metre before it.
constexpr double kDoorInSight = 1.5;  // [m]
constexpr double kAside = 0.45;
constexpr double kInSight = 3.0;    // of a door or a thing [m]
constexpr double kAtDoor = 0.2;     // from the middle of a change to the closed panel [m]
constexpr double kAtThing = 0.6;    // likewise [m]
constexpr double kExcused = 0.8;    // a change so near to what changed is no false one [m]
constexpr double kMoved = 0.3;      // things that moved by less were not moved [m]
constexpr double kMostShift = 0.5;  // of the robot from the place [m]
constexpr double kShort = 0.35;     // before it a line of sight ends [m]
constexpr double kDoorsFlipped = 0.3;
constexpr double kChairsMoved = 0.5;
constexpr double kChairDistance = 1.5;
constexpr double kFurnitureMoved = 0.1;

double distance(const Vec2& a, const Vec2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

Vec2 middleOf(const sim::Door& door) {
  return {0.5 * (door.hinge.x + door.latch.x), 0.5 * (door.hinge.y + door.latch.y)};
}

/// Of the panel where the door stands open.
Vec2 middleOfOpen(const sim::Door& door) {
  const double x = door.latch.x - door.hinge.x;
  const double y = door.latch.y - door.hinge.y;
  const double c = std::cos(door.swing);
  const double s = std::sin(door.swing);
  return {door.hinge.x + 0.5 * (c * x - s * y), door.hinge.y + 0.5 * (s * x + c * y)};
}

bool isStraightBefore(const sim::Door& door, const Vec2& eye) {
  const Vec2 middle = middleOf(door);
  const double length = distance(door.hinge, door.latch);
  const double along_x = (door.latch.x - door.hinge.x) / length;
  const double along_y = (door.latch.y - door.hinge.y) / length;
  const double aside = (eye.x - middle.x) * along_x + (eye.y - middle.y) * along_y;
  const double before = (eye.y - middle.y) * along_x - (eye.x - middle.x) * along_y;
  return std::abs(before) <= kDoorInSight && std::abs(aside) <= kAside * std::abs(before);
}

/// How far a spot lies from the panel of a closed door [m].
double fromClosedPanel(const sim::Door& door, const Vec2& spot) {
  const double x = door.latch.x - door.hinge.x;
  const double y = door.latch.y - door.hinge.y;
  const double along =
      ((spot.x - door.hinge.x) * x + (spot.y - door.hinge.y) * y) / (x * x + y * y);
  const double share = std::clamp(along, 0.0, 1.0);
  return distance(spot, {door.hinge.x + share * x, door.hinge.y + share * y});
}

/// Something that stood in one spot and stands in another.
struct Move {
  Vec2 from;
  Vec2 to;
};

template <class Thing>
void addMoves(const std::vector<Thing>& before, const std::vector<Thing>& after,
              std::vector<Move>& moves) {
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Move move{{before[i].pose.x, before[i].pose.y}, {after[i].pose.x, after[i].pose.y}};
    if (distance(move.from, move.to) >= kMoved) moves.push_back(move);
  }
}

/// The way from `eye` to a little before the spot is free.
bool isInSight(const sim::Scene& scene, const Vec2& eye, const Vec2& spot) {
  const double way = distance(eye, spot);
  if (way > kInSight || way < kShort) return false;
  const double share = (way - kShort) / way;
  const Vec2 end{eye.x + share * (spot.x - eye.x), eye.y + share * (spot.y - eye.y)};
  return scene.isPathFree(eye, end, 0.05);
}

/// The world before and after, and a memory of how it was.
class Trial {
 public:
  Trial(const sim::World& world, std::uint64_t seed, const config::Parameters& parameters,
        const core::GridChangeOptions& options)
      : rng_(seed),
        sonar_options_(parameters.sonar),
        sonar_(parameters.sonar),
        geometry_(parameters.grid),
        options_(options),
        memory_(optionsOf(parameters)),
        before_(world),
        after_(changed(world)),
        scene_before_(before_),
        scene_after_(after_) {
    addMoves(before_.chairs, after_.chairs, moves_);
    addMoves(before_.boxes, after_.boxes, moves_);
    addMoves(before_.tables, after_.tables, moves_);
  }

  ChangeScore run() {
    for (const sim::Place& place : before_.places) {
      core::Scan scan = scanAt(scene_before_, {place.position.x, place.position.y, 0.0});
      learned_[memory_.learn(scan, place.label, true).place.id] = scan.readings;
    }
    for (const sim::Place& place : before_.places) visit(place);
    return score_;
  }

 private:
  static core::PlaceMemoryOptions optionsOf(const config::Parameters& parameters) {
    core::PlaceMemoryOptions options = config::memoryOptions(parameters);
    options.store_path.clear();
    return options;
  }

  sim::World changed(const sim::World& world) {
    sim::World after = world;
    sim::flipDoors(after, kDoorsFlipped, rng_);
    sim::moveChairs(after, kChairsMoved, kChairDistance, rng_);
    sim::moveFurniture(after, kFurnitureMoved, 1.0, rng_);
    return after;
  }

  core::Scan scanAt(const sim::Scene& scene, const core::Pose2d& base) {
    core::Scan scan;
    scan.readings = sim::simulateScan(scene, base, 0.0, robot_, nullptr, rng_);
    scan.grid = sonar_.build(scan.readings, geometry_);
    scan.odom_from_scan = {base.x, base.y, 0.0};
    scan.end = std::chrono::seconds(++scans_);
    return scan;
  }

  void visit(const sim::Place& place) {
    const double bearing = sim::uniform(rng_, -core::kPi, core::kPi);
    const double shift = sim::uniform(rng_, 0.0, kMostShift);
    Vec2 eye{place.position.x + shift * std::cos(bearing),
             place.position.y + shift * std::sin(bearing)};
    if (!scene_after_.isPathFree(place.position, eye, sim::kPlaceClearance)) eye = place.position;
    const core::Scan scan = scanAt(scene_after_, {eye.x, eye.y, 0.0});
    const auto answer = memory_.recognize(scan, std::nullopt);
    if (answer.recognition.verdict != core::Verdict::kRecognized) return;
    if (answer.labels.front() != place.label) return;
    const core::PlaceMatch& match = answer.recognition.matches.front();
    const auto changes = core::changesBetween(
        learned_.at(match.id), core::movedReadings(scan.readings, match.place_from_scan),
        sonar_options_, geometry_, options_);
    ++score_.places;
    score_.changes += changes.size();
    judgeDoors(place, changes);
    judgeThings(place, changes);
    for (const core::GridChange& change : changes) {
      if (!isExcused(spotOf(place, change))) ++score_.false_changes;
    }
  }

  static Vec2 spotOf(const sim::Place& place, const core::GridChange& change) {
    return {place.position.x + change.x, place.position.y + change.y};
  }

  void judgeDoors(const sim::Place& place, const std::vector<core::GridChange>& changes) {
    for (std::size_t i = 0; i < before_.doors.size(); ++i) {
      const Vec2 door = middleOf(before_.doors[i]);
      if (!isStraightBefore(before_.doors[i], place.position)) continue;
      if (!isInSight(scene_before_, place.position, door) ||
          !isInSight(scene_after_, place.position, door)) {
        continue;
      }
      const bool was_open = before_.doors[i].open;
      const bool is_flipped = was_open != after_.doors[i].open;
      const bool says_flipped =
          std::any_of(changes.begin(), changes.end(), [&](const core::GridChange& change) {
            return change.appeared == was_open &&
                   fromClosedPanel(before_.doors[i], spotOf(place, change)) <= kAtDoor;
          });
      ++score_.doors;
      score_.doors_flipped += is_flipped ? 1 : 0;
      if (says_flipped != is_flipped) continue;
      ++score_.doors_right;
      score_.doors_flipped_right += is_flipped ? 1 : 0;
    }
  }

  void judgeThings(const sim::Place& place, const std::vector<core::GridChange>& changes) {
    const auto isReported = [&](const Vec2& spot, bool appeared) {
      return std::any_of(changes.begin(), changes.end(), [&](const core::GridChange& change) {
        return change.appeared == appeared && distance(spotOf(place, change), spot) <= kAtThing;
      });
    };
    for (const Move& move : moves_) {
      const bool left_in_sight = isInSight(scene_before_, place.position, move.from) &&
                                 isInSight(scene_after_, place.position, move.from);
      const bool came_in_sight = isInSight(scene_after_, place.position, move.to) &&
                                 isInSight(scene_before_, place.position, move.to);
      if (!left_in_sight && !came_in_sight) continue;
      ++score_.moved;
      if (isReported(move.from, false) || isReported(move.to, true)) ++score_.moved_seen;
    }
  }

  bool isExcused(const Vec2& spot) const {
    const auto isNear = [&spot](const Vec2& other) { return distance(spot, other) <= kExcused; };
    for (std::size_t i = 0; i < before_.doors.size(); ++i) {
      if (before_.doors[i].open == after_.doors[i].open) continue;
      if (isNear(middleOf(before_.doors[i])) || isNear(middleOfOpen(before_.doors[i]))) return true;
    }
    return std::any_of(moves_.begin(), moves_.end(),
                       [&](const Move& move) { return isNear(move.from) || isNear(move.to); });
  }

  sim::Rng rng_;
  sim::SimulatedRobot robot_;
  core::SonarModelOptions sonar_options_;
  core::SonarModel sonar_;
  core::GridGeometry geometry_;
  core::GridChangeOptions options_;
  core::PlaceMemory memory_;
  std::map<core::PlaceId, std::vector<core::SonarReading>> learned_;
  sim::World before_;
  sim::World after_;
  sim::Scene scene_before_;
  sim::Scene scene_after_;
  std::vector<Move> moves_;
  std::int64_t scans_ = 0;
  ChangeScore score_;
};

}  // namespace

void ChangeScore::add(const ChangeScore& other) {
  places += other.places;
  doors += other.doors;
  doors_right += other.doors_right;
  doors_flipped += other.doors_flipped;
  doors_flipped_right += other.doors_flipped_right;
  moved += other.moved;
  moved_seen += other.moved_seen;
  changes += other.changes;
  false_changes += other.false_changes;
}

ChangeScore tryChanges(const sim::World& world, std::uint64_t seed,
                       const config::Parameters& parameters,
                       const core::GridChangeOptions& options) {
  return Trial(world, seed, parameters, options).run();
}

}  // namespace place_memory::reports
