#include "core/kernels/block_kernel.h"

#include <gtest/gtest.h>

#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace place_memory::core {
namespace {

/// Kernels may score few transforms, and what is left of many, in another way than many.
constexpr std::size_t kFewTransforms = 2;
constexpr std::size_t kManyTransforms = 33;
constexpr std::size_t kMostTransforms = 97;

std::vector<std::int64_t> makeOffsets() {
  constexpr std::int64_t kSome[] = {0, -40, 9, 9, -(std::int64_t{1} << 50)};
  std::vector<std::int64_t> offsets;
  for (std::size_t t = 0; t < kMostTransforms; ++t) offsets.push_back(kSome[t % std::size(kSome)]);
  return offsets;
}

const std::vector<std::int64_t> kOffsets = makeOffsets();

/// A class for each cell: 0 unsensed, 1 occupied, 2 empty.
using Draw = int (*)(std::mt19937& engine, std::size_t row, unsigned column);

struct NamedDraw {
  const char* name;
  Draw draw;
};

const NamedDraw kDraws[] = {
    {"any", [](std::mt19937& engine, std::size_t, unsigned) { return int(engine() % 3U); }},
    {"sparse", [](std::mt19937& engine, std::size_t,
                  unsigned) { return engine() % 40 == 0 ? 1 + int(engine() % 2U) : 0; }},
    {"unsensed", [](std::mt19937&, std::size_t, unsigned) { return 0; }},
    {"occupied", [](std::mt19937&, std::size_t, unsigned) { return 1; }},
    {"empty", [](std::mt19937&, std::size_t, unsigned) { return 2; }},
    {"rim",
     [](std::mt19937& engine, std::size_t row, unsigned column) {
       const bool rim = row == 0 || row == kGridSize - 1 || column == 0 || column == kGridSize - 1;
       return rim ? 1 + int(engine() % 2U) : 0;
     }},
};

QueryRow rowOf(const NamedDraw& draw, std::mt19937& engine, std::size_t row) {
  QueryRow drawn;
  for (unsigned column = 0; column < kGridSize; ++column) {
    const int cell = draw.draw(engine, row, column);
    const std::uint64_t bit = std::uint64_t{1} << column;
    if (cell == 1) drawn.occupied |= bit;
    if (cell == 2) drawn.empty |= bit;
  }
  return drawn;
}

struct Grids {
  std::vector<BlockRow> places;
  std::vector<QueryRow> query;
};

Grids draw(const NamedDraw& places, const NamedDraw& query, std::size_t rows,
           std::size_t transforms, unsigned seed) {
  std::mt19937 engine(seed);
  Grids grids{std::vector<BlockRow>(rows), {}};
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t place = 0; place < kBlockPlaces; ++place) {
      const QueryRow drawn = rowOf(places, engine, row);
      grids.places[row].occupied[place] = drawn.occupied;
      grids.places[row].empty[place] = drawn.empty;
    }
  }
  for (std::size_t i = 0; i < transforms * rows; ++i) {
    grids.query.push_back(rowOf(query, engine, i % rows));
  }
  return grids;
}

/// Cell by cell.
std::vector<BlockScores> naiveScores(const KernelInput& input) {
  std::vector<BlockScores> scores;
  for (std::size_t t = 0; t < input.transforms; ++t) {
    scores.emplace_back();
    scores[t].fill(input.offsets[t]);
  }
  const auto isSet = [](std::uint64_t word, unsigned column) { return (word >> column & 1U) != 0; };
  for (std::size_t t = 0; t < input.transforms; ++t) {
    for (std::size_t row = 0; row < input.rows; ++row) {
      const QueryRow& query = input.query[t * input.rows + row];
      for (std::size_t place = 0; place < kBlockPlaces; ++place) {
        for (unsigned column = 0; column < kGridSize; ++column) {
          const bool on_occupied = isSet(input.places[row].occupied[place], column);
          const bool on_empty = isSet(input.places[row].empty[place], column);
          if (isSet(query.occupied, column)) {
            if (on_occupied) scores[t][place] += input.factors.occupied_occupied;
            if (on_empty) scores[t][place] += input.factors.occupied_empty;
          }
          if (isSet(query.empty, column)) {
            if (on_occupied) scores[t][place] += input.factors.empty_occupied;
            if (on_empty) scores[t][place] += input.factors.empty_empty;
          }
        }
      }
    }
  }
  return scores;
}

