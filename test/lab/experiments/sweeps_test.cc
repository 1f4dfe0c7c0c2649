#include <gtest/gtest.h>

#include <set>

#include "experiments/experiment.h"

namespace place_memory::experiments {
namespace {

const ShippedWorlds& worlds() {
  static const ShippedWorlds kWorlds =
      loadShippedWorlds(std::string(PLACE_MEMORY_SOURCE_DIR) + "/config/worlds");
  return kWorlds;
}

Batch batchAt(const std::string& name, double x) {
  for (const Experiment& point : sweep(name, worlds())) {
    if (point.x == x) return point.make(kFirstReportedSeed, Sensor::kSonar);
  }
  ADD_FAILURE() << name << " has no point at " << x;
  return {};
}

TEST(Sweeps, EveryCurveHasPointsOfItsName) {
  for (const std::string& name : sweepNames()) {
    const auto points = sweep(name, worlds());
    EXPECT_GE(points.size(), 5U);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(points[i].group, name);
      if (i > 0) {
        EXPECT_GT(points[i].x, points[i - 1].x);
      }
    }
  }
}

TEST(Sweeps, AnUnknownCurveIsRefused) {
  EXPECT_THROW(sweep("weather", worlds()), std::runtime_error);
}

TEST(Sweeps, ThePlacesAreAsManyAsAskedAndEachTrialHasItsPlaceAmongThem) {
  const Batch batch = batchAt("places", 20);
  std::set<std::string> labels;
  for (const auto& scan : batch.known.learned) labels.insert(scan.label);
  EXPECT_EQ(labels.size(), 20U);
  EXPECT_FALSE(batch.known.trials.empty());
  for (const auto& trial : batch.known.trials) {
    EXPECT_TRUE(std::any_of(trial.accept.begin(), trial.accept.end(),
                            [&](const auto& label) { return labels.count(label) > 0; }));
  }
}

TEST(Sweeps, TheRingHasAsManySonarsAsAsked) {
  const std::size_t few = batchAt("sonars", 8).known.learned[0].readings.size();
  const std::size_t many = batchAt("sonars", 16).known.learned[0].readings.size();
  EXPECT_LE(few, 8U * 11U);
  EXPECT_GT(many, 8U * 11U);
}

TEST(Sweeps, CellsAreAsLargeAsAsked) { EXPECT_EQ(batchAt("cell_size", 0.3).known.cell_size, 0.3); }

TEST(Sweeps, AHeadingErrorBeyondTheUsualWindowWidensIt) {
  EXPECT_NEAR(batchAt("heading_error", 20).known.trials[0].heading_window, core::kPi / 4, 1e-9);
  EXPECT_NEAR(batchAt("heading_error", 90).known.trials[0].heading_window, core::kPi / 2, 1e-9);
}

}  // namespace
}  // namespace place_memory::experiments
