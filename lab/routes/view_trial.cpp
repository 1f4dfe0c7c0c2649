#include "routes/view_trial.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/map/place_belief.h"
#include "core/mapping/scan_graph.h"
#include "core/recognize/recognizer.h"
#include "core/route/route_reach.h"
#include "core/views/pose_candidates.h"
#include "core/views/view_adviser.h"
#include "mapping/mapping_run.h"
#include "place_memory/core/sonar_model.h"
#include "sim/scene/scene.h"
#include "sim/scene/world_loader.h"
#include "sim/senses/simulated_scan.h"
#include "sim/world/random.h"

namespace place_memory::routes {
namespace {

using core::PlaceId;
using core::Pose2d;

constexpr double kSure = 0.9;
constexpr double kRight = 1.0;       // a spot so near is where the robot is [m]
constexpr double kRadius = 0.22;     // of the robot [m]
constexpr double kStep = 0.1;        // [m]
constexpr double kBeside = 0.4;      // it is put down so far from a place at most [m]
constexpr double kWheels = 0.03;     // of distances, error of odometry
constexpr double kMostTime = 120.0;  // of the ways that are thought of [s]

sim::Rng seeded(std::uint64_t seed, std::uint64_t purpose) {
  std::seed_seq sequence{seed, seed >> 32U, purpose, std::uint64_t{0x71e3}};
  return sim::Rng(sequence);
}

/// What a robot knows of a building: places, links and scans.
class KnownBuilding {
 public:
  KnownBuilding(const sim::World& world, std::uint64_t seed)
      : world_(world),
        scene_(world),
        options_(mapping::mapperOptions()),
        recognizer_(options_.recognizer),
        sonar_(options_.sonar),
        map_(mapOf(world)),
        graph_(core::LinkLearningOptions()) {
    graph_.build(map_);
    graph_.refresh(map_, {});
    sim::Rng rng = seeded(seed, 1);
    for (const core::Place& place : map_.places()) {
      const auto grid =
          std::make_shared<const core::EvidenceGrid>(scan(place.map_from_place, 0.0, rng).grid);
      grids_[place.id] = grid;
      index_.put(place.id, *grid);
      locator_.put(place.id, place.map_from_place);
    }
  }

  core::Scan scan(const Pose2d& base, double heading_error, sim::Rng& rng) const {
    core::Scan scan;
    scan.readings = sim::simulateScan(scene_, base, heading_error, robot_, nullptr, rng);
    scan.grid = sonar_.build(scan.readings, {});
    return scan;
  }

  core::Recognition recognize(const core::Scan& scan) const {
    const core::LookUpFrames frames = [this](const std::vector<PlaceId>& ids) {
      std::vector<core::PlaceFrame> found;
      for (const PlaceId id : ids) found.push_back({map_.find(id)->map_from_place, 1});
      return std::make_optional(std::move(found));
    };
    return *recognizer_.recognize(scan, index_, frames, options_.recognizer.heading_window);
  }

  core::PlaceBelief::Map beliefMap() const {
    core::PlaceBelief::Map map;
    map.places = map_.size();
    map.map_from_place = [this](PlaceId id) { return map_.find(id)->map_from_place; };
    map.sigma = [](double way) { return core::positionSigma(way, true); };
    map.near = [this](const Pose2d& pose, double radius) { return locator_.near(pose, radius); };
    return map;
  }

  core::ViewAdvice advise(const core::ViewQuestion& question) const {
    const core::ViewAdviser adviser(
        [this](PlaceId id) { return grids_.at(id); },
        [this](const core::PoseCandidate& candidate) {
          std::vector<core::ViewPoint> points;
          for (const core::ReachedPlace& reached :
               core::reachedFrom(graph_, candidate.place, kMostTime)) {
            points.push_back({reached.place, reached.before,
                              map_.find(reached.place)->map_from_place, reached.time});
          }
          return points;
        });
    return adviser.advise(question);
  }

  const core::PlaceMap& map() const { return map_; }
  const sim::Scene& scene() const { return scene_; }

 private:
  static core::PlaceMap mapOf(const sim::World& world) {
    std::vector<core::Place> places;
    std::vector<core::PlaceLink> links;
    const auto neighbours = sim::placeNeighbours(world);
    for (std::size_t i = 0; i < world.places.size(); ++i) {
      core::Place place;
      place.id = static_cast<PlaceId>(i + 1);
      place.label = world.places[i].label;
      place.map_from_place = {world.places[i].position.x, world.places[i].position.y, 0.0};
      places.push_back(place);
      for (const std::size_t other : neighbours[i]) {
        if (other <= i) continue;
        core::PlaceLink link;
        link.first = place.id;
        link.second = static_cast<PlaceId>(other + 1);
        const sim::Vec2& there = world.places[other].position;
        link.first_from_second = place.map_from_place.inverse() * Pose2d{there.x, there.y, 0.0};
        links.push_back(link);
      }
    }
    return {places, links, 0, std::chrono::nanoseconds(0)};
  }

  const sim::World world_;
  const sim::Scene scene_;
  const sim::SimulatedRobot robot_;
  const core::MapperOptions options_;
  const core::Recognizer recognizer_;
  const core::SonarModel sonar_;
  const core::PlaceMap map_;
  core::RouteGraph graph_;
  std::map<PlaceId, std::shared_ptr<const core::EvidenceGrid>> grids_;
  core::PlaceIndex index_;
  core::PlaceLocator locator_{1.5};
};

/// One robot that finds out where it is.
class LostRobot {
 public:
  LostRobot(KnownBuilding& building, const ViewTrialRecipe& recipe, std::uint64_t seed)
      : building_(building), belief_(core::PlaceBeliefOptions{}), rng_(seeded(seed, 2)) {
    error_ = sim::uniform(rng_, -recipe.compass_error, recipe.compass_error);
    const core::Place& start =
        building_.map().places()[sim::uniformIndex(rng_, building_.map().size())];
    base_ = start.map_from_place;
    base_.yaw = sim::uniform(rng_, -core::kPi, core::kPi);
    drive(Pose2d{sim::uniform(rng_, 0.0, kBeside), 0.0, 0.0});
    way_ = 0.0;
    moved_ = {};
    barred_ = 0;
  }

