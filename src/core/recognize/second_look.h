#ifndef PLACE_MEMORY_CORE_RECOGNIZE_SECOND_LOOK_H
#define PLACE_MEMORY_CORE_RECOGNIZE_SECOND_LOOK_H

#include <array>
#include <cstddef>
#include <vector>

#include "core/match/query_planes.h"

namespace place_memory::core {

/// How many of the places that score best are looked at again.
constexpr std::size_t kLookedAtAgain = 10;

/// Cells of one grid that lie near cells of the other, along rows and columns and diagonally.
enum class NearCells : std::size_t {
  kOccupiedWithinOne,         ///< the scan's occupied cells up to one cell from learned ones
  kOccupiedWithinTwo,         ///< up to two cells
  kLearnedOccupiedWithinOne,  ///< learned occupied cells up to one cell from the scan's
  kLearnedOccupiedWithinTwo,  ///< up to two cells
  kWithinOneOfBoth,           ///< any cells up to one cell from occupied ones of both
  kEmptyByOccupied,           ///< the scan's empty cells up to one cell from learned occupied ones
  kOccupiedByEmpty,           ///< learned empty cells up to one cell from the scan's occupied ones
};
constexpr std::size_t kNearCells = 7;
/// Their names in preset files.
constexpr std::array<const char*, kNearCells> kNearCellsNames{"occupied_within_one",
                                                              "occupied_within_two",
                                                              "learned_occupied_within_one",
                                                              "learned_occupied_within_two",
                                                              "within_one_of_both",
                                                              "empty_by_occupied",
                                                              "occupied_by_empty"};

/// What a closer look at an alignment tells.
struct CloseCounts {
  /// Pairs of corresponding cells up to nine cells from the place, which sonar sees best.
  PairCounts inner{};
  PairCounts middle{};  ///< likewise from there to seventeen cells
  std::array<int, kNearCells> near{};

  int of(NearCells cells) const { return near[static_cast<std::size_t>(cells)]; }
};

/// Of a turned and then shifted recognition grid and a learned grid. Shifts in [-63, 63].
CloseCounts countClosely(const CellPlanes& recognition, CellShift shift, const CellPlanes& learned);

/// How the first look's score changes beside an alignment: it falls all around where the grids fit,
/// and hardly along a hallway or where they fit by chance.
struct Falloff {
  double beside = 0.0;  ///< by a shift of two cells, the mean of four
  double turned = 0.0;  ///< by a turn of two heading steps, the mean of those in the window
};

/// A richer metric for the few places that the search ranks first: an echo a cell off, which the
/// first look calls a contradiction, is nearly as good as one in its place.
struct SecondLook {
  double first = 1.0;  ///< of the score of the first look
  PairWeights inner{};
  PairWeights middle{};
  std::array<double, kNearCells> near{};
  double beside = 0.0;  ///< of Falloff::beside
  double turned = 0.0;  ///< of Falloff::turned
};

double scoreAgain(double first_score, const CloseCounts& counts, const Falloff& falloff,
                  const SecondLook& look);

/// The scores of all places, of which `first` are those of the first look, falling, and `again`
/// those of the second look at the foremost of them: the others keep their distance to the last
/// that was looked at, and do not pass the least of the second look. `again` is not empty.
std::vector<double> combineLooks(const std::vector<double>& first,
                                 const std::vector<double>& again);

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_RECOGNIZE_SECOND_LOOK_H
