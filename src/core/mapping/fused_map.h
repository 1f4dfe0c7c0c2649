#ifndef PLACE_MEMORY_CORE_MAPPING_FUSED_MAP_H
#define PLACE_MEMORY_CORE_MAPPING_FUSED_MAP_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/grid/grid_sampling.h"
#include "place_memory/core/evidence_grid.h"
#include "place_memory/core/map_change.h"
#include "place_memory/core/place.h"

namespace place_memory::core {

struct FusedMapOptions {
  /// Side of a cell [m], > 0. It is an eighth of a grid's cell at the least: finer ones would tell
  /// nothing more.
  double resolution = 0.05;
  std::size_t most_cells = 16'000'000;  ///< of the box that is mapped
  std::size_t most_places = 20'000;     ///< that are mapped: the grid of each is kept, 4 KB
};

/// Evidence for occupancy in the cells of a box, on the scale of EvidenceGrid.
struct FusedCells {
  double resolution = 0.0;  ///< side of a cell [m]
  double left = 0.0;        ///< least x of the box [m]
  double bottom = 0.0;      ///< least y of it [m]
  int columns = 0;
  int rows = 0;
  std::vector<std::int8_t> evidence;  ///< row by row, least y first; saturated
};

/// Whether the map may look different after the change: names and links do not show.
bool showsInFusedMap(const MapChange& change);

/// The building's map: the evidence of all places' grids, each laid where its place lies now, added
/// up cell by cell.
///
/// Sums are whole numbers, so that what a place has added can be taken away again: where a place
/// comes, moves, adapts or goes, the cells below it are recomputed and no others, and the map is
/// the same as one that is made anew. Poses are rounded to a quarter of a cell, so that corrections
/// that nobody could see cost nothing.
///
/// Places that lie in a frame of their own are not mixed in: those of the earliest session are
/// mapped. Nor may one that lies astray make the map huge: where the box that holds all of them has
/// too many cells, those nearest to the middle (the median) are mapped. Not thread-safe.
class FusedMap {
 public:
  /// The grid of a place that is to be laid and has none, or nullptr: it is asked for again then.
  using GridOf = std::function<std::shared_ptr<const EvidenceGrid>(PlaceId)>;

  /// `geometry`: of the places' grids. Throws std::invalid_argument where the options are out of
  /// range.
  FusedMap(const FusedMapOptions& options, const GridGeometry& geometry, GridOf grid_of = nullptr);

  /// Of a cell, as it came out [m].
  double resolution() const { return resolution_; }

  /// The place is there from now on; without a grid it is asked for when it is laid.
  void add(const Place& place, std::shared_ptr<const EvidenceGrid> grid = nullptr);
  /// Follows the map. Edits of places that it does not know change nothing.
  void apply(const MapChange& change);
  /// Lays what has changed since, and takes away what is gone.
  void update();

  /// As of the last update(): the box around what is sensed, in whole tiles; without a place it has
  /// no cell.
  FusedCells cells() const;
  /// As of the last update(): of the session that is mapped, and too far off.
  std::size_t leftOut() const { return left_out_; }

 private:
  /// A pose in whole steps.
  struct RoundedPose {
    std::int64_t x, y, yaw;
    bool operator==(const RoundedPose& other) const {
      return x == other.x && y == other.y && yaw == other.yaw;
    }
  };
  struct Laid {
    RoundedPose pose;
    std::shared_ptr<const EvidenceGrid> grid;
  };
  struct Entry {
    SessionId session = kNoSession;
    Pose2d map_from_place;
    std::shared_ptr<const EvidenceGrid> grid;  ///< to be laid; nullptr: to be asked for
    std::optional<Laid> laid;
    bool chosen = false;
  };
  struct Tile {
    std::array<std::int32_t, kTileCells> sums{};
    int places = 0;  ///< that say something of it
  };
  using TileAt = std::pair<std::int64_t, std::int64_t>;  ///< column, row
  struct TileHash {
    std::size_t operator()(const TileAt& at) const;
  };
  struct Editor;

  void choose();
  void chooseMiddle(std::vector<Entry*> candidates);
  void follow(PlaceId id, Entry& entry);
  void remove(PlaceId id);
  RoundedPose rounded(const Pose2d& pose) const;
  void lay(const Laid& laid, int sign);

  FusedMapOptions options_;
  GridOf grid_of_;
  double resolution_;
  double step_;      ///< to which poses are rounded [m]
  double yaw_step_;  ///< [rad]
  double reach_;     ///< of a grid around its place [m]
  std::map<PlaceId, Entry> entries_;
  std::unordered_map<TileAt, Tile, TileHash> tiles_;
  std::size_t left_out_ = 0;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAPPING_FUSED_MAP_H
