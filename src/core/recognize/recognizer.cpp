#include "core/recognize/recognizer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/kernels/cpu.h"
#include "core/recognize/ranking.h"
#include "core/recognize/scan_query.h"
#include "core/recognize/verdict.h"
#include "core/sensing/scan_echoes.h"
#include "support/worker_pool.h"

namespace place_memory::core {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

std::shared_ptr<support::WorkerPool> poolOf(std::size_t threads) {
  if (threads > 0) return std::make_shared<support::WorkerPool>(threads);
  return {std::shared_ptr<void>(), &support::WorkerPool::shared()};
}

/// The robot's pose by the best match and its covariance (paper 9).
void locate(const Scan& scan, const Pose2d& map_from_place, const PoseEstimate& estimate,
            Recognition& recognition) {
  recognition.matches.front().place_from_scan = estimate.place_from_scan;
  const RobotPose robot = robotPose(map_from_place, estimate, scan.robot_in_scan);
  recognition.map_from_robot = robot.map_from_robot;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column) {
      recognition.covariance[static_cast<std::size_t>(3 * row + column)] =
          robot.covariance(row, column);
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
  require(options.threads <= kMostThreads, "threads must lie in [0, 256]");
  chosenInstructionSet();  // what is wrong with the variable is said now, not by the first scan
  pool_ = poolOf(options.threads);
}

std::optional<Recognition> Recognizer::recognize(const Scan& scan, const PlaceIndex& places,
                                                 const LookUpFrames& look_up_frames,
                                                 double heading_window,
                                                 const std::function<bool()>& cancelled) const {
  require(heading_window >= 0.0 && heading_window <= kPi + 1e-6,
          "heading_window must lie in [0, pi]");
  const ScanQuery query(scan.grid, options_, heading_window);
  const std::vector<PlaceAlignment> found = query.alignAll(places, cancelled, *pool_);
  Recognition recognition;
  recognition.no_echo = !holdsEcho(scan);
  if (found.empty()) return recognition;

  AlignedPlaces aligned;
  aligned.own = query.ownPairs();
  aligned.cell_size = query.cellSize();
  aligned.places.reserve(found.size());
  for (const PlaceAlignment& place : found) {
    aligned.places.push_back({place.alignment.score, query.poseOf(place.alignment)});
  }
  aligned.counts = [&](std::size_t i) {
    return query.countsAt(found[i].alignment, places.cells(found[i].place));
  };
  aligned.frames = [&](const std::vector<std::size_t>& numbers) {
    std::vector<PlaceId> ids;
    for (const std::size_t i : numbers) ids.push_back(found[i].place);
    return look_up_frames(ids);
  };
  const std::optional<Ranking> ranking = rankPlaces(aligned, options_);
  if (!ranking) return std::nullopt;

  recognition.matches.reserve(found.size());
  for (const RankedPlace& place : ranking->places) {
    recognition.matches.push_back({found[place.number].place, place.score,
                                   aligned.places[place.number].place_from_scan, 0.0});
  }
  // Empty and unsensed cells earn points: scores alone do not tell such a scan from a good one.
  if (!recognition.no_echo) {
    judge(ranking->features, options_.calibration, options_.confidence, recognition);
  }
  const PlaceAlignment& best = found[ranking->places.front().number];
  locate(scan, ranking->frame.map_from_place,
         query.estimate(best.alignment, places.cells(best.place)), recognition);
  return recognition;
}

}  // namespace place_memory::core
