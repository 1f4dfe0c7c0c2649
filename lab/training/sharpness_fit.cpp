#include "training/sharpness_fit.h"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "core/recognize/scan_query.h"
#include "place_memory/core/recognizer_options.h"

namespace place_memory::training {
namespace {

constexpr double kDimensions = 3.0;
constexpr std::size_t kCandidates = 80;
/// Alignments further from the truth are wrong, not imprecise [cells, heading steps].
constexpr double kImprecise = 3.5;

double candidate(std::size_t i) { return std::exp2(3.0 - static_cast<double>(i) / 8.0); }

/// Sum of the normalised squared errors for each candidate.
struct Errors {
  std::array<double, kCandidates> sums{};
  double count = 0.0;
};

void addTrial(const trials::TrialSet& set, const trials::RecognitionTrial& trial,
              const trials::LearnedScan& learned, const core::SonarModel& model,
              const core::MatchMetric& metric, Errors& errors) {
  core::RecognizerOptions options;
  options.metric = metric;
  const core::ScanQuery query(model.build(trial.readings, {set.cell_size}), options,
                              trial.heading_window);
  const core::CellPlanes place(model.build(learned.readings, {set.cell_size}));
  const core::Alignment best = query.align(place);
  const core::Pose2d truth = learned.odom_from_scan.inverse() * trial.odom_from_scan;
  if (std::hypot(best.shift.columns - truth.x / set.cell_size,
                 best.shift.rows - truth.y / set.cell_size) > kImprecise ||
      std::abs(core::wrapAngle(best.rotation * core::kHeadingStep - truth.yaw)) >
          kImprecise * core::kHeadingStep) {
    return;
  }
  errors.count += 1.0;
  for (std::size_t i = 0; i < kCandidates; ++i) {
    const core::PoseEstimate estimate = core::estimatePose(
        query.planes(), place, query.metric(), query.window(), best, set.cell_size, candidate(i));
    const core::Pose2d& pose = estimate.place_from_scan;
    const Eigen::Vector3d error(pose.x - truth.x, pose.y - truth.y,
                                core::wrapAngle(pose.yaw - truth.yaw));
    errors.sums[i] += error.dot(estimate.covariance.inverse() * error);
  }
}

}  // namespace

double fitSharpness(const std::vector<trials::TrialSet>& sets, const core::SonarModel& model,
                    const core::MatchMetric& metric) {
  Errors errors;
  for (const trials::TrialSet& set : sets) {
    if (!set.turns_truly) continue;
    for (const trials::RecognitionTrial& trial : set.trials) {
      for (const trials::LearnedScan& learned : set.learned) {
        if (trial.accept.empty() || learned.label != trial.accept.front()) continue;
        addTrial(set, trial, learned, model, metric, errors);
      }
    }
  }
  if (errors.count == 0.0) throw std::runtime_error("no scan tells of the pose's covariance");
  std::size_t best = 0;
  double least = INFINITY;
  for (std::size_t i = 0; i < kCandidates; ++i) {
    const double off = std::abs(std::log(errors.sums[i] / errors.count / kDimensions));
    if (off < least) {
      least = off;
      best = i;
    }
  }
  return candidate(best);
}

}  // namespace place_memory::training
