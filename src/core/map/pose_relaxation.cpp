#include "core/map/pose_relaxation.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>

namespace place_memory::core {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
constexpr std::ptrdiff_t kHeld = -1;
constexpr double kLeastDamping = 1e-9;

Eigen::Vector3d residual(const Pose2d& from, const Pose2d& to, const Pose2d& relative) {
  const double c = std::cos(from.yaw), s = std::sin(from.yaw);
  const double dx = to.x - from.x, dy = to.y - from.y;
  return {c * dx + s * dy - relative.x, -s * dx + c * dy - relative.y,
          wrapAngle(to.yaw - from.yaw - relative.yaw)};
}

double believed(double chi_square, double doubt) {
  return doubt > 0.0 ? 1.0 / (1.0 + chi_square / (doubt * doubt)) : 1.0;
}

double costOf(double chi_square, double doubt) {
  if (doubt <= 0.0) return 0.5 * chi_square;
  return 0.5 * doubt * doubt * std::log1p(chi_square / (doubt * doubt));
}

Pose2d measured(const RelaxationProblem& problem, const RelativePose& relative) {
  return relative.way < 0.0
             ? relative.relative
             : problem.errors.corrected(relative.relative, relative.way, relative.turn);
}

double totalCost(const RelaxationProblem& problem) {
  double cost = 0.0;
  for (const RelativePose& relative : problem.relatives) {
    cost += costOf(chiSquare(problem, relative), relative.doubt);
  }
  for (const YawPrior& prior : problem.yaws) {
    const double error = wrapAngle(problem.poses[prior.pose].yaw - prior.yaw);
    cost += 0.5 * prior.information * error * error;
  }
  if (problem.find_errors) {
    cost += 0.5 * std::pow(problem.errors.bend / kBendSigma, 2) +
            0.5 * std::pow(problem.errors.turn_factor / kTurnFactorSigma, 2);
  }
  return cost;
}

/// By what everything is further off than it was said to be, at least 1.
double noiseFactor(const RelaxationProblem& problem) {
  double off = 0.0;
  std::ptrdiff_t known = static_cast<std::ptrdiff_t>(problem.yaws.size()) + 2;
  for (const RelativePose& relative : problem.relatives) {
    const double chi = chiSquare(problem, relative);
    off += chi * believed(chi, relative.doubt);
    known += 3;
  }
  for (const YawPrior& prior : problem.yaws) {
    const double error = wrapAngle(problem.poses[prior.pose].yaw - prior.yaw);
    off += prior.information * error * error;
  }
  const auto free = 3 * std::count(problem.held.begin(), problem.held.end(), 0) + 2;
  return known <= free ? 1.0 : std::max(1.0, std::sqrt(off / static_cast<double>(known - free)));
}

/// The normal equations of one step.
class Equations {
 public:
  explicit Equations(const RelaxationProblem& problem) : column_(problem.poses.size(), kHeld) {
    for (std::size_t i = 0; i < problem.poses.size(); ++i) {
      if (problem.held[i]) continue;
      column_[i] = size_;
      size_ += 3;
    }
    if (problem.find_errors) {
      errors_ = size_;
      size_ += 2;
    }
    matrix_.resize(size_, size_);
  }

  std::ptrdiff_t size() const { return size_; }

  void build(const RelaxationProblem& problem) {
    right_ = Eigen::VectorXd::Zero(size_);
    entries_.clear();
    for (const RelativePose& relative : problem.relatives) add(problem, relative);
    for (const YawPrior& prior : problem.yaws) add(problem, prior);
    if (errors_ != kHeld) {
      addPrior(errors_, problem.errors.bend, kBendSigma);
      addPrior(errors_ + 1, problem.errors.turn_factor, kTurnFactorSigma);
    }
    // Every diagonal entry is there, for the damping.
    for (std::ptrdiff_t i = 0; i < size_; ++i) enter(i, i, 0.0);
    matrix_.setFromTriplets(entries_.begin(), entries_.end());
  }

