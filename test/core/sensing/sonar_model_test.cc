#include "place_memory/core/sonar_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace place_memory::core {
namespace {

constexpr double kNoEcho = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = kPi / 180.0;
constexpr double kCell = 0.1;  ///< the grid spans +-3.2 m

SonarReading reading(const Pose2d& sensor, double range, double field_of_view = 25.0 * kDegree,
                     double max_range = 2.5) {
  return {sensor, {field_of_view, 0.05, max_range}, range};
}

EvidenceGrid gridOf(const SonarReading& single, double cell_size = kCell) {
  return SonarModel(SonarModelOptions{}).build({single}, GridGeometry{cell_size});
}

/// Values a step apart, from the first to the last.
std::vector<double> every(double step, double first, double last) {
  std::vector<double> values;
  const int steps = static_cast<int>(std::lround((last - first) / step));
  for (int i = 0; i <= steps; ++i) values.push_back(first + i * step);
  return values;
}

int evidenceAt(const EvidenceGrid& grid, double x, double y) {
  return grid.at(grid.geometry().index(y), grid.geometry().index(x));
}

void forEachCell(const EvidenceGrid& grid, const Pose2d& frame,
                 const std::function<void(int evidence, double distance, double angle)>& visit) {
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const Pose2d centre{grid.geometry().centre(column), grid.geometry().centre(row), 0.0};
      const Pose2d local = frame.inverse() * centre;
      visit(grid.at(row, column), std::hypot(local.x, local.y), std::atan2(local.y, local.x));
    }
  }
}

int countTouched(const EvidenceGrid& grid) {
  int touched = 0;
  for (const std::int8_t cell : grid.cells()) touched += cell != 0 ? 1 : 0;
  return touched;
}

/// Whether a cell's centre within a cell of the point is emptier than the prior.
bool hasEmptyCellNear(const EvidenceGrid& grid, const Pose2d& point) {
  bool found = false;
  forEachCell(grid, point, [&](int evidence, double distance, double) {
    found = found || (evidence < 0 && distance <= grid.geometry().cell_size);
  });
  return found;
}

/// Everything that holds for any reading: what is before the echo gets no occupied cell, nothing
/// happens behind it or beside the cone. The margins are those of an echo's depth and of a cell.
void expectOnlyTheConeTouched(const EvidenceGrid& grid, const SonarReading& single) {
  const double cell = grid.geometry().cell_size;
  const double depth = SonarModelOptions{}.echo_depth * cell + 0.01 * cell;
  const bool echo = std::isfinite(single.range);
  const double range = echo ? single.range : single.spec.max_range;
  forEachCell(grid, single.sensor_pose, [&](int evidence, double distance, double angle) {
    const double beside =
        std::abs(angle) < 0.5 * kPi ? distance * std::sin(std::abs(angle)) : distance;
    const double half_width = std::max(distance * std::sin(0.5 * single.spec.field_of_view), cell);
    if (beside > half_width + 0.01 * cell || distance > range + (echo ? depth : 0.01 * cell)) {
      EXPECT_EQ(evidence, 0) << "outside, at " << distance << " m, " << angle << " rad";
    }
    const bool at_echo = echo && std::abs(distance - range) < 0.98 * depth;
    const bool before_echo = !echo || distance < range - depth;
    EXPECT_LE(before_echo ? evidence : 0, 0) << "before the echo, at " << distance << " m";
    EXPECT_GE(at_echo ? evidence : 0, 0) << "at the echo, at " << distance << " m";
  });
}

TEST(SonarModel, AWallIsOccupiedAtTheEchoEmptyBeforeItAndUnknownBehind) {
  const SonarReading wall = reading({}, 1.5);
  const EvidenceGrid grid = gridOf(wall);
  expectOnlyTheConeTouched(grid, wall);
  for (const double y : {-0.05, 0.05}) {
    for (const double x : every(kCell, 0.25, 1.25)) EXPECT_LT(evidenceAt(grid, x, y), 0) << x;
    EXPECT_GT(evidenceAt(grid, 1.45, y), 0);
    EXPECT_GT(evidenceAt(grid, 1.55, y), 0);
    for (const double x : every(kCell, 1.75, 3.15)) EXPECT_EQ(evidenceAt(grid, x, y), 0) << x;
    for (const double x : every(kCell, -3.15, -0.05)) EXPECT_EQ(evidenceAt(grid, x, y), 0) << x;
  }
}

TEST(SonarModel, NoEchoClearsToTheMaximumRangeAndMarksNothing) {
  const SonarReading open = reading({}, kNoEcho);
  const EvidenceGrid grid = gridOf(open);
  expectOnlyTheConeTouched(grid, open);
  for (const double x : every(kCell, 0.25, 2.35)) EXPECT_LT(evidenceAt(grid, x, 0.05), 0) << x;
  EXPECT_EQ(evidenceAt(grid, 2.65, 0.05), 0);
  for (const std::int8_t cell : grid.cells()) EXPECT_LE(cell, 0);
}

