#include "experiments/trial_runner.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <cmath>
#include <limits>

#include "core/index/place_index.h"
#include "core/recognize/recognizer.h"
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

class Memory {
 public:
  Memory(const trials::TrialSet& set, const Method& method)
      : sonar_(method.parameters.sonar), recognizer_(method.parameters.match.recognizer) {
    geometry_.cell_size = set.cell_size;
    for (const trials::LearnedScan& scan : set.learned) {
      places_.emplace_back(scan.label, scan.odom_from_scan);
      const auto id = static_cast<core::PlaceId>(places_.size());
      index_.put(id, sonar_.build(scan.readings, geometry_));
    }
  }

  Answer answer(const trials::RecognitionTrial& trial) const { return answer(trial, index_); }

  Answer answerStranger(const trials::RecognitionTrial& trial) const {
    Answer answer = this->answer(trial);
    answer.stranger = true;
    return answer;
  }

  /// As if the places near the scan had never been learned.
  Answer answerUnlearned(trials::RecognitionTrial trial) const {
    core::PlaceIndex others = index_;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const auto& [label, pose] = places_[i];
      const double distance =
          std::hypot(pose.x - trial.odom_from_scan.x, pose.y - trial.odom_from_scan.y);
      const bool is_right = std::count(trial.accept.begin(), trial.accept.end(), label) > 0;
      if (is_right || distance < kNear) others.erase(static_cast<core::PlaceId>(i + 1));
    }
    trial.accept.clear();
    return answer(trial, others);
  }

 private:
  Answer answer(const trials::RecognitionTrial& trial, const core::PlaceIndex& index) const {
    core::Scan scan;
    scan.readings = trial.readings;
    scan.grid = sonar_.build(trial.readings, geometry_);
    const auto frames = [this](const std::vector<core::PlaceId>& ids) {
      std::vector<core::PlaceFrame> of;
      for (const core::PlaceId id : ids) {
        of.push_back({places_[static_cast<std::size_t>(id - 1)].second});
      }
      return std::optional(of);
    };
    const core::Recognition found =
        recognizer_.recognize(scan, index, frames, trial.heading_window).value();
    if (found.matches.empty()) return judge(trial, found, "");
    const core::PlaceId best = found.matches.front().id;
    return judge(trial, found, places_[static_cast<std::size_t>(best - 1)].first);
  }

  core::SonarModel sonar_;
  core::Recognizer recognizer_;
  core::GridGeometry geometry_;
  core::PlaceIndex index_;
  std::vector<std::pair<std::string, core::Pose2d>> places_;  ///< of place 1, 2, ...
};

}  // namespace

Answer judge(const trials::RecognitionTrial& trial, const core::Recognition& found,
             const std::string& given) {
  Answer answer;
  answer.known = !trial.accept.empty();
  answer.expected = boost::algorithm::join(trial.accept, " ");
  answer.round = trial.round;
  answer.verdict = found.verdict;
  answer.distance = answer.position_error = answer.heading_error = answer.normalised_error = kNone;
  if (found.matches.empty()) return answer;
  answer.given = given;
  answer.probability = found.matches.front().probability;
  answer.right = std::count(trial.accept.begin(), trial.accept.end(), given) > 0;
  const core::Pose2d& truth = trial.odom_from_scan;
  const Eigen::Vector3d error(found.map_from_robot.x - truth.x, found.map_from_robot.y - truth.y,
                              core::wrapAngle(found.map_from_robot.yaw - truth.yaw));
  answer.distance = error.head<2>().norm();
  if (!answer.right) return answer;
  answer.position_error = answer.distance;
  answer.heading_error = std::abs(error.z());
  answer.normalised_error = normalisedError(error, found.covariance);
  return answer;
}

std::vector<Answer> runTrials(const Batch& batch, const Method& method) {
  const Memory memory(batch.known, method);
  std::vector<Answer> answers;
  for (const auto& trial : batch.known.trials) answers.push_back(memory.answer(trial));
  for (const auto& trial : batch.strangers) answers.push_back(memory.answerStranger(trial));
  const std::size_t unlearned = std::min(batch.unlearned, batch.known.trials.size());
  for (std::size_t i = 0; i < unlearned; ++i) {
    answers.push_back(
        memory.answerUnlearned(batch.known.trials[i * batch.known.trials.size() / unlearned]));
  }
  return answers;
}

}  // namespace place_memory::experiments