  /// The step that a damped solution takes; false where there is none.
  bool solve(double damping, Eigen::VectorXd& step) {
    Sparse damped = matrix_;
    for (std::ptrdiff_t i = 0; i < size_; ++i) {
      damped.coeffRef(i, i) += damping * damped.coeff(i, i) + kLeastDamping;
    }
    if (!analyzed_) solver_.analyzePattern(damped);
    analyzed_ = true;
    solver_.factorize(damped);
    if (solver_.info() != Eigen::Success) return false;
    step = solver_.solve(right_);
    return step.allFinite();
  }

  /// Sigmas of the errors by the newest matrix; nothing where they are no unknowns. Not damped:
  /// that would hold the poses, and with them the errors.
  std::optional<OdometryErrors> errorSigmas() {
    Eigen::VectorXd step;
    if (errors_ == kHeld || !solve(0.0, step)) return std::nullopt;
    OdometryErrors sigmas;
    for (const std::ptrdiff_t k : {0, 1}) {
      Eigen::VectorXd unit = Eigen::VectorXd::Zero(size_);
      unit[errors_ + k] = 1.0;
      const Eigen::VectorXd column = solver_.solve(unit);
      (k == 0 ? sigmas.bend : sigmas.turn_factor) = std::sqrt(std::max(column[errors_ + k], 0.0));
    }
    return sigmas;
  }

  void move(const Eigen::VectorXd& step, RelaxationProblem& problem) const {
    for (std::size_t i = 0; i < column_.size(); ++i) {
      const std::ptrdiff_t at = column_[i];
      if (at == kHeld) continue;
      Pose2d& pose = problem.poses[i];
      pose = {pose.x + step[at], pose.y + step[at + 1], wrapAngle(pose.yaw + step[at + 2])};
    }
    if (errors_ == kHeld) return;
    problem.errors.bend += step[errors_];
    problem.errors.turn_factor += step[errors_ + 1];
  }

 private:
  /// A block of unknowns and how the residual changes with them.
  struct Part {
    std::ptrdiff_t column;
    Eigen::Matrix3d jacobian;
    std::ptrdiff_t width;
  };

  void enter(std::ptrdiff_t row, std::ptrdiff_t column, double value) {
    // Of a symmetric matrix the solver reads the lower triangle.
    if (row >= column) {
      entries_.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
    }
  }

  void add(const RelaxationProblem& problem, const RelativePose& relative) {
    std::array<Part, 3> parts;
    std::size_t count = 0;
    const Pose2d& from = problem.poses[relative.from];
    const Pose2d& to = problem.poses[relative.to];
    const double c = std::cos(from.yaw), s = std::sin(from.yaw);
    const double dx = to.x - from.x, dy = to.y - from.y;
    if (column_[relative.from] != kHeld) {
      Part& part = parts[count++];
      part = {column_[relative.from], Eigen::Matrix3d::Zero(), 3};
      part.jacobian << -c, -s, -s * dx + c * dy, s, -c, -c * dx - s * dy, 0.0, 0.0, -1.0;
    }
    if (column_[relative.to] != kHeld) {
      Part& part = parts[count++];
      part = {column_[relative.to], Eigen::Matrix3d::Zero(), 3};
      part.jacobian << c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0;
    }
    const Pose2d expected = measured(problem, relative);
    if (errors_ != kHeld && relative.way >= 0.0) {
      Part& part = parts[count++];
      part = {errors_, Eigen::Matrix3d::Zero(), 2};
      const Eigen::Vector3d turned(0.5 * expected.y, -0.5 * expected.x, -1.0);
      part.jacobian.col(0) = relative.way * turned;
      part.jacobian.col(1) = relative.turn * turned;
    }
    if (count == 0) return;
    const Eigen::Vector3d error = residual(from, to, expected);
    const double weight = believed(error.dot(relative.information * error), relative.doubt);
    const Eigen::Matrix3d information = weight * relative.information;
    for (std::size_t a = 0; a < count; ++a) {
      const Eigen::Matrix3d weighed = parts[a].jacobian.transpose() * information;
      const Eigen::Vector3d pull = weighed * error;
      for (std::ptrdiff_t row = 0; row < parts[a].width; ++row) {
        right_[parts[a].column + row] -= pull[row];
      }
      for (std::size_t b = 0; b < count; ++b) {
        if (parts[b].column > parts[a].column) continue;
        const Eigen::Matrix3d block = weighed * parts[b].jacobian;
        for (std::ptrdiff_t row = 0; row < parts[a].width; ++row) {
          for (std::ptrdiff_t column = 0; column < parts[b].width; ++column) {
            enter(parts[a].column + row, parts[b].column + column, block(row, column));
          }
        }
      }
    }
  }