TEST(SonarModel, EvidenceIsStrongestOnTheAxisAndFadesTowardsTheEdge) {
  const EvidenceGrid grid = gridOf(reading({0.0, 0.05, 0.0}, 2.0, 60.0 * kDegree));
  for (const double y : every(kCell, 0.05, 1.15)) {
    EXPECT_LE(evidenceAt(grid, 1.25, y), evidenceAt(grid, 1.25, y + kCell)) << y;
  }
  EXPECT_LT(evidenceAt(grid, 1.25, 0.05), evidenceAt(grid, 1.25, 0.65));
  EXPECT_GT(evidenceAt(grid, 1.95, 0.05), evidenceAt(grid, 1.75, 0.95));
}

TEST(SonarModel, IsSymmetricAboutTheAxis) {
  for (const double range : {0.3, 1.0, 2.2, kNoEcho}) {
    for (const double field_of_view : {1.0 * kDegree, 25.0 * kDegree, kPi}) {
      const EvidenceGrid grid = gridOf(reading({-1.0, 0.0, 0.0}, range, field_of_view));
      for (int row = 0; row < kGridSize / 2; ++row) {
        for (int column = 0; column < kGridSize; ++column) {
          ASSERT_EQ(grid.at(row, column), grid.at(kGridSize - 1 - row, column));
        }
      }
    }
  }
}

TEST(SonarModel, MarksTheSameWhicheverWayTheSensorFaces) {
  // A quarter turn maps the cells onto themselves; rounding may move a value by a step.
  for (const double range : {0.7, 2.0, kNoEcho}) {
    const EvidenceGrid east = gridOf(reading({0.3, 0.1, 0.2}, range));
    const EvidenceGrid north = gridOf(reading({-0.1, 0.3, 0.2 + 0.5 * kPi}, range));
    for (int row = 0; row < kGridSize; ++row) {
      for (int column = 0; column < kGridSize; ++column) {
        ASSERT_NEAR(east.at(row, column), north.at(column, kGridSize - 1 - row), 1);
      }
    }
  }
}

TEST(SonarModel, AnyPoseAndConeTouchesTheConeOnly) {
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> metres(-6.0, 6.0);  // the grid ends at +-3.2
  std::uniform_real_distribution<double> radians(-20.0, 20.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    const double range = share(engine) < 0.2 ? kNoEcho : 0.05 + 7.0 * share(engine);
    const double field_of_view = 0.01 + (kPi - 0.01) * share(engine);
    const SonarReading any =
        reading({metres(engine), metres(engine), radians(engine)}, range, field_of_view, 7.05);
    expectOnlyTheConeTouched(gridOf(any), any);
    ASSERT_FALSE(HasFailure()) << "reading " << i;
  }
}

TEST(SonarModel, ASensorOutsideTheGridMarksWhereItsConeComesIn) {
  const EvidenceGrid grid = gridOf(reading({-4.0, 0.05, 0.0}, 2.0));
  EXPECT_GT(evidenceAt(grid, -1.95, 0.05), 0);
  EXPECT_LT(evidenceAt(grid, -2.95, 0.05), 0);
}

TEST(SonarModel, AConeThatNeverComesInTouchesNothing) {
  EXPECT_EQ(countTouched(gridOf(reading({-4.0, 0.0, kPi}, 2.0))), 0);
  EXPECT_EQ(countTouched(gridOf(reading({4.0, 4.0, 0.0}, kNoEcho))), 0);
  EXPECT_EQ(countTouched(gridOf(reading({1e9, -1e9, 0.0}, 2.0))), 0);
}

TEST(SonarModel, AConeThatLeavesTheGridClearsUpToItsEdge) {
  const SonarReading leaving = reading({2.0, 0.05, 0.0}, 9.0, 25.0 * kDegree, 10.0);
  const EvidenceGrid grid = gridOf(leaving);
  expectOnlyTheConeTouched(grid, leaving);
  EXPECT_LT(evidenceAt(grid, 3.15, 0.05), 0);
}

TEST(SonarModel, AConeNarrowerThanACellLeavesAnUnbrokenRay) {
  for (const double offset : {0.0, 0.02, 0.5 * kCell}) {  // 0: between two rows of cells
    for (int i = 0; i < 72; ++i) {
      const Pose2d sensor{offset, -offset, i * 5.0 * kDegree};
      const EvidenceGrid grid = gridOf(reading(sensor, 2.0, 0.1 * kDegree));
      for (const double along : every(0.5 * kCell, 0.2, 1.75)) {
        EXPECT_TRUE(hasEmptyCellNear(grid, sensor * Pose2d{along, 0.0, 0.0}))
            << "yaw " << sensor.yaw << ", " << along << " m";
      }
      EXPECT_GT(*std::max_element(grid.cells().begin(), grid.cells().end()), 0)
          << "yaw " << sensor.yaw;
    }
  }
}

