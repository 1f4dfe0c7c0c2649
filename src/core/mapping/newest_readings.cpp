#include "core/mapping/newest_readings.h"

#include <vector>

#include "core/sensing/moved_readings.h"

namespace place_memory::core {
namespace {

constexpr double kNear = 1.5;        // [m]
constexpr std::size_t kFewest = 15;  // readings
constexpr int kFewestCells = 20;     // that tell
constexpr double kDisagrees = 0.35;
constexpr double kSurelyDisagrees = 0.2;
constexpr double kHalvesDiffer = 0.25;
constexpr double kPassedWeight = 0.5;  // of known things that are looked through: cones are wide

int count(std::uint64_t bits) { return __builtin_popcountll(bits); }

/// Each cell that is set or has a neighbour that is.
BitPlane widened(const BitPlane& plane) {
  BitPlane along{}, wide{};
  for (std::size_t row = 0; row < plane.size(); ++row) {
    along[row] = plane[row] | plane[row] << 1U | plane[row] >> 1U;
  }
  for (std::size_t row = 0; row < plane.size(); ++row) {
    wide[row] = along[row];
    if (row > 0) wide[row] |= along[row - 1];
    if (row + 1 < plane.size()) wide[row] |= along[row + 1];
  }
  return wide;
}

}  // namespace

std::optional<double> agreement(const CellPlanes& seen, const CellPlanes& known) {
  const BitPlane known_about = widened(known.occupied), seen_about = widened(seen.occupied);
  int hits = 0, misses = 0, passed = 0;
  for (std::size_t row = 0; row < known_about.size(); ++row) {
    hits += count(seen.occupied[row] & known_about[row]);
    misses += count(seen.occupied[row] & known.empty[row] & ~known_about[row]);
    passed += count(seen.empty[row] & known.occupied[row] & ~seen_about[row]);
  }
  if (hits + misses + passed < kFewestCells) return std::nullopt;
  return hits / (hits + misses + kPassedWeight * passed);
}

NewestReadings::Agreement NewestReadings::agree(NodeIndex node, std::size_t first) const {
  const auto& readings = graph_.node(node).readings;
  if (!readings) return {};
  Agreement found{agree(node, first, readings->size()), false, false};
  found.disagrees = found.newest.value_or(1.0) < kDisagrees;
  if (!found.disagrees) return found;
  // Where things were moved, halves differ less than where the robot was.
  found.contradicts = *found.newest < kSurelyDisagrees ||
                      agree(node, 0, first).value_or(0.0) - *found.newest > kHalvesDiffer;
  return found;
}

std::optional<double> NewestReadings::agree(NodeIndex node, std::size_t first,
                                            std::size_t last) const {
  const ScanNode& scan = graph_.node(node);
  if (last < first + kFewest) return std::nullopt;
  const Pose2d middle = scan.pose * (*scan.readings)[(first + last) / 2].sensor_pose;
  const Pose2d then{middle.x, middle.y, scan.pose.yaw};
  const auto near = shelf_.nearSeen(then, scan.seen, scan.session, kNear);
  if (near.empty()) return std::nullopt;
  return agree(near.front().id,
               {scan.readings->begin() + static_cast<std::ptrdiff_t>(first),
                scan.readings->begin() + static_cast<std::ptrdiff_t>(last)},
               scan.pose);
}

std::optional<double> NewestReadings::agree(PlaceId place,
                                            const std::vector<SonarReading>& readings,
                                            const Pose2d& pose) const {
  const ScanNode& at = graph_.node(shelf_.nodeOf(place));
  const Pose2d map_from_grid = at.pose * baseFromGrid(at, at.laid_yaw);
  const EvidenceGrid grid =
      sonar_.build(movedReadings(readings, map_from_grid.inverse() * pose), geometry_);
  return agreement(CellPlanes(grid), shelf_.matcher(at.session)->cells(place));
}

std::optional<double> NewestReadings::agreeWith(PlaceId place, NodeIndex node,
                                                const Pose2d& pose) const {
  const auto& readings = graph_.node(node).readings;
  if (!readings || !shelf_.has(place)) return std::nullopt;
  return agree(place, *readings, pose);
}

}  // namespace place_memory::core
