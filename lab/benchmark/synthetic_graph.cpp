#include "synthetic_graph.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace place_memory::measure {
namespace {

using core::Pose2d;

constexpr double kSpacing = 1.5;  // [m]
constexpr std::size_t kMatchEvery = 4;
constexpr double kDegree = core::kPi / 180.0;

struct Noise {
  double position;  // [m]
  double yaw;       // [rad]
};
constexpr Noise kOdometry{0.05, 1.5 * kDegree};
constexpr Noise kMatch{0.05, 1.5 * kDegree};
constexpr double kDoubt = 2.0;

class GraphMaker {
 public:
  explicit GraphMaker(std::uint64_t seed) : random_(seed) {}

  void add(std::vector<Pose2d> truth) { truth_ = std::move(truth); }

  void relate(std::size_t from, std::size_t to, const Noise& noise, double doubt) {
    const Pose2d error{noise.position * normal_(random_), noise.position * normal_(random_),
                       noise.yaw * normal_(random_)};
    core::RelativePose relative;
    relative.from = from;
    relative.to = to;
    relative.relative = truth_[from].inverse() * truth_[to] * error;
    relative.information =
        Eigen::Vector3d(1.0 / (noise.position * noise.position),
                        1.0 / (noise.position * noise.position), 1.0 / (noise.yaw * noise.yaw))
            .asDiagonal();
    relative.doubt = doubt;
    graph_.relatives.push_back(relative);
  }

  void relateInTurn() {
    for (std::size_t i = 1; i < truth_.size(); ++i) relate(i - 1, i, kOdometry, 0.0);
    graph_.held.assign(truth_.size(), 0);
    graph_.held[0] = 1;
    graph_.poses = truth_;
  }

  void reckon() {
    for (std::size_t i = 1; i < truth_.size(); ++i) {
      graph_.poses[i] = graph_.poses[i - 1] * graph_.relatives[i - 1].relative;
    }
  }

  core::RelaxationProblem take() { return std::move(graph_); }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::vector<Pose2d> truth_;
  core::RelaxationProblem graph_;
};

std::size_t poseAt(std::size_t row, std::size_t column, std::size_t length) {
  return row * length + (row % 2 == 0 ? column : length - 1 - column);
}

}  // namespace

core::RelaxationProblem makeGraph(std::size_t rows, std::size_t length, std::uint64_t seed) {
  GraphMaker maker(seed);
  std::vector<Pose2d> truth;
  for (std::size_t i = 0; i < rows * length; ++i) {
    const std::size_t row = i / length, along = i % length;
    const std::size_t column = row % 2 == 0 ? along : length - 1 - along;
    truth.push_back({kSpacing * static_cast<double>(column), kSpacing * static_cast<double>(row),
                     row % 2 == 0 ? 0.0 : core::kPi});
  }
  maker.add(std::move(truth));
  maker.relateInTurn();
  for (std::size_t row = 1; row < rows; ++row) {
    for (std::size_t column = row % kMatchEvery; column < length; column += kMatchEvery) {
      maker.relate(poseAt(row - 1, column, length), poseAt(row, column, length), kMatch, kDoubt);
    }
  }
  return maker.take();
}

core::RelaxationProblem makeGraphBeforeLoop(std::size_t rows, std::size_t length,
                                            std::uint64_t seed) {
  core::RelaxationProblem graph = makeGraph(rows, length, seed);
  core::RelaxationProblem before = graph;
  const std::size_t last_row = (rows - 1) * length;
  const auto is_new = [&](const core::RelativePose& relative) {
    return relative.doubt > 0.0 && relative.to >= last_row;
  };
  before.relatives.erase(std::remove_if(before.relatives.begin(), before.relatives.end(), is_new),
                         before.relatives.end());
  core::relax(before, {4, 1e-3});
  graph.poses = before.poses;
  return graph;
}

core::RelaxationProblem makeRound(std::size_t poses, std::uint64_t seed) {
  GraphMaker maker(seed);
  std::vector<Pose2d> truth;
  const double turn = 2.0 * core::kPi / static_cast<double>(poses);
  const double radius = kSpacing / turn;
  for (std::size_t i = 0; i < poses; ++i) {
    const double angle = turn * static_cast<double>(i);
    truth.push_back(
        {radius * std::sin(angle), radius * (1.0 - std::cos(angle)), core::wrapAngle(angle)});
  }
  maker.add(std::move(truth));
  maker.relateInTurn();
  for (std::size_t i = 0; i < 5 && i < poses / 2; ++i) {
    maker.relate(i, poses - 5 + i, kMatch, kDoubt);
  }
  maker.reckon();
  return maker.take();
}

}  // namespace place_memory::measure
