#include "core/mapping/place_matcher.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kMostFits = 10;

Scan scanOf(const EvidenceGrid& grid) {
  Scan scan;
  scan.grid = grid;
  return scan;
}

Eigen::Matrix3d asMatrix(const std::array<double, 9>& covariance) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(covariance.data());
}

}  // namespace

PlaceMatcher::PlaceMatcher(const RecognizerOptions& options) : recognizer_(options) {}

void PlaceMatcher::put(PlaceId id, const Pose2d& map_from_grid, const EvidenceGrid& grid) {
  index_.put(id, map_from_grid, grid);
}

void PlaceMatcher::move(PlaceId id, const Pose2d& map_from_grid) {
  index_.put(id, map_from_grid, index_.cells(id));
}

void PlaceMatcher::takeAll(const PlaceMatcher& other) {
  for (const auto& block : other.index_.blocks()) {
    for (std::size_t slot = 0; slot < block->size(); ++slot) {
      index_.put((*block)[slot].id, (*block)[slot].map_from_place, block->planes().get(slot));
    }
  }
}

std::vector<PlaceFit> PlaceMatcher::recognize(const EvidenceGrid& scan,
                                              double heading_window) const {
  std::vector<PlaceFit> fits;
  if (index_.size() == 0) return fits;
  const Recognition found = recognizer_.recognize(scanOf(scan), index_, heading_window);
  for (const PlaceMatch& match : found.matches) {
    if (fits.size() == kMostFits) break;
    fits.push_back({match.id, match.probability, match.score, match.place_from_scan,
                    Eigen::Matrix3d::Identity()});
  }
  return fits;
}

PlaceFit PlaceMatcher::align(const EvidenceGrid& scan, PlaceId id, double heading_window) const {
  PlaceIndex alone;
  alone.put(id, Pose2d{}, index_.cells(id));
  const Recognition found = recognizer_.recognize(scanOf(scan), alone, heading_window);
  const PlaceMatch& match = found.matches.front();
  return {id, match.probability, match.score, match.place_from_scan, asMatrix(found.covariance)};
}

}  // namespace place_memory::core
