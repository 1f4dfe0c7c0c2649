#include "experiments/figures.h"

#include <algorithm>
#include <functional>

#include "experiments/recipes.h"
#include "place_memory/core/sonar_model.h"
#include "sim/scene/world_changes.h"

namespace place_memory::experiments {
namespace {

using core::Pose2d;
using sim::Rng;
using sim::Vec2;

/// The methods whose answers captions tell, and how evidence is drawn.
struct Studio {
  const Method& nearest;
  const Method& climbing;
  const Method& ours;
  core::SonarModel sonar{climbing.parameters.sonar};

  core::EvidenceGrid develop(const std::vector<core::SonarReading>& readings) const {
    return sonar.build(readings, core::GridGeometry{});
  }

  /// "nearest neighbour 3, hill climbing 1, default 1"
  std::string answers(const Batch& batch, std::size_t trial) const {
    return "nearest neighbour " + runTrials(batch, nearest)[trial].given + ", hill climbing " +
           runTrials(batch, climbing)[trial].given + ", default " +
           runTrials(batch, ours)[trial].given;
  }
};

std::vector<core::SonarReading> look(const sim::World& world, Vec2 at, int people, Rng& rng) {
  const sim::Scene scene(world);
  if (people == 0) {
    return sim::simulateScan(scene, {at.x, at.y, 0.0}, 0.0, sim::SimulatedRobot{}, nullptr, rng);
  }
  sim::Crowd crowd = sim::Crowd::passing(world, at, people, rng);
  return sim::simulateScan(scene, {at.x, at.y, 0.0}, 0.0, sim::SimulatedRobot{}, &crowd, rng);
}

/// A panel for what the robot sees at `at`, as a trial of `batch` too.
Panel visit(const Studio& studio, const sim::World& world, const std::string& label, Vec2 at,
            int people, Rng& rng, Batch& batch) {
  trials::RecognitionTrial trial;
  trial.accept = {label};
  trial.odom_from_scan = {at.x, at.y, 0.0};
  trial.heading_window = trials::Recipe{}.heading_window;
  trial.readings = look(world, at, people, rng);
  batch.known.trials.push_back(trial);
  return {"", studio.develop(trial.readings), {}};
}

/// Two feet away where the robot can drive there in a straight line.
Vec2 twoFeetAway(const sim::World& world, Vec2 from, Rng& rng) {
  const sim::Scene scene(world);
  for (int attempt = 0; attempt < 100; ++attempt) {
    const Vec2 to = from + sim::unitVector(sim::uniform(rng, -core::kPi, core::kPi)) * kTwoFeet;
    if (scene.isPathFree(from, to, 0.3)) return to;
  }
  return from;
}

/// A place with more and more chairs about it, from where it was learned or from two feet away.
GridFigure chairsFigure(const Studio& studio, const sim::World& rooms, std::size_t index,
                        const std::vector<int>& counts, bool shifted, std::uint64_t seed) {
  const sim::Place& place = rooms.places[index];
  Batch batch;
  batch.known.learned = trials::simulateTrials(rooms, {}, roomsRecipe(0, 0.0), seed).learned;
  Rng rng(seed);
  const Vec2 at = shifted ? twoFeetAway(rooms, place.position, rng) : place.position;
  sim::World full = rooms;
  sim::addChairs(full, place.position, 3, rng);

  GridFigure figure;
  figure.panels.push_back({"learned", studio.develop(batch.known.learned[index].readings), {}});
  for (const int count : counts) {
    sim::World world = full;
    const std::size_t chairs = rooms.chairs.size() + static_cast<std::size_t>(count);
    world.chairs.resize(std::min(chairs, full.chairs.size()));
    Panel panel = visit(studio, world, place.label, at, 0, rng, batch);
    for (std::size_t i = rooms.chairs.size(); i < world.chairs.size(); ++i) {
      panel.circled.push_back(Vec2{world.chairs[i].pose.x, world.chairs[i].pose.y} - at);
    }
    panel.title =
        std::to_string(count) + " new: " + studio.answers(batch, batch.known.trials.size() - 1);
    figure.panels.push_back(panel);
  }
  return figure;
}

/// The place nearest to a whiteboard, before and after that is taken away (paper 7).
GridFigure whiteboardFigure(const Studio& studio, const sim::World& office, std::uint64_t seed) {
  const sim::Whiteboard& board = office.whiteboards.front();
  const auto distance = [&](const sim::Place& place) {
    return sim::distanceToSegment(place.position, board.from, board.to);
  };
  const auto place =
      std::min_element(office.places.begin(), office.places.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  const auto index = static_cast<std::size_t>(place - office.places.begin());
  const trials::Recipe recipe = officeRecipe(0.0);
  Batch batch;
  batch.known.learned = trials::simulateTrials(office, {}, recipe, seed).learned;
  Rng rng(seed);
  sim::World changed = office;
  sim::moveChairs(changed, recipe.chairs_moved, recipe.chair_distance, rng);
  sim::addBicycles(changed, recipe.bicycles_added, rng);
  sim::World bare = changed;
  sim::removeWhiteboard(bare, board.name);

  GridFigure figure;
  figure.name = "figure_5";
  figure.caption = "Place " + place->label + " of the office, beside a whiteboard";
  figure.panels.push_back({"learned", studio.develop(batch.known.learned[index].readings), {}});
  const std::pair<const char*, const sim::World*> visits[] = {
      {"chairs moved, bicycles: ", &changed}, {"whiteboard gone too: ", &bare}};
  for (const auto& [what, world] : visits) {
    Panel panel = visit(studio, *world, place->label, place->position, recipe.people, rng, batch);
    panel.title = what + studio.answers(batch, batch.known.trials.size() - 1);
    figure.panels.push_back(panel);
  }
  return figure;
}

const trials::LearnedScan& learnedOf(const Batch& batch, const std::string& label) {
  return *std::find_if(batch.known.learned.begin(), batch.known.learned.end(),
                       [&](const auto& scan) { return scan.label == label; });
}

GridFigure trialFigure(const Studio& studio, const Batch& batch, std::size_t index,
                       const std::string& confused_with) {
  const trials::RecognitionTrial& trial = batch.known.trials[index];
  GridFigure figure;
  const std::string& label = trial.accept.front();
  figure.caption = "Place " + label + " of the hallway: " + studio.answers(batch, index);
  figure.panels.push_back(
      {"learned, place " + label, studio.develop(learnedOf(batch, label).readings), {}});
  figure.panels.push_back({"recognition, place " + label, studio.develop(trial.readings), {}});
  if (!confused_with.empty()) {
    figure.panels.push_back({"learned, place " + confused_with,
                             studio.develop(learnedOf(batch, confused_with).readings),
                             {}});
  }
  return figure;
}

/// The first trial two feet along the hallway whose answers are as asked.
void addShiftedTrial(const Studio& studio, const sim::World& hallway, std::uint64_t seed,
                     const std::string& name,
                     const std::function<bool(const Answer&, const Answer&)>& is_asked,
                     std::vector<GridFigure>& figures) {
  constexpr std::uint64_t kSeeds = 40;
  for (std::uint64_t i = 0; i < kSeeds; ++i) {
    const Batch batch =
        simulateBatch(hallway, {}, hallwayRecipe(kTwoFeet), Sensor::kSonar, seed + i, 0);
    const std::vector<Answer> nearest = runTrials(batch, studio.nearest);
    const std::vector<Answer> climbing = runTrials(batch, studio.climbing);
    for (std::size_t trial = 0; trial < nearest.size(); ++trial) {
      if (!is_asked(nearest[trial], climbing[trial])) continue;
      figures.push_back(trialFigure(studio, batch, trial, nearest[trial].given));
      figures.back().name = name;
      return;
    }
  }
}

}  // namespace

std::vector<GridFigure> gridFigures(const ShippedWorlds& worlds, const Method& nearest,
                                    const Method& climbing, const Method& ours,
                                    std::uint64_t seed) {
  const Studio studio{nearest, climbing, ours};
  std::vector<GridFigure> figures;
  figures.push_back(chairsFigure(studio, worlds.rooms, 0, {1, 2, 3}, false, seed));
  figures.back().name = "figure_1";
  figures.back().caption = "Place 0 of the rooms with new chairs, circled";
  figures.push_back(chairsFigure(studio, worlds.rooms, 4, {0, 1, 3}, true, seed));
  figures.back().name = "figure_2";
  figures.back().caption = "Place 4 of the rooms from two feet away, new chairs circled";
  figures.push_back(whiteboardFigure(studio, worlds.office, seed));
  const Batch hallway =
      simulateBatch(worlds.hallway, {}, hallwayRecipe(0.0), Sensor::kSonar, seed, 0);
  figures.push_back(trialFigure(studio, hallway, 9, ""));
  figures.back().name = "figure_7";
  addShiftedTrial(
      studio, worlds.hallway, seed, "figure_8",
      [](const Answer& near, const Answer& climb) { return !near.right && climb.right; }, figures);
  addShiftedTrial(
      studio, worlds.hallway, seed, "figure_9",
      [](const Answer& near, const Answer& climb) {
        return !near.right && !climb.right && near.given == climb.given;
      },
      figures);
  return figures;
}

}  // namespace place_memory::experiments
