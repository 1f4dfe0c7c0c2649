#include "reports/twin_trial.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/index/place_index.h"
#include "core/recognize/recognizer.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::reports {
namespace {

constexpr double kFarOff = 2.0;  // [m]

/// A map of what was learned, its ids from 1 on in that order.
struct LearnedMap {
  std::vector<core::Scan> scans;
  core::PlaceMap map;
  core::PlaceIndex index;
};

core::Scan scanOf(const std::vector<core::SonarReading>& readings, const core::SonarModel& sonar,
                  const core::GridGeometry& geometry) {
  core::Scan scan;
  scan.readings = readings;
  scan.grid = sonar.build(readings, geometry);
  return scan;
}

LearnedMap learn(const trials::TrialSet& set, const sim::World& world,
                 const core::SonarModel& sonar) {
  LearnedMap learned;
  std::vector<core::Place> places;
  for (const trials::LearnedScan& scan : set.learned) {
    core::Place place;
    place.id = static_cast<core::PlaceId>(places.size()) + 1;
    place.label = scan.label;
    place.map_from_place = scan.odom_from_scan;
    learned.scans.push_back(scanOf(scan.readings, sonar, {set.cell_size}));
    learned.index.put(place.id, learned.scans.back().grid);
    places.push_back(place);
  }
  std::vector<core::PlaceLink> links;
  const auto neighbours = sim::placeNeighbours(world);
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    for (const std::size_t other : neighbours[i]) {
      if (other <= i) continue;
      core::PlaceLink link;
      link.first = static_cast<core::PlaceId>(i) + 1;
      link.second = static_cast<core::PlaceId>(other) + 1;
      links.push_back(link);
    }
  }
  learned.map = core::PlaceMap(std::move(places), links, 1, {});
  return learned;
}

core::LookUpFrames framesOf(const core::PlaceMap& map) {
  return [&map](const std::vector<core::PlaceId>& ids) {
    std::vector<core::PlaceFrame> frames;
    for (const core::PlaceId id : ids) {
      frames.push_back({map.find(id)->map_from_place, map.find(id)->session});
    }
    return std::optional<std::vector<core::PlaceFrame>>(std::move(frames));
  };
}

}  // namespace

void TwinScore::add(const TwinScore& other) {
  places += other.places;
  twins += other.twins;
  visits += other.visits;
  confusions += other.confusions;
  named += other.named;
}

TwinScore tryTwins(const sim::World& world, const trials::Recipe& recipe, std::uint64_t seed,
                   const config::Parameters& parameters, const core::TwinOptions& options) {
  const trials::TrialSet set = trials::simulateTrials(world, sim::SimulatedRobot{}, recipe, seed);
  const core::SonarModel sonar(parameters.sonar);
  const core::Recognizer recognizer(parameters.match.recognizer);
  const LearnedMap learned = learn(set, world, sonar);
  const auto twins = core::findTwins(
      learned.map, learned.index, recognizer,
      [&](const core::Place& place) {
        return learned.scans[static_cast<std::size_t>(place.id - 1)];
      },
      options);
  std::set<std::pair<core::PlaceId, core::PlaceId>> pairs;
  for (const core::Twin& twin : twins) pairs.emplace(twin.place, twin.other);

  TwinScore score;
  score.places = learned.map.size();
  score.twins = twins.size();
  for (const trials::RecognitionTrial& trial : set.trials) {
    ++score.visits;
    const core::Scan scan = scanOf(trial.readings, sonar, {set.cell_size});
    const core::Recognition found =
        *recognizer.recognize(scan, learned.index, framesOf(learned.map), trial.heading_window);
    const core::PlaceMatch& best = found.matches.front();
    const core::Pose2d pose = learned.map.find(best.id)->map_from_place * best.place_from_scan;
    const double error =
        std::hypot(pose.x - trial.odom_from_scan.x, pose.y - trial.odom_from_scan.y);
    if (error < kFarOff) continue;
    ++score.confusions;
    const bool is_named =
        std::any_of(trial.accept.begin(), trial.accept.end(), [&](const std::string& label) {
          return pairs.count({learned.map.find(label)->id, best.id}) > 0;
        });
    if (is_named) ++score.named;
  }
  return score;
}

}  // namespace place_memory::reports
