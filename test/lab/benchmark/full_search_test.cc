#include "benchmark/full_search.h"

#include <gtest/gtest.h>

#include "benchmark/synthetic_memory.h"
#include "core/match/lattice.h"

namespace place_memory::measure {
namespace {

using core::SearchMethod;

struct Case {
  double heading_window;
  core::PairWeights weights;
};

constexpr core::PairWeights kFitted{
    {{0.02, 0.015, -0.05}, {0.001, 0.002, -0.018}, {-0.06, -0.045, 0.1}}};

class FullSearchTest : public testing::TestWithParam<Case> {
 protected:
  static void SetUpTestSuite() { simulated_ = new SimulatedPlaces(simulatePlaces(21)); }
  static void TearDownTestSuite() { delete simulated_; }

  static const SimulatedPlaces* simulated_;
};

const SimulatedPlaces* FullSearchTest::simulated_ = nullptr;

TEST_P(FullSearchTest, FindsWhatTryingEverythingFinds) {
  const core::PlaceIndex index = SyntheticMemory(*simulated_, 21).map().index;
  const core::SearchWindow window =
      core::searchWindow(0.6, GetParam().heading_window, core::kDefaultCellSize);
  core::LatticeMetric metric;
  metric.weights = GetParam().weights;
  metric.shift_cost = 0.01;
  metric.rotation_cost = 0.02;
  for (const std::size_t q : {0U, 7U, 16U}) {
    const core::QueryPlanes query(simulated_->local[q].scan.grid, core::kHeadingStep,
                                  window.rotations);
    ScoredPlace expected;
    for (std::size_t i = 0; i < 21; ++i) {
      const core::CellPlanes place(simulated_->places[i].grid);
      const double score =
          core::findAlignment(query, place, metric, window, SearchMethod::kExhaustive).score;
      if (i > 0 && score <= expected.score) continue;
      expected = {static_cast<core::PlaceId>(i + 1), score};
    }
    const FullSearch search(query, metric, window);
    const ScoredPlace knowing_nothing = search.best(index, {});
    EXPECT_EQ(knowing_nothing.id, expected.id);
    EXPECT_EQ(knowing_nothing.score, expected.score);
    const core::CellPlanes other(simulated_->places[3].grid);
    const ScoredPlace known{
        4, core::findAlignment(query, other, metric, window, SearchMethod::kHillClimbing).score};
    const ScoredPlace found = search.best(index, known);
    EXPECT_EQ(found.id, expected.id);
    EXPECT_EQ(found.score, expected.score);
  }
}

TEST(FullSearch, RefusesAMetricThatItsBoundsDoNotHoldFor) {
  core::LatticeMetric metric;
  metric.overlap_only = true;
  const core::QueryPlanes query(core::EvidenceGrid(), core::kHeadingStep, 1);
  EXPECT_THROW(FullSearch(query, metric, {1, 1, false}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Cases, FullSearchTest,
                         testing::Values(Case{0.3, kFitted}, Case{core::kPi, kFitted},
                                         Case{0.3, core::kPaperWeights}));

}  // namespace
}  // namespace place_memory::measure
