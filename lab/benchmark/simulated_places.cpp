#include "simulated_places.h"

#include <algorithm>
#include <string>
#include <unordered_map>

#include "place_memory/core/sonar_model.h"
#include "sim/building/building_generator.h"
#include "sim/senses/simulated_scan.h"
#include "support/parallel_for.h"
#include "trials/simulated_trials.h"

namespace place_memory::measure {
namespace {

/// Buildings that neither the presets were fitted on nor the experiments use.
constexpr std::uint64_t kFirstSeed = 5000000;
constexpr double kBuildingSpacing = 500.0;  // [m]
constexpr double kDegree = core::kPi / 180.0;

trials::Recipe recipe(bool any_heading) {
  trials::Recipe recipe;
  recipe.doors_flipped = 0.3;
  recipe.chairs_moved = 0.3;
  recipe.people = 1;
  recipe.shift = 0.3;
  recipe.compass_error = 30.0 * kDegree;
  recipe.any_heading = any_heading;
  return recipe;
}

struct Building {
  trials::TrialSet local;
  trials::TrialSet any_heading;
};

Building simulateBuilding(std::size_t number) {
  constexpr sim::BuildingKind kKinds[] = {sim::BuildingKind::kCorridor,
                                          sim::BuildingKind::kOpenPlan,
                                          sim::BuildingKind::kLaboratory, sim::BuildingKind::kHome};
  const std::uint64_t seed = kFirstSeed + number;
  const sim::World world = sim::generateBuilding(kKinds[number % std::size(kKinds)], seed);
  const sim::SimulatedRobot robot;
  return {trials::simulateTrials(world, robot, recipe(false), seed),
          trials::simulateTrials(world, robot, recipe(true), seed + (std::uint64_t{1} << 40U))};
}

core::Pose2d inMap(const core::Pose2d& pose, std::size_t building) {
  return {pose.x + kBuildingSpacing * static_cast<double>(building), pose.y, pose.yaw};
}

std::vector<Query> queriesOf(const trials::TrialSet& set, std::size_t building,
                             std::size_t first_place, const core::SonarModel& sonar) {
  std::unordered_map<std::string, std::size_t> numbers;
  for (const trials::LearnedScan& learned : set.learned) {
    numbers.emplace(learned.label, first_place + numbers.size());
  }
  std::vector<Query> queries;
  for (const trials::RecognitionTrial& trial : set.trials) {
    Query& query = queries.emplace_back();
    query.scan.readings = trial.readings;
    query.scan.grid = sonar.build(trial.readings, core::GridGeometry{});
    query.scan.odom_from_scan = inMap(trial.odom_from_scan, building);
    for (const std::string& label : trial.accept) query.accept.push_back(numbers.at(label));
  }
  return queries;
}

void append(const Building& building, std::size_t number, SimulatedPlaces& all) {
  const core::SonarModel sonar{core::SonarModelOptions{}};
  const std::size_t first = all.places.size();
  for (const trials::LearnedScan& learned : building.local.learned) {
    all.places.push_back({number, inMap(learned.odom_from_scan, number),
                          sonar.build(learned.readings, core::GridGeometry{})});
  }
  const auto add = [&](const trials::TrialSet& set, std::vector<Query>& to) {
    std::vector<Query> queries = queriesOf(set, number, first, sonar);
    std::move(queries.begin(), queries.end(), std::back_inserter(to));
  };
  add(building.local, all.local);
  add(building.any_heading, all.any_heading);
}

/// Some of the last building are too many: a query may then have no place that is right any more.
void cut(std::size_t count, std::vector<Query>& queries) {
  queries.resize(count);
  for (Query& query : queries) {
    auto& accept = query.accept;
    accept.erase(std::remove_if(accept.begin(), accept.end(),
                                [count](std::size_t place) { return place >= count; }),
                 accept.end());
  }
  queries.erase(std::remove_if(queries.begin(), queries.end(),
                               [](const Query& query) { return query.accept.empty(); }),
                queries.end());
}

}  // namespace

SimulatedPlaces simulatePlaces(std::size_t count) {
  constexpr std::size_t kAtATime = 16;  // buildings
  SimulatedPlaces all;
  std::vector<Building> buildings(kAtATime);
  for (std::size_t first = 0; all.places.size() < count; first += kAtATime) {
    support::parallelFor(kAtATime,
                         [&](std::size_t i) { buildings[i] = simulateBuilding(first + i); });
    for (std::size_t i = 0; i < kAtATime && all.places.size() < count; ++i) {
      append(buildings[i], first + i, all);
    }
  }
  all.places.resize(count);
  cut(count, all.local);
  cut(count, all.any_heading);
  return all;
}

}  // namespace place_memory::measure
