#include "core/memory/twins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace place_memory::core {
namespace {

constexpr double kSameSpot = 2.0;     // [m]
constexpr double kSamePlace = 1.5;    // [m]
constexpr std::size_t kSectors = 12;  // of which the one where two places differ most is named

double distance(const Pose2d& one, const Pose2d& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

/// What most places score above, though more than half of them may look alike.
double commonScore(const std::vector<PlaceMatch>& matches) {
  std::vector<double> scores;
  for (const PlaceMatch& match : matches) scores.push_back(match.score);
  const auto least_tenth = scores.begin() + static_cast<std::ptrdiff_t>(scores.size() / 10);
  std::nth_element(scores.begin(), least_tenth, scores.end());
  return *least_tenth;
}

/// Where the two differ, found cell by cell.
void findPartingView(const EvidenceGrid& place, const EvidenceGrid& other, Twin& twin) {
  struct Sector {
    int cells = 0;
    double way = 0.0;
    double x = 0.0;
    double y = 0.0;
  };
  std::array<Sector, kSectors> sectors{};
  const GridGeometry& geometry = place.geometry();
  for (int row = 0; row < kGridSize; ++row) {
    for (int column = 0; column < kGridSize; ++column) {
      const int here = place.at(row, column);
      const Pose2d cell{geometry.centre(column), geometry.centre(row), 0.0};
      const Pose2d there = twin.other_from_place * cell;
      const int there_row = geometry.index(there.y);
      const int there_column = geometry.index(there.x);
      const bool is_inside =
          there_row >= 0 && there_row < kGridSize && there_column >= 0 && there_column < kGridSize;
      if (!is_inside || here * other.at(there_row, there_column) >= 0) continue;
      const double turn = (std::atan2(cell.y, cell.x) + kPi) / (2.0 * kPi);
      Sector& sector = sectors[static_cast<std::size_t>(turn * kSectors) % kSectors];
      ++sector.cells;
      sector.way += std::hypot(cell.x, cell.y);
      sector.x += cell.x;
      sector.y += cell.y;
    }
  }
  const Sector& best =
      *std::max_element(sectors.begin(), sectors.end(),
                        [](const Sector& a, const Sector& b) { return a.cells < b.cells; });
  if (best.cells == 0) return;
  twin.parting_bearing = std::atan2(best.y, best.x);
  twin.parting_distance = best.way / best.cells;
}

/// Finds the twins of each place.
class TwinSearch {
 public:
  TwinSearch(const PlaceMap& map, const PlaceIndex& index, const Recognizer& recognizer,
             const std::function<Scan(const Place&)>& scan_of, const TwinOptions& options)
      : map_(map), index_(index), recognizer_(recognizer), scan_of_(scan_of), options_(options) {}

  std::vector<Twin> run() {
    for (const Place& place : map_.places()) addTwinsOf(place);
    for (const Twin& twin : twins_) pairs_.emplace(twin.place, twin.other);
    for (Twin& twin : twins_) twin.parting_place = partingPlace(twin);
    std::stable_sort(twins_.begin(), twins_.end(),
                     [](const Twin& a, const Twin& b) { return a.likeness > b.likeness; });
    return std::move(twins_);
  }

 private:
  std::optional<std::vector<PlaceFrame>> framesOf(const std::vector<PlaceId>& ids) const {
    std::vector<PlaceFrame> frames;
    for (const PlaceId id : ids) {
      const Place& place = *map_.find(id);
      frames.push_back({place.map_from_place, place.session});
    }
    return frames;
  }

  void addTwinsOf(const Place& place) {
    const Scan scan = scan_of_(place);
    const Recognition found = *recognizer_.recognize(
        scan, index_, [this](const std::vector<PlaceId>& ids) { return framesOf(ids); },
        options_.heading_window);
    const auto self = std::find_if(found.matches.begin(), found.matches.end(),
                                   [&](const PlaceMatch& match) { return match.id == place.id; });
    if (self == found.matches.end() || found.no_echo) return;
    const double common = commonScore(found.matches);
    const double best = self->score - common;
    if (best <= 0.0) return;
    std::vector<Twin> twins;
    for (const PlaceMatch& match : found.matches) {
      const Place& other = *map_.find(match.id);
      const bool is_same_spot =
          other.session == place.session &&
          distance(place.map_from_place, other.map_from_place * match.place_from_scan) < kSameSpot;
      const double likeness = (match.score - common) / best;
      if (match.id == place.id || is_same_spot || likeness < options_.least_likeness) continue;
      Twin twin;
      twin.place = place.id;
      twin.other = match.id;
      twin.likeness = likeness;
      twin.other_from_place = match.place_from_scan;
      twins.push_back(twin);
    }
    std::stable_sort(twins.begin(), twins.end(),
                     [](const Twin& a, const Twin& b) { return a.likeness > b.likeness; });
    if (twins.size() > options_.most) twins.resize(options_.most);
    for (Twin& twin : twins) {
      findPartingView(scan.grid, scan_of_(*map_.find(twin.other)).grid, twin);
      twins_.push_back(twin);
    }
  }

  PlaceId partingPlace(const Twin& twin) const {
    const Place& place = *map_.find(twin.place);
    const Place& other = *map_.find(twin.other);
    PlaceId nearest = kNoPlace;
    double least_way = INFINITY;
    for (const PlaceId id : map_.neighbours(twin.place)) {
      const Place& neighbour = *map_.find(id);
      const Pose2d way = place.map_from_place.inverse() * neighbour.map_from_place;
      const double length = std::hypot(way.x, way.y);
      if (neighbour.session != place.session || length >= least_way) continue;
      const Pose2d there = other.map_from_place * twin.other_from_place * way;
      const bool is_twin_there =
          std::any_of(map_.places().begin(), map_.places().end(), [&](const Place& candidate) {
            return candidate.session == other.session &&
                   distance(candidate.map_from_place, there) < kSamePlace &&
                   pairs_.count({id, candidate.id}) > 0;
          });
      if (is_twin_there) continue;
      nearest = id;
      least_way = length;
    }
    return nearest;
  }

  const PlaceMap& map_;
  const PlaceIndex& index_;
  const Recognizer& recognizer_;
  const std::function<Scan(const Place&)>& scan_of_;
  const TwinOptions options_;
  std::vector<Twin> twins_;
  std::set<std::pair<PlaceId, PlaceId>> pairs_;
};

}  // namespace

std::vector<Twin> findTwins(const PlaceMap& map, const PlaceIndex& index,
                            const Recognizer& recognizer,
                            const std::function<Scan(const Place&)>& scan_of,
                            const TwinOptions& options) {
  return TwinSearch(map, index, recognizer, scan_of, options).run();
}

}  // namespace place_memory::core
