#include "core/recognize/peak_sharpness.h"

#include <gtest/gtest.h>

#include "core/random_room.h"

namespace place_memory::core {
namespace {

double scoreOf(const QueryPlanes& query, const CellPlanes& learned, const LatticeMetric& metric,
               CellShift shift, int rotation) {
  const double moved = shift.columns * shift.columns + shift.rows * shift.rows;
  return pairScore(countPairs(query.at(rotation), shift, learned), metric.weights) -
         metric.shift_cost * moved - metric.rotation_cost * rotation * rotation;
}

class PeakSharpnessAt : public testing::Test {
 protected:
  PeakSharpness at(int rotation) const {
    Alignment alignment{{1, -1}, rotation, 0.0};
    alignment.score = scoreOf(query(), learned, metric, alignment.shift, rotation);
    return peakSharpness(query(), learned, metric, window, alignment);
  }
  double change(CellShift shift, int rotation, int from_rotation) const {
    return scoreOf(query(), learned, metric, shift, rotation) -
           scoreOf(query(), learned, metric, {1, -1}, from_rotation);
  }
  QueryPlanes query() const { return {grid, kHeadingStep, window.rotations}; }

  EvidenceGrid grid = RandomRoom(3).scanFrom({0.1, 0.2, 0.3}).grid;
  CellPlanes learned{RandomRoom(3).scanFrom({}).grid};
  LatticeMetric metric{{{{0.9, 0.6, -1.4}, {0.1, 0.2, -1.1}, {-2.2, -1.5, 3.5}}}, 0.1, 0.05, false};
  SearchWindow window{8, 10, false};
};

TEST_F(PeakSharpnessAt, IsTheMeanChangeBesideTheAlignment) {
  const PeakSharpness found = at(3);
  EXPECT_NEAR(found.shift,
              (change({3, -1}, 3, 3) + change({-1, -1}, 3, 3) + change({1, 1}, 3, 3) +
               change({1, -3}, 3, 3)) /
                  4.0,
              1e-9);
  EXPECT_NEAR(found.rotation, (change({1, -1}, 5, 3) + change({1, -1}, 1, 3)) / 2.0, 1e-9);
}

TEST_F(PeakSharpnessAt, AtTheEdgeOfTheHeadingWindowOneRotationIsLeft) {
  EXPECT_NEAR(at(10).rotation, change({1, -1}, 8, 10), 1e-9);
}

TEST_F(PeakSharpnessAt, AtTheLargestShiftNothingBeyondItIsAsked) {
  window.cells = kGridSize - 1;
  const Alignment corner{{kGridSize - 1, 1 - kGridSize}, 3, 0.0};
  const double inwards = (scoreOf(query(), learned, metric, {kGridSize - 3, 1 - kGridSize}, 3) +
                          scoreOf(query(), learned, metric, {kGridSize - 1, 3 - kGridSize}, 3)) /
                         2.0;
  EXPECT_NEAR(peakSharpness(query(), learned, metric, window, corner).shift, inwards, 1e-9);
}

TEST_F(PeakSharpnessAt, WithoutRotationsThereIsNone) {
  window.rotations = 0;
  EXPECT_EQ(at(0).rotation, 0.0);
}

TEST_F(PeakSharpnessAt, ACircularWindowGoesOnAtItsOtherEnd) {
  window = {8, kHalfCircle, true};
  metric.rotation_cost = 0.0;
  EXPECT_NEAR(at(59).rotation, (change({1, -1}, 57, 59) + change({1, -1}, -59, 59)) / 2.0, 1e-9);
}

}  // namespace
}  // namespace place_memory::core
