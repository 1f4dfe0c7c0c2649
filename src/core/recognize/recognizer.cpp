#include "core/recognize/recognizer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/match/place_search.h"
#include "core/recognize/consensus.h"
#include "core/recognize/falloff.h"
#include "core/recognize/pose_estimate.h"
#include "core/recognize/second_look.h"

namespace place_memory::core {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

bool sensedNothing(const EvidenceGrid& grid) {
  return std::all_of(grid.cells().begin(), grid.cells().end(),
                     [](std::int8_t evidence) { return evidence == 0; });
}

Pose2d poseOf(const Alignment& alignment, double cell_size) {
  return {alignment.shift.columns * cell_size, alignment.shift.rows * cell_size,
          wrapAngle(alignment.turn * kHeadingStep)};
}

/// Looks again at the foremost places and ranks anew.
void lookAgain(const QueryPlanes& query, const PlaceIndex& places, const LatticeMetric& metric,
               const SearchWindow& window, const SecondLook& look,
               std::vector<PlaceAlignment>& all) {
  std::vector<double> first, again;
  for (const PlaceAlignment& found : all) {
    const Alignment& alignment = found.alignment;
    first.push_back(alignment.score);
    if (again.size() >= kLookedAtAgain) continue;
    const CellPlanes cells = places.cells(found.place);
    again.push_back(scoreAgain(alignment.score,
                               countClosely(query.at(alignment.turn), alignment.shift, cells),
                               falloffAt(query, cells, metric, window, alignment), look));
  }
  const std::vector<double> scores = combineLooks(first, again);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].alignment.score = scores[i];
  const auto foremost = all.begin() + static_cast<std::ptrdiff_t>(again.size());
  std::stable_sort(all.begin(), foremost, [](const PlaceAlignment& a, const PlaceAlignment& b) {
    return a.alignment.score > b.alignment.score;
  });
}

std::vector<PlaceId> foremostOf(const std::vector<PlaceAlignment>& all) {
  std::vector<PlaceId> places;
  for (std::size_t i = 0; i < std::min(all.size(), kHeard); ++i) places.push_back(all[i].place);
  return places;
}

Consensus consensusOf(const std::vector<PlaceAlignment>& all, const std::vector<PlaceFrame>& frames,
                      bool located, double cell_size) {
  std::vector<Opinion> opinions;
  opinions.reserve(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const PlaceAlignment& found = all[i];
    const Pose2d place_from_scan = poseOf(found.alignment, cell_size);
    opinions.push_back({found.alignment.score, std::hypot(place_from_scan.x, place_from_scan.y),
                        std::nullopt, frames[i].session});
    if (located) opinions.back().map_from_scan = frames[i].map_from_place * place_from_scan;
  }
  return findConsensus(opinions, cell_size);
}

/// The robot's pose and its covariance, turned from the place's frame into the map's (paper 9).
void locate(const Scan& scan, const Pose2d& map_from_place, const PoseEstimate& estimate,
            Recognition& recognition) {
  recognition.matches.front().place_from_scan = estimate.place_from_scan;
  recognition.map_from_robot = map_from_place * estimate.place_from_scan * scan.robot_in_scan;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(map_from_place.yaw).toRotationMatrix();
  const Eigen::Matrix3d covariance = turn * estimate.covariance * turn.transpose();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      recognition.covariance[static_cast<std::size_t>(3 * row + column)] = covariance(row, column);
    }
  }
}

}  // namespace

Recognizer::Recognizer(const RecognizerOptions& options) : options_(options) {
  require(options.position_window > 0.0 && std::isfinite(options.position_window),
          "position_window must be above 0 m");
  for (const auto& row : options.metric.weights) {
    for (const double weight : row) require(std::isfinite(weight), "weights must be finite");
  }
  require(options.calibration.scale > 0.0 && std::isfinite(options.calibration.scale),
          "calibration scale must be above 0");
  require(options.confidence > 0.5 && options.confidence < 1.0, "confidence must lie in (0.5, 1)");
}

std::optional<Recognition> Recognizer::recognize(const Scan& scan, const PlaceIndex& places,
                                                 const LookUpFrames& look_up_frames,
                                                 double heading_window,
                                                 const std::function<bool()>& cancelled) const {
  require(heading_window >= 0.0 && heading_window <= kPi + 1e-6,
          "heading_window must lie in [0, pi]");
  const double cell_size = scan.grid.geometry().cell_size;
  const bool moves = options_.method != SearchMethod::kNearestNeighbour;
  const SearchWindow window =
      moves ? searchWindow(options_.position_window, heading_window, cell_size) : SearchWindow{};
  const LatticeMetric metric = onLattice(options_.metric, window, cell_size);
  const QueryPlanes query(scan.grid, kHeadingStep, window.turns);

  std::vector<PlaceAlignment> all =
      searchPlaces(query, places, metric, window, options_.method, cancelled);
  if (all.empty()) return Recognition{};
  if (options_.second_look) lookAgain(query, places, metric, window, *options_.second_look, all);
  const auto frames = look_up_frames(foremostOf(all));
  if (!frames) return std::nullopt;
  const Consensus consensus = consensusOf(all, *frames, options_.located, cell_size);
  const auto chosen = all.begin() + static_cast<std::ptrdiff_t>(consensus.chosen);
  std::rotate(all.begin(), chosen, chosen + 1);

  const CellPlanes cells = places.cells(all.front().place);

  Recognition recognition;
  recognition.matches.reserve(all.size());
  for (const PlaceAlignment& found : all) {
    recognition.matches.push_back(
        {found.place, found.alignment.score, poseOf(found.alignment, cell_size), 0.0});
  }
  // Unsensed cells may earn points, so scores alone do not tell such a scan from a good one.
  if (!sensedNothing(scan.grid)) {
    const Alignment& best = all.front().alignment;
    const CellPlanes& turned = query.at(best.turn);
    const Support support =
        supportOf(countPairs(turned, best.shift, cells), countClosely(turned, best.shift, cells),
                  countPairs(query.at(0), {0, 0}, CellPlanes(scan.grid)), consensus, all.size(),
                  options_.calibration.scale);
    judge(support, options_.calibration, options_.confidence, recognition);
  }
  locate(scan, (*frames)[consensus.chosen].map_from_place,
         estimatePose(query, cells, metric, window, all.front().alignment, cell_size,
                      options_.calibration.sharpness),
         recognition);
  return recognition;
}

}  // namespace place_memory::core
