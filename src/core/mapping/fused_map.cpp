#include "core/mapping/fused_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

namespace place_memory::core {
namespace {

constexpr int kFinest = 8;         // cells of the map along one of a grid
constexpr int kStepsACell = 4;     // to which poses are rounded
constexpr double kFarthest = 1e7;  // from the origin: beyond it numbers do not tell cells apart [m]

/// What the grids of some places may reach.
struct Box {
  double left = std::numeric_limits<double>::infinity();
  double bottom = left;
  double right = -left;
  double top = -left;

  Box with(const Pose2d& pose, double reach) const {
    return {std::min(left, pose.x - reach), std::min(bottom, pose.y - reach),
            std::max(right, pose.x + reach), std::max(top, pose.y + reach)};
  }
  /// Cells of all tiles in it, of which it may begin and end in the middle.
  double cells(double resolution) const {
    const double tile = kTileSize * resolution;
    const double columns = std::floor(right / tile) - std::floor(left / tile) + 1.0;
    const double rows = std::floor(top / tile) - std::floor(bottom / tile) + 1.0;
    return columns * rows * kTileCells;
  }
};

/// Edits of names and links.
template <class Edit>
constexpr bool kIsInvisible =
    std::is_same_v<Edit, PlaceRenamed> || std::is_same_v<Edit, LinkAdded> ||
    std::is_same_v<Edit, LinkRemoved> || std::is_same_v<Edit, LinkLearned>;

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>((numbers.size() - 1) / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

}  // namespace

std::size_t FusedMap::TileHash::operator()(const TileAt& at) const {
  return static_cast<std::size_t>(static_cast<std::uint64_t>(at.first) * 0x9e3779b97f4a7c15U ^
                                  static_cast<std::uint64_t>(at.second) * 0xc2b2ae3d27d4eb4fU);
}

FusedMap::FusedMap(const FusedMapOptions& options, const GridGeometry& geometry, GridOf grid_of)
    : options_(options),
      grid_of_(std::move(grid_of)),
      resolution_(std::max(options.resolution, geometry.cell_size / kFinest)),
      step_(resolution_ / kStepsACell),
      yaw_step_(step_ / std::max(geometry.halfWidth(), step_)),
      reach_((geometry.halfWidth() + 0.5 * geometry.cell_size) * std::sqrt(2.0) + resolution_) {
  if (!(options.resolution > 0.0) || !std::isfinite(options.resolution)) {
    throw std::invalid_argument("the resolution of a map must be above 0");
  }
}

void FusedMap::add(const Place& place, std::shared_ptr<const EvidenceGrid> grid) {
  Entry& entry = entries_[place.id];
  entry.session = place.session;
  entry.map_from_place = place.map_from_place;
  entry.grid = std::move(grid);
}

struct FusedMap::Editor {
  FusedMap& map;

  void operator()(const PlaceAdded& edit) const { map.add(edit.place, edit.grid); }
  void operator()(const PlaceMoved& edit) const {
    const auto found = map.entries_.find(edit.id);
    if (found == map.entries_.end()) return;
    found->second.map_from_place = edit.map_from_place;
    found->second.session = edit.session;
  }
  void operator()(const GridAdapted& edit) const {
    const auto found = map.entries_.find(edit.id);
    if (found != map.entries_.end()) found->second.grid = edit.grid;
  }
  void operator()(const PlaceRemoved& edit) const { map.remove(edit.id); }
  void operator()(const MapCleared& /*edit*/) const {
    map.entries_.clear();
    map.tiles_.clear();
  }
  template <class Other>
  void operator()(const Other& /*edit*/) const {
    static_assert(kIsInvisible<Other>);
  }
};

bool showsInFusedMap(const MapChange& change) {
  return std::any_of(change.edits.begin(), change.edits.end(), [](const MapEdit& edit) {
    return std::visit([](const auto& kind) { return !kIsInvisible<std::decay_t<decltype(kind)>>; },
                      edit);
  });
}

void FusedMap::apply(const MapChange& change) {
  for (const MapEdit& edit : change.edits) std::visit(Editor{*this}, edit);
}

void FusedMap::remove(PlaceId id) {
  const auto found = entries_.find(id);
  if (found == entries_.end()) return;
  if (found->second.laid) lay(*found->second.laid, -1);
  entries_.erase(found);
}

void FusedMap::update() {
  choose();
  for (auto& [id, entry] : entries_) follow(id, entry);
}

void FusedMap::choose() {
  SessionId session = std::numeric_limits<SessionId>::max();
  for (auto& [id, entry] : entries_) {
    entry.chosen = false;
    session = std::min(session, entry.session);
  }
  std::vector<Entry*> candidates;
  Box box;
  std::size_t members = 0;
  for (auto& [id, entry] : entries_) {
    if (entry.session != session) continue;
    ++members;
    const Pose2d& at = entry.map_from_place;
    if (!(std::abs(at.x) <= kFarthest && std::abs(at.y) <= kFarthest)) continue;
    candidates.push_back(&entry);
    box = box.with(at, reach_);
  }
  if (!candidates.empty() && (candidates.size() > options_.most_places ||
                              box.cells(resolution_) > static_cast<double>(options_.most_cells))) {
    chooseMiddle(candidates);
  } else {
    for (Entry* entry : candidates) entry->chosen = true;
  }
  left_out_ = members - static_cast<std::size_t>(
                            std::count_if(candidates.begin(), candidates.end(),
                                          [](const Entry* entry) { return entry->chosen; }));
}

void FusedMap::chooseMiddle(std::vector<Entry*> candidates) {
  std::vector<double> xs, ys;
  for (const Entry* entry : candidates) {
    xs.push_back(entry->map_from_place.x);
    ys.push_back(entry->map_from_place.y);
  }
  const double x = median(std::move(xs));
  const double y = median(std::move(ys));
  const auto distance = [&](const Entry* entry) {
    return std::hypot(entry->map_from_place.x - x, entry->map_from_place.y - y);
  };
  // Of places as far off the one with the lower id comes first.
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](const Entry* a, const Entry* b) { return distance(a) < distance(b); });
  Box box;
  std::size_t chosen = 0;
  for (Entry* entry : candidates) {
    box = box.with(entry->map_from_place, reach_);
    if (box.cells(resolution_) > static_cast<double>(options_.most_cells)) return;
    entry->chosen = true;
    if (++chosen == options_.most_places) return;
  }
}

