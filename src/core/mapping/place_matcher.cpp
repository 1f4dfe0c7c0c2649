#include "core/mapping/place_matcher.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kMostFits = 10;
constexpr SessionId kOneSession = 1;  ///< all places of a matcher lie in one frame

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
  index_.put(id, grid);
  frames_[id] = map_from_grid;
}

void PlaceMatcher::move(PlaceId id, const Pose2d& map_from_grid) { frames_[id] = map_from_grid; }

bool PlaceMatcher::erase(PlaceId id) {
  frames_.erase(id);
  return index_.erase(id);
}

void PlaceMatcher::takeAll(const PlaceMatcher& other) {
  for (const auto& block : other.index_.blocks()) {
    for (std::size_t slot = 0; slot < block->size(); ++slot) {
      index_.put((*block)[slot], block->planes().get(slot));
    }
  }
  frames_.insert(other.frames_.begin(), other.frames_.end());
}

std::vector<PlaceFit> PlaceMatcher::recognize(const EvidenceGrid& scan,
                                              double heading_window) const {
  std::vector<PlaceFit> fits;
  if (index_.size() == 0) return fits;
  const LookUpFrames frames = [this](const std::vector<PlaceId>& ids) {
    std::vector<PlaceFrame> found;
    found.reserve(ids.size());
    for (const PlaceId id : ids) found.push_back({frames_.at(id), kOneSession});
    return std::make_optional(found);
  };
  const Recognition found = *recognizer_.recognize(scanOf(scan), index_, frames, heading_window);
  for (const PlaceMatch& match : found.matches) {
    if (fits.size() == kMostFits) break;
    fits.push_back({match.id, match.probability, match.score, match.place_from_scan,
                    Eigen::Matrix3d::Identity()});
  }
  return fits;
}

PlaceFit PlaceMatcher::align(const EvidenceGrid& scan, PlaceId id, double heading_window) const {
  PlaceIndex alone;
  alone.put(id, index_.cells(id));
  const LookUpFrames frames = [](const std::vector<PlaceId>& ids) {
    return std::make_optional(std::vector<PlaceFrame>(ids.size(), {Pose2d{}, kOneSession}));
  };
  const Recognition found = *recognizer_.recognize(scanOf(scan), alone, frames, heading_window);
  const PlaceMatch& match = found.matches.front();
  return {id, match.probability, match.score, match.place_from_scan, asMatrix(found.covariance)};
}

}  // namespace place_memory::core
