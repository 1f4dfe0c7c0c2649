#include "experiments/trial_runner.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "place_memory/core/place_index.h"
#include "place_memory/core/recognizer.h"
#include "place_memory/core/sonar_model.h"

namespace place_memory::experiments {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double normalisedError(const Eigen::Vector3d& error, const std::array<double, 9>& covariance) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> matrix(covariance.data());
  const Eigen::LDLT<Eigen::Matrix3d> factors(matrix);
  if (factors.info() != Eigen::Success || !factors.isPositive()) return kNone;
  return error.dot(factors.solve(error));
}

std::string joined(const std::vector<std::string>& labels) {
  std::string text;
  for (const std::string& label : labels) text += (text.empty() ? "" : " ") + label;
  return text;
}

class Memory {
 public:
  Memory(const trials::TrialSet& set, const Method& method)
      : sonar_(method.parameters.sonar), recognizer_(method.parameters.match.recognizer) {
    geometry_.cell_size = set.cell_size;
    for (const trials::LearnedScan& scan : set.learned) {
      labels_.push_back(scan.label);
      const auto id = static_cast<core::PlaceId>(labels_.size());
      index_.put(id, scan.map_from_scan, sonar_.build(scan.readings, geometry_));
    }
  }

  Answer answer(const trials::RecognitionTrial& trial) const {
    core::Scan scan;
    scan.readings = trial.readings;
    scan.grid = sonar_.build(trial.readings, geometry_);
    return judge(trial, recognizer_.recognize(scan, index_, trial.heading_window));
  }

 private:
  Answer judge(const trials::RecognitionTrial& trial, const core::Recognition& found) const {
    Answer answer;
    answer.known = !trial.accept.empty();
    answer.expected = joined(trial.accept);
    answer.verdict = found.verdict;
    answer.position_error = answer.heading_error = answer.normalised_error = kNone;
    if (found.matches.empty()) return answer;
    const core::PlaceMatch& best = found.matches.front();
    answer.given = labels_[static_cast<std::size_t>(best.id - 1)];
    answer.probability = best.probability;
    answer.right = std::count(trial.accept.begin(), trial.accept.end(), answer.given) > 0;
    if (!answer.right) return answer;
    const core::Pose2d& truth = trial.map_from_scan;
    const Eigen::Vector3d error(found.map_from_robot.x - truth.x, found.map_from_robot.y - truth.y,
                                core::wrapAngle(found.map_from_robot.yaw - truth.yaw));
    answer.position_error = error.head<2>().norm();
    answer.heading_error = std::abs(error.z());
    answer.normalised_error = normalisedError(error, found.covariance);
    return answer;
  }

  core::SonarModel sonar_;
  core::Recognizer recognizer_;
  core::GridGeometry geometry_;
  core::PlaceIndex index_;
  std::vector<std::string> labels_;  ///< of place 1, 2, ...
};

}  // namespace

std::vector<Answer> runTrials(const Batch& batch, const Method& method) {
  const Memory memory(batch.known, method);
  std::vector<Answer> answers;
  for (const auto& trial : batch.known.trials) answers.push_back(memory.answer(trial));
  for (const auto& trial : batch.strangers) answers.push_back(memory.answer(trial));
  return answers;
}

}  // namespace place_memory::experiments
