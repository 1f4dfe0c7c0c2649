#include "place_memory/core/recognizer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "place_memory/core/alignment_search.h"

namespace place_memory::core {
namespace {

/// At the rim of the paper's grid one step moves a cell by less than two cells.
constexpr double kHeadingStep = 3.0 * kPi / 180.0;
constexpr int kHalfCircle = 60;  ///< heading steps in pi

void require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

SearchWindow searchWindow(double position_window, double heading_window, double cell_size) {
  SearchWindow window;
  const double cells = std::ceil(position_window / cell_size);
  window.cells = static_cast<int>(std::min(cells, kGridSize - 1.0));
  window.turns = static_cast<int>(std::ceil(heading_window / kHeadingStep - 1e-6));
  window.circular = window.turns >= kHalfCircle;
  if (window.circular) window.turns = kHalfCircle;
  return window;
}

bool sensedNothing(const EvidenceGrid& grid) {
  return std::all_of(grid.cells().begin(), grid.cells().end(),
                     [](std::int8_t evidence) { return evidence == 0; });
}

/// Probabilities and verdict from the ranked scores.
void judge(const RecognizerOptions& options, Recognition& recognition) {
  if (recognition.matches.empty()) return;
  const double scale = options.calibration.scale;
  const double top = std::max(recognition.matches.front().score, options.calibration.stranger);
  const double none = std::exp(scale * (options.calibration.stranger - top));
  double all = none;
  for (const PlaceMatch& match : recognition.matches) all += std::exp(scale * (match.score - top));
  for (PlaceMatch& match : recognition.matches) {
    match.probability = std::exp(scale * (match.score - top)) / all;
  }
  if (recognition.matches.front().probability >= options.confidence) {
    recognition.verdict = Verdict::kRecognized;
  } else {
    recognition.verdict = none / all > 0.5 ? Verdict::kUnknown : Verdict::kAmbiguous;
  }
}

}  // namespace

Recognizer::Recognizer(const RecognizerOptions& options) : options_(options) {
  require(options.position_window > 0.0 && std::isfinite(options.position_window),
          "position_window must be above 0 m");
  require(options.calibration.scale > 0.0, "calibration scale must be above 0");
  require(options.confidence > 0.5 && options.confidence < 1.0, "confidence must lie in (0.5, 1)");
}

Recognition Recognizer::recognize(const Scan& scan, const PlaceIndex& places, double heading_window,
                                  const std::function<bool()>& cancelled) const {
  require(heading_window >= 0.0 && heading_window <= kPi + 1e-6,
          "heading_window must lie in [0, pi]");
  const double cell_size = scan.grid.geometry().cell_size;
  const SearchWindow window = searchWindow(options_.position_window, heading_window, cell_size);
  const QueryPlanes query(scan.grid, kHeadingStep, window.turns);

  Recognition recognition;
  recognition.matches.reserve(places.size());
  const PlaceIndex::Entry* best = nullptr;
  double best_score = 0.0;
  for (const auto& block : places.blocks()) {
    if (cancelled && cancelled()) throw std::runtime_error("recognition was cancelled");
    for (const PlaceIndex::Entry& entry : *block) {
      const Alignment found =
          findAlignment(query, entry.planes, options_.weights, window, options_.method);
      const Pose2d place_from_scan{found.shift.columns * cell_size, found.shift.rows * cell_size,
                                   wrapAngle(found.turn * kHeadingStep)};
      recognition.matches.push_back({entry.id, found.score, place_from_scan, 0.0});
      if (best == nullptr || found.score > best_score) {
        best = &entry;
        best_score = found.score;
      }
    }
  }
  if (best == nullptr) return recognition;
  std::stable_sort(recognition.matches.begin(), recognition.matches.end(),
                   [](const PlaceMatch& a, const PlaceMatch& b) { return a.score > b.score; });
  // Unsensed cells may earn points, so scores alone do not tell such a scan from a good one.
  if (!sensedNothing(scan.grid)) judge(options_, recognition);
  recognition.map_from_robot =
      best->map_from_place * recognition.matches.front().place_from_scan * scan.robot_in_scan;
  const double position_variance = cell_size * cell_size;
  const double heading_variance = kHeadingStep * kHeadingStep;
  recognition.covariance = {position_variance, 0, 0, 0, position_variance, 0, 0, 0,
                            heading_variance};
  return recognition;
}

}  // namespace place_memory::core