class EachKernel : public testing::TestWithParam<KernelVariant<BlockKernel>> {
 protected:
  void SetUp() override {
    const auto& sets = instructionSets();
    if (std::count(sets.begin(), sets.end(), GetParam().set) == 0) {
      GTEST_SKIP() << "this processor lacks " << nameOf(GetParam().set);
    }
  }

  void expectOracle(const Grids& grids, std::size_t rows, std::size_t transforms,
                    const PairFactors& factors = {7, -5, -3, 2}) {
    const KernelInput input{grids.places.data(), grids.query.data(), rows, transforms, factors,
                            kOffsets.data()};
    std::vector<BlockScores> scores(input.transforms);
    const BlockBest best = GetParam().kernel(input, scores.data());
    ASSERT_EQ(scores, naiveScores(input));
    for (std::size_t place = 0; place < kBlockPlaces; ++place) {
      std::size_t first_best = 0;
      for (std::size_t t = 1; t < input.transforms; ++t) {
        if (scores[t][place] > scores[first_best][place]) first_best = t;
      }
      ASSERT_EQ(best.transform[place], static_cast<std::int64_t>(first_best));
      ASSERT_EQ(best.score[place], scores[first_best][place]);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(BlockKernel, EachKernel, testing::ValuesIn(blockKernels()),
                         [](const testing::TestParamInfo<KernelVariant<BlockKernel>>& variant) {
                           return std::string(nameOf(variant.param.set));
                         });

TEST_P(EachKernel, EqualsTheCountCellByCell) {
  unsigned seed = 0;
  for (const std::size_t rows :
       {std::size_t{4}, std::size_t{12}, std::size_t{16}, std::size_t{64}}) {
    for (const NamedDraw& places : kDraws) {
      for (const NamedDraw& query : kDraws) {
        const Grids grids = draw(places, query, rows, kManyTransforms, ++seed);
        SCOPED_TRACE(std::string(query.name) + " on " + places.name);
        for (const std::size_t transforms : {kFewTransforms, kManyTransforms}) {
          expectOracle(grids, rows, transforms);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
}

TEST_P(EachKernel, EachKindOfPairHasItsFactor) {
  const Grids grids = draw(kDraws[0], kDraws[0], kGridSize, kManyTransforms, 77);
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  for (const PairFactors& factors :
       {PairFactors{1, 0, 0, 0}, PairFactors{0, 1, 0, 0}, PairFactors{0, 0, 1, 0},
        PairFactors{0, 0, 0, 1}, PairFactors{kMost, kMost, kMost, kMost},
        PairFactors{kLeast, kLeast, kLeast, kLeast}, PairFactors{0, 0, 0, 0}}) {
    for (const std::size_t transforms : {kFewTransforms, kManyTransforms}) {
      expectOracle(grids, kGridSize, transforms, factors);
      if (HasFatalFailure()) return;
    }
  }
}

TEST_P(EachKernel, TakesAnyNumberOfTransforms) {
  for (const std::size_t rows : {std::size_t{4}, std::size_t{16}, std::size_t{60}}) {
    for (const std::size_t transforms :
         {1U, 2U, 3U, 4U, 5U, 9U, 10U, 31U, 32U, 33U, 41U, 42U, 97U}) {
      // Drawn one by one, so that a sanitizer sees what is read past the last transform.
      const Grids grids = draw(kDraws[0], kDraws[0], rows, transforms, 78);
      expectOracle(grids, rows, transforms);
      if (HasFatalFailure()) return;
    }
  }
}

}  // namespace
}  // namespace place_memory::core