  void add(const RelaxationProblem& problem, const YawPrior& prior) {
    const std::ptrdiff_t at = column_[prior.pose];
    if (at == kHeld) return;
    const double error = wrapAngle(problem.poses[prior.pose].yaw - prior.yaw);
    right_[at + 2] -= prior.information * error;
    enter(at + 2, at + 2, prior.information);
  }

  void addPrior(std::ptrdiff_t at, double value, double sigma) {
    right_[at] -= value / (sigma * sigma);
    enter(at, at, 1.0 / (sigma * sigma));
  }

  std::vector<std::ptrdiff_t> column_;  ///< of each pose's x, or kHeld
  std::ptrdiff_t errors_ = kHeld;
  std::ptrdiff_t size_ = 0;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd right_;
  Sparse matrix_;
  Eigen::SimplicialLDLT<Sparse> solver_;
  bool analyzed_ = false;
};

}  // namespace

Pose2d OdometryErrors::corrected(const Pose2d& motion, double way, double turn) const {
  const double missed = turn_factor * turn + bend * way;
  const Pose2d half{0.0, 0.0, 0.5 * missed};
  return half * motion * half;
}

double chiSquare(const RelaxationProblem& problem, const RelativePose& relative) {
  const Eigen::Vector3d error = residual(problem.poses[relative.from], problem.poses[relative.to],
                                         measured(problem, relative));
  return error.dot(relative.information * error);
}

RelaxationResult relax(RelaxationProblem& problem, const RelaxationOptions& options) {
  RelaxationResult result;
  result.cost = totalCost(problem);
  Equations equations(problem);
  if (equations.size() == 0) return result;
  double damping = 1e-6;
  Eigen::VectorXd step;
  while (result.iterations < options.iterations) {
    ++result.iterations;
    equations.build(problem);
    bool better = false;
    for (int attempt = 0; attempt < 6 && !better; ++attempt) {
      if (equations.solve(damping, step)) {
        const std::vector<Pose2d> before = problem.poses;
        const OdometryErrors errors_before = problem.errors;
        equations.move(step, problem);
        const double cost = totalCost(problem);
        if (cost <= result.cost * (1.0 + 1e-12) + 1e-12) {
          better = true;
          result.cost = cost;
          damping = std::max(0.1 * damping, 1e-9);
          break;
        }
        problem.poses = before;
        problem.errors = errors_before;
      }
      damping = std::max(20.0 * damping, 1e-4);
    }
    if (!better) {
      result.solved = result.iterations > 1;
      return result;
    }
    if (step.lpNorm<Eigen::Infinity>() < options.small_step) break;
  }
  result.error_sigmas = equations.errorSigmas();
  if (result.error_sigmas) {
    const double noise = noiseFactor(problem);
    result.error_sigmas->bend = std::min(noise * result.error_sigmas->bend, kBendSigma);
    result.error_sigmas->turn_factor =
        std::min(noise * result.error_sigmas->turn_factor, kTurnFactorSigma);
  }
  return result;
}

}  // namespace place_memory::core