FusedMap::RoundedPose FusedMap::rounded(const Pose2d& pose) const {
  return {std::llround(pose.x / step_), std::llround(pose.y / step_),
          std::llround(wrapAngle(pose.yaw) / yaw_step_)};
}

void FusedMap::follow(PlaceId id, Entry& entry) {
  if (!entry.chosen) {
    if (entry.laid) lay(*entry.laid, -1);
    if (grid_of_) {
      entry.grid.reset();  // there may be any number of them
    } else if (!entry.grid && entry.laid) {
      entry.grid = entry.laid->grid;
    }
    entry.laid.reset();
    return;
  }
  const RoundedPose pose = rounded(entry.map_from_place);
  std::shared_ptr<const EvidenceGrid> grid = std::move(entry.grid);
  entry.grid.reset();
  if (!grid && entry.laid) grid = entry.laid->grid;
  if (!grid && grid_of_) grid = grid_of_(id);
  if (!grid) return;
  if (entry.laid && entry.laid->pose == pose && entry.laid->grid == grid) return;
  if (entry.laid) lay(*entry.laid, -1);
  entry.laid = Laid{pose, std::move(grid)};
  lay(*entry.laid, 1);
}

void FusedMap::lay(const Laid& laid, int sign) {
  const Pose2d pose{static_cast<double>(laid.pose.x) * step_,
                    static_cast<double>(laid.pose.y) * step_,
                    static_cast<double>(laid.pose.yaw) * yaw_step_};
  const GridSampling sampling(*laid.grid, pose, resolution_);
  const GridSampling::TileSpan span = sampling.span();
  TileEvidence evidence;
  for (std::int64_t row = span.first_row; row <= span.last_row; ++row) {
    for (std::int64_t column = span.first_column; column <= span.last_column; ++column) {
      if (!sampling.sample(column, row, evidence)) continue;
      Tile& tile = tiles_[{column, row}];
      for (std::size_t i = 0; i < evidence.size(); ++i) tile.sums[i] += sign * evidence[i];
      tile.places += sign;
      if (tile.places == 0) tiles_.erase({column, row});
    }
  }
}

FusedCells FusedMap::cells() const {
  FusedCells cells;
  cells.resolution = resolution_;
  if (tiles_.empty()) return cells;
  TileAt first = tiles_.begin()->first;
  TileAt last = first;
  for (const auto& [at, tile] : tiles_) {
    first = {std::min(first.first, at.first), std::min(first.second, at.second)};
    last = {std::max(last.first, at.first), std::max(last.second, at.second)};
  }
  cells.left = static_cast<double>(first.first * kTileSize) * resolution_;
  cells.bottom = static_cast<double>(first.second * kTileSize) * resolution_;
  cells.columns = static_cast<int>(last.first - first.first + 1) * kTileSize;
  cells.rows = static_cast<int>(last.second - first.second + 1) * kTileSize;
  const auto width = static_cast<std::size_t>(cells.columns);
  cells.evidence.resize(width * static_cast<std::size_t>(cells.rows));
  for (const auto& [at, tile] : tiles_) {
    std::size_t cell = static_cast<std::size_t>(at.second - first.second) * kTileSize * width +
                       static_cast<std::size_t>(at.first - first.first) * kTileSize;
    for (std::size_t i = 0; i < tile.sums.size(); i += kTileSize, cell += width) {
      for (std::size_t column = 0; column < kTileSize; ++column) {
        cells.evidence[cell + column] = static_cast<std::int8_t>(
            std::clamp(tile.sums[i + column], -EvidenceGrid::kLimit, EvidenceGrid::kLimit));
      }
    }
  }
  return cells;
}

}  // namespace place_memory::core
