// What a map costs that grows while the robot drives: belief, relaxation, loops, whole drives.
#include <benchmark/benchmark.h>

#include <cmath>
#include <ctime>
#include <random>

#include "core/map/place_belief.h"
#include "core/map/place_locator.h"
#include "core/mapping/mapper.h"
#include "setting.h"
#include "sim/building/building_generator.h"
#include "synthetic_graph.h"
#include "trials/simulated_drive.h"

namespace place_memory::measure {
namespace {

using ::benchmark::State;

constexpr double kSpacing = 1.5;           // of places [m]
constexpr std::size_t kMatches = 32;       // of one scan
constexpr std::size_t kRow = 100;          // poses from end to end of a building
constexpr double kWay = 150.0;             // of a drive [m]
constexpr std::uint64_t kSeed = 2000;      // fitting uses those below 1000
constexpr std::size_t kDrivesFrom = 1000;  // drives are measured where memories may be so large
constexpr std::size_t kSizes[] = {1000, 10000, 100000};

/// Places side by side all over a square.
class Square {
 public:
  explicit Square(std::size_t places)
      : side_(static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(places))))) {
    for (std::size_t i = 0; i < places; ++i) {
      locator_.put(static_cast<core::PlaceId>(i + 1), poseOf(i));
    }
    map.places = places;
    map.map_from_place = [this](core::PlaceId id) {
      return poseOf(static_cast<std::size_t>(id - 1));
    };
    map.sigma = [](double way) { return 0.05 * way; };
    map.near = [this](const core::Pose2d& pose, double radius) {
      return locator_.near(pose, radius);
    };
  }

  core::PlaceBelief::Map map;

 private:
  core::Pose2d poseOf(std::size_t i) const {
    return {kSpacing * static_cast<double>(i % side_), kSpacing * static_cast<double>(i / side_),
            0.0};
  }

  std::size_t side_;
  core::PlaceLocator locator_{kSpacing};
};

/// One iteration is one scan: the robot has moved by the distance of two places, the place where it
/// is matches, and many that look alike, others each time.
void beliefUpdate(State& state, std::size_t places) {
  const Square square(places);
  core::PlaceBelief belief({});
  std::mt19937_64 random(kSeed);
  std::uniform_int_distribution<core::PlaceId> any(1, static_cast<core::PlaceId>(places));
  std::uniform_real_distribution<double> score(0.0, 8.0);
  core::PlaceId here = 1;
  double states = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    here = here % static_cast<core::PlaceId>(places) + 1;
    std::vector<core::BeliefMatch> matches{{here, 8.0, {}}};
    while (matches.size() < kMatches) matches.push_back({any(random), score(random), {}});
    belief.predict({{kSpacing, 0.0, 0.0}, kSpacing}, square.map);
    belief.measure(matches, 0.8, 1.0, square.map);
    ::benchmark::DoNotOptimize(belief.lost(square.map));
    states += static_cast<double>(belief.states().size());
  }
  state.counters["states"] = states / static_cast<double>(state.iterations());
}

void relaxation(State& state, const core::RelaxationProblem& graph) {
  double steps = 0.0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    core::RelaxationProblem problem = graph;
    state.ResumeTiming();
    const core::RelaxationResult result = core::relax(problem);
    steps += result.iterations;
    if (!result.solved) state.SkipWithError("not solvable");
  }
  state.counters["steps"] = steps / static_cast<double>(state.iterations());
  state.counters["poses"] = static_cast<double>(graph.poses.size());
}

/// One iteration is one drive through a generated building, mapped as it goes.
void mappingDrive(State& state, Setting& setting, bool compass) {
  trials::DriveRecipe recipe;
  recipe.way = kWay;
  if (!compass) recipe.compass_sigma = -1.0;
  const trials::Drive drive = trials::simulateDrive(
      sim::generateBuilding(sim::BuildingKind::kOpenPlan, kSeed), {}, recipe, kSeed);
  core::MapperOptions options;
  options.recognizer = setting.parameters().match.recognizer;
  options.sonar = setting.parameters().sonar;
  double places = 0.0;
  const std::clock_t begin = std::clock();
  for ([[maybe_unused]] auto _ : state) {
    core::Mapper mapper(options);
    for (const trials::DriveMoment& moment : drive) {
      const std::chrono::nanoseconds stamp(std::llround((1000.0 + moment.t) * 1e9));
      if (moment.heading) mapper.addHeading(stamp, *moment.heading);
      mapper.addOdometry(stamp, moment.odom);
      for (const core::SonarReading& reading : moment.readings) {
        mapper.addReading(stamp, moment.odom, reading);
      }
    }
    places = static_cast<double>(mapper.places().size());
  }
  // Of all threads.
  const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  state.counters["places"] = places;
  state.counters["cpu_seconds_per_metre"] = cpu / (kWay * static_cast<double>(state.iterations()));
}

template <typename Make>
void registerRelaxation(const std::string& name, const Make& make, int iterations) {
  ::benchmark::RegisterBenchmark(name.c_str(), [make](State& state) { relaxation(state, make()); })
      ->Iterations(iterations)
      ->Unit(::benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace

void registerDriving(Setting& setting) {
  using ::benchmark::RegisterBenchmark;
  const std::size_t most = setting.options().max_places;
  for (const std::size_t size : kSizes) {
    if (size > most) continue;
    RegisterBenchmark(("belief/" + std::to_string(size)).c_str(),
                      [size](State& state) { beliefUpdate(state, size); })
        ->Unit(::benchmark::kMillisecond)
        ->UseRealTime();
    registerRelaxation(
        "relaxation/" + std::to_string(size),
        [size] { return makeGraphBeforeLoop(size / kRow, kRow, kSeed); }, size > 10000 ? 1 : 3);
  }
  registerRelaxation(
      "loop/500", [] { return makeRound(500, kSeed); }, 20);
  if (most < kDrivesFrom) return;
  for (const bool compass : {true, false}) {
    RegisterBenchmark(compass ? "drive/compass" : "drive/no_compass",
                      [&, compass](State& state) { mappingDrive(state, setting, compass); })
        ->Iterations(1)
        ->Unit(::benchmark::kSecond)
        ->UseRealTime();
  }
}

}  // namespace place_memory::measure