TEST(SonarModel, AHalfCircleOfAConeReachesToBothSidesAndNotBehind) {
  const SonarReading half = reading({}, 1.5, kPi);
  const EvidenceGrid grid = gridOf(half);
  expectOnlyTheConeTouched(grid, half);
  for (const double angle : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
    const double c = std::cos(angle * kDegree);
    const double s = std::sin(angle * kDegree);
    EXPECT_GT(evidenceAt(grid, 1.5 * c, 1.5 * s), 0) << angle;
    EXPECT_LT(evidenceAt(grid, 0.8 * c, 0.8 * s), 0) << angle;
    EXPECT_EQ(evidenceAt(grid, -1.5 * c, 1.5 * s), 0) << angle;
    EXPECT_EQ(evidenceAt(grid, -0.8 * c, 0.8 * s), 0) << angle;
  }
}

TEST(SonarModel, WorksAtAnyCellSize) {
  for (const double cell_size : {0.02, 0.1, kDefaultCellSize, 0.5}) {
    const double range = 20.0 * cell_size;
    const SonarReading wall = reading({}, range, 25.0 * kDegree, 2.0 * range);
    const EvidenceGrid grid = gridOf(wall, cell_size);
    expectOnlyTheConeTouched(grid, wall);
    EXPECT_GT(evidenceAt(grid, range, 0.5 * cell_size), 0) << cell_size;
    EXPECT_LT(evidenceAt(grid, 0.5 * range, 0.5 * cell_size), 0) << cell_size;
  }
}

TEST(SonarModel, RepeatedReadingsAddUpAndSaturate) {
  const SonarModel model(SonarModelOptions{});
  const SonarReading wall = reading({}, 1.5);
  EvidenceGrid grid(GridGeometry{kCell});
  model.add(wall, grid);
  const int once = evidenceAt(grid, 1.45, 0.05);
  model.add(wall, grid);
  EXPECT_EQ(evidenceAt(grid, 1.45, 0.05), std::min(2 * once, EvidenceGrid::kLimit));
  for (int i = 0; i < 300; ++i) model.add(wall, grid);
  EXPECT_EQ(evidenceAt(grid, 1.45, 0.05), EvidenceGrid::kLimit);
  EXPECT_EQ(evidenceAt(grid, 0.75, 0.05), -EvidenceGrid::kLimit);
}

TEST(SonarModel, BuildAddsOneReadingAfterTheOther) {
  const SonarModel model(SonarModelOptions{});
  const std::vector<SonarReading> readings{reading({}, 1.5), reading({0.1, 0.1, 1.0}, kNoEcho)};
  EvidenceGrid expected(GridGeometry{kCell});
  for (const SonarReading& single : readings) model.add(single, expected);
  EXPECT_TRUE(model.build(readings, GridGeometry{kCell}) == expected);
  EXPECT_EQ(countTouched(model.build({}, GridGeometry{kCell})), 0);
}

TEST(SonarModel, SurerOptionsGiveStrongerEvidence) {
  SonarModelOptions sure;
  sure.occupied = 0.95;
  sure.empty = 0.1;
  const SonarReading wall = reading({}, 1.5);
  const EvidenceGrid strong = SonarModel(sure).build({wall}, GridGeometry{kCell});
  const EvidenceGrid usual = gridOf(wall);
  EXPECT_GT(evidenceAt(strong, 1.45, 0.05), evidenceAt(usual, 1.45, 0.05));
  EXPECT_LT(evidenceAt(strong, 0.75, 0.05), evidenceAt(usual, 0.75, 0.05));
}

struct BadOption {
  const char* name;
  double SonarModelOptions::*option;
  double value;
};

TEST(SonarModel, ABadOptionIsNamed) {
  const BadOption cases[] = {
      {"prior", &SonarModelOptions::prior, 0.0},
      {"prior", &SonarModelOptions::prior, 1.0},
      {"prior", &SonarModelOptions::prior, -0.1},
      {"prior", &SonarModelOptions::prior, kNan},
      {"occupied", &SonarModelOptions::occupied, 0.5},  // the prior
      {"occupied", &SonarModelOptions::occupied, 0.2},
      {"occupied", &SonarModelOptions::occupied, 1.0},
      {"occupied", &SonarModelOptions::occupied, kNan},
      {"empty", &SonarModelOptions::empty, 0.5},  // the prior
      {"empty", &SonarModelOptions::empty, 0.8},
      {"empty", &SonarModelOptions::empty, 0.0},
      {"empty", &SonarModelOptions::empty, kNan},
      {"echo_depth", &SonarModelOptions::echo_depth, 0.4},
      {"echo_depth", &SonarModelOptions::echo_depth, 8.1},
      {"echo_depth", &SonarModelOptions::echo_depth, -1.0},
      {"echo_depth", &SonarModelOptions::echo_depth, kNoEcho},
      {"echo_depth", &SonarModelOptions::echo_depth, kNan},
  };
  for (const BadOption& bad : cases) {
    SonarModelOptions options;
    options.*bad.option = bad.value;
    try {
      const SonarModel model(options);
      ADD_FAILURE() << bad.name << " = " << bad.value << " was taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(std::string(bad.name) + " must"), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace place_memory::core
