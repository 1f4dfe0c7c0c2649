#ifndef PLACE_MEMORY_CORE_MAP_POSE_RELAXATION_H
#define PLACE_MEMORY_CORE_MAP_POSE_RELAXATION_H

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "place_memory/core/pose2d.h"

namespace place_memory::core {

/// What wheels get wrong all the time, as one number each for a whole drive.
struct OdometryErrors {
  double bend = 0.0;         ///< turn that odometry misses [rad/m of way]
  double turn_factor = 0.0;  ///< share of its turns that it misses

  /// Odometry's motion over a short way [m], on which it turned by `turn` [rad], any number of
  /// times about, as it was in truth.
  Pose2d corrected(const Pose2d& motion, double way, double turn) const;
};

/// How well the errors of any wheels are known before they drove: sigmas of them.
constexpr double kBendSigma = 1.5 * kPi / 180.0;  // [rad/m]
constexpr double kTurnFactorSigma = 0.05;

/// A pose as seen from another one.
struct RelativePose {
  std::size_t from = 0;  ///< index of poses
  std::size_t to = 0;
  Pose2d relative;              ///< of `to` in the frame of `from`
  Eigen::Matrix3d information;  ///< over x [m], y [m], yaw [rad] in the frame of `from`
  /// Way that odometry measured between them [m], >= 0; below 0: no odometry, OdometryErrors do not
  /// touch it.
  double way = -1.0;
  double turn = 0.0;  ///< that it measured on that way, not wrapped [rad]
  /// From so many sigma on it is ever less believed (Cauchy); 0: it is believed wholly.
  double doubt = 0.0;
};

/// A heading in the map, as a compass has it.
struct YawPrior {
  std::size_t pose = 0;
  double yaw = 0.0;          ///< [rad]
  double information = 0.0;  ///< [1/rad^2]
};

/// Poses in one frame and what is known of them.
struct RelaxationProblem {
  std::vector<Pose2d> poses;  ///< the estimates, which are bettered
  std::vector<char> held;     ///< by pose: those that stay where they are; at least one
  std::vector<RelativePose> relatives;
  std::vector<YawPrior> yaws;
  OdometryErrors errors;
  /// Whether `errors` are unknowns too, known before to kBendSigma and kTurnFactorSigma.
  bool find_errors = false;
};

/// Squared distance of a relative pose from the estimates [sigma^2], before doubt.
double chiSquare(const RelaxationProblem& problem, const RelativePose& relative);

struct RelaxationOptions {
  int iterations = 10;        ///< at most
  double small_step = 0.001;  ///< ends once no pose moves further [m, rad]
};

struct RelaxationResult {
  int iterations = 0;
  double cost = 0.0;   ///< half the sum of what is left, with doubt
  bool solved = true;  ///< false: not solvable, poses are as they were
  /// Of the errors, where they were unknowns: to what sigmas they are known now, from how far
  /// everything else is off.
  std::optional<OdometryErrors> error_sigmas;
};

/// Moves the poses to where they contradict what is known least: Levenberg and Marquardt's steps
/// over SE(2), solved by a sparse Cholesky decomposition; doubted relatives are weighed anew before
/// each step (Grisetti 2010, "A tutorial on graph-based SLAM").
RelaxationResult relax(RelaxationProblem& problem, const RelaxationOptions& options = {});

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_POSE_RELAXATION_H
