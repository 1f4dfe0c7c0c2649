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

constexpr double kFarOff = 2.0;   // [m]
constexpr double kApart = 500.0;  // from one world of a map to the next [m]

/// A map of what was learned, its ids from 1 on in that order.
struct LearnedMap {
  std::size_t parts = 0;
  std::vector<trials::RecognitionTrial> visits;
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

/// Adds what was learned of one world to the map, and its visits.
void add(const trials::TrialSet& set, const sim::World& world, const core::SonarModel& sonar,
         std::vector<core::Place>& places, std::vector<core::PlaceLink>& links,
         LearnedMap& learned) {
  const auto first = static_cast<core::PlaceId>(places.size()) + 1;
  const core::Pose2d offset{kApart * static_cast<double>(learned.parts), 0.0, 0.0};
  const std::string part = std::to_string(learned.parts++) + " ";
  for (const trials::LearnedScan& scan : set.learned) {
    core::Place place;
    place.id = static_cast<core::PlaceId>(places.size()) + 1;
    place.label = part + scan.label;
    place.map_from_place = offset * scan.odom_from_scan;
    learned.scans.push_back(scanOf(scan.readings, sonar, {set.cell_size}));
    learned.index.put(place.id, learned.scans.back().grid);
    places.push_back(place);
  }
  const auto neighbours = sim::placeNeighbours(world);
  for (std::size_t i = 0; i < neighbours.size(); ++i) {
    for (const std::size_t other : neighbours[i]) {
      if (other <= i) continue;
      core::PlaceLink link;
      link.first = first + static_cast<core::PlaceId>(i);
      link.second = first + static_cast<core::PlaceId>(other);
      links.push_back(link);
    }
  }
  for (trials::RecognitionTrial trial : set.trials) {
    trial.odom_from_scan = offset * trial.odom_from_scan;
    for (std::string& label : trial.accept) label.insert(0, part);
    learned.visits.push_back(std::move(trial));
  }
}

LearnedMap learn(const std::vector<sim::World>& worlds, const sim::SimulatedRobot& robot,
                 const TwinVisits& coming_back, std::uint64_t seed, const core::SonarModel& sonar) {
  LearnedMap learned;
  std::vector<core::Place> places;
  std::vector<core::PlaceLink> links;
  for (const sim::World& world : worlds) {
    add(trials::simulateRounds(world, robot, coming_back.recipe, coming_back.rounds, seed), world,
        sonar, places, links, learned);
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

using Pairs = std::set<std::pair<core::PlaceId, core::PlaceId>>;

/// Who looks like whom is no matter of direction.
std::pair<core::PlaceId, core::PlaceId> pairOf(core::PlaceId one, core::PlaceId other) {
  return std::minmax({one, other});
}

bool isAmong(const Pairs& pairs, const Pairs& known) {
  return std::any_of(pairs.begin(), pairs.end(),
                     [&known](const auto& pair) { return known.count(pair) > 0; });
}

/// The best match with each place that would have been right; none where it is not far off.
Pairs confusionOf(const trials::RecognitionTrial& trial, const core::Recognition& found,
                  const core::PlaceMap& map) {
  const core::PlaceMatch& best = found.matches.front();
  const core::Pose2d pose = map.find(best.id)->map_from_place * best.place_from_scan;
  const double error = std::hypot(pose.x - trial.odom_from_scan.x, pose.y - trial.odom_from_scan.y);
  Pairs confused;
  if (error < kFarOff) return confused;
  for (const std::string& label : trial.accept) {
    confused.insert(pairOf(map.find(label)->id, best.id));
  }
  return confused;
}

Pairs twinsOf(const LearnedMap& learned, const core::Recognizer& recognizer,
              const core::TwinOptions& options) {
  Pairs pairs;
  for (const core::Twin& twin : core::findTwins(
           learned.map, learned.index, recognizer,
           [&learned](const core::Place& place) {
             return learned.scans[static_cast<std::size_t>(place.id - 1)];
           },
           options)) {
    pairs.insert(pairOf(twin.place, twin.other));
  }
  return pairs;
}

}  // namespace

void TwinScore::add(const TwinScore& other) {
  places += other.places;
  pairs += other.pairs;
  pairs_confused += other.pairs_confused;
  visits += other.visits;
  confusions += other.confusions;
  named += other.named;
  last += other.last;
  last_known += other.last_known;
}

TwinScore tryTwins(const std::vector<sim::World>& worlds, const sim::SimulatedRobot& robot,
                   const TwinVisits& coming_back, std::uint64_t seed,
                   const config::Parameters& parameters, const core::TwinOptions& options) {
  const core::SonarModel sonar(parameters.sonar);
  const core::Recognizer recognizer(parameters.match.recognizer);
  const LearnedMap learned = learn(worlds, robot, coming_back, seed, sonar);
  const Pairs twins = twinsOf(learned, recognizer, options);

  TwinScore score;
  score.places = learned.map.size();
  score.pairs = twins.size();
  score.visits = learned.visits.size();
  Pairs all;
  Pairs before;  // the last time
  std::vector<Pairs> last;
  for (const trials::RecognitionTrial& trial : learned.visits) {
    const core::Scan scan = scanOf(trial.readings, sonar, {});
    const core::Recognition found =
        *recognizer.recognize(scan, learned.index, framesOf(learned.map), trial.heading_window);
    const Pairs confused = confusionOf(trial, found, learned.map);
    if (confused.empty()) continue;
    ++score.confusions;
    if (isAmong(confused, twins)) ++score.named;
    all.insert(confused.begin(), confused.end());
    if (trial.round + 1 < coming_back.rounds) {
      before.insert(confused.begin(), confused.end());
    } else {
      last.push_back(confused);
    }
  }
  score.pairs_confused = static_cast<std::size_t>(std::count_if(
      twins.begin(), twins.end(), [&all](const auto& pair) { return all.count(pair) > 0; }));
  score.last = last.size();
  score.last_known = static_cast<std::size_t>(std::count_if(
      last.begin(), last.end(), [&before](const Pairs& pairs) { return isAmong(pairs, before); }));
  return score;
}

}  // namespace place_memory::reports