  void scan() {
    const core::PlaceBelief::Map map = building_.beliefMap();
    if (scans_++ > 0) belief_.predict(moved_, map);
    moved_ = {};
    const core::Recognition found = building_.recognize(building_.scan(base_, error_, rng_));
    std::vector<core::BeliefMatch> matches;
    double known = 0.0;
    const Pose2d scan_from_base{0.0, 0.0, core::wrapAngle(base_.yaw + error_)};
    for (const core::PlaceMatch& match : found.matches) {
      known += match.probability;
      matches.push_back({match.id, match.score, match.place_from_scan * scan_from_base});
    }
    belief_.measure(matches, known, 1.0, map);
  }

  bool isSure() const { return belief_.largest(building_.beliefMap()).mass >= kSure; }
  bool isRight() const {
    const Pose2d pose = poseAt(belief_.largest(building_.beliefMap()).place);
    return std::hypot(pose.x - base_.x, pose.y - base_.y) <= kRight;
  }

  /// Whether it went by advice.
  bool goOn(ViewPolicy policy) {
    if (policy == ViewPolicy::kAdvised) {
      const core::ViewAdvice advice = building_.advise(question());
      if (advice.view && !advice.view->spots.empty()) {
        drive(advice.view->spots.front());
        return true;
      }
    }
    const std::vector<core::PoseCandidate> candidates =
        core::mergedCandidates(question().candidates);
    if (candidates.empty()) return false;
    const core::PoseCandidate& likeliest = candidates.front();
    const std::vector<PlaceId> links = building_.map().neighbours(likeliest.place);
    if (links.empty()) return false;
    const PlaceId next = links[sim::uniformIndex(rng_, links.size())];
    drive(likeliest.map_from_base.inverse() * building_.map().find(next)->map_from_place);
    return false;
  }

  std::size_t scans() const { return scans_; }
  double way() const { return way_; }
  int barred() const { return barred_; }

 private:
  Pose2d poseAt(PlaceId id) const {
    const auto found = belief_.states().find(id);
    if (found == belief_.states().end()) return {1e9, 1e9, 0.0};
    return building_.map().find(id)->map_from_place * found->second.place_from_base;
  }

  core::ViewQuestion question() const {
    core::ViewQuestion question;
    question.sure = kSure;
    for (const auto& [id, state] : belief_.states()) {
      question.candidates.push_back({id, poseAt(id), state.mass});
    }
    // By rising id, so that what comes of equal ones does not depend on the order of a hash table.
    std::sort(question.candidates.begin(), question.candidates.end(),
              [](const auto& one, const auto& other) { return one.place < other.place; });
    return question;
  }

  /// Straight to a spot in its own frame, until something stands in the way.
  void drive(const Pose2d& spot) {
    const double length = std::hypot(spot.x, spot.y);
    const double turn = length > 0.0 ? std::atan2(spot.y, spot.x) : 0.0;
    base_.yaw = core::wrapAngle(base_.yaw + turn);
    double driven = 0.0;
    while (driven + kStep <= length) {
      const Pose2d next = base_ * Pose2d{kStep, 0.0, 0.0};
      if (!building_.scene().isPathFree({base_.x, base_.y}, {next.x, next.y}, kRadius)) {
        ++barred_;
        break;
      }
      base_ = next;
      driven += kStep;
    }
    way_ += driven;
    const double believed = driven * (1.0 + kWheels * sim::normal(rng_));
    moved_.motion = moved_.motion * Pose2d{0.0, 0.0, turn} * Pose2d{believed, 0.0, 0.0};
    moved_.way += driven;
  }

  KnownBuilding& building_;
  core::PlaceBelief belief_;
  sim::Rng rng_;
  double error_ = 0.0;  ///< of the compass [rad]
  Pose2d base_;
  core::BeliefMotion moved_;  ///< since the newest scan
  std::size_t scans_ = 0;
  double way_ = 0.0;
  int barred_ = 0;
};

}  // namespace

void ViewCounts::add(const ViewCounts& other) {
  starts += other.starts;
  unsure += other.unsure;
  certain += other.certain;
  wrong += other.wrong;
  scans += other.scans;
  way += other.way;
  advised += other.advised;
  barred += other.barred;
}

ViewCounts findOneself(const sim::World& world, ViewPolicy policy, const ViewTrialRecipe& recipe,
                       std::uint64_t seed) {
  KnownBuilding building(world, seed);
  ViewCounts counts;
  for (int i = 0; i < recipe.starts; ++i) {
    LostRobot robot(building, recipe, 1000 * seed + static_cast<std::uint64_t>(i));
    ++counts.starts;
    robot.scan();
    if (robot.isSure()) continue;
    ++counts.unsure;
    while (!robot.isSure() && robot.scans() < recipe.most_scans) {
      if (robot.goOn(policy)) ++counts.advised;
      robot.scan();
    }
    counts.scans += robot.scans();
    counts.way += robot.way();
    counts.barred += robot.barred();
    if (!robot.isSure()) continue;
    ++counts.certain;
    if (!robot.isRight()) ++counts.wrong;
  }
  return counts;
}

}  // namespace place_memory::routes
