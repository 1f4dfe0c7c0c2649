#ifndef PLACE_MEMORY_EXPERIMENTS_BELIEF_DRIVE_H
#define PLACE_MEMORY_EXPERIMENTS_BELIEF_DRIVE_H

#include <cstdint>
#include <string>
#include <vector>

#include "core/map/place_belief.h"
#include "experiments/method.h"
#include "experiments/table.h"
#include "trials/trial_set.h"

namespace place_memory::experiments {

/// How odometry errs, and is known to.
struct OdometryNoise {
  double scale = 0.05;                   ///< of distances, for a whole drive, 1 sigma
  double yaw = 3.0 * core::kPi / 180.0;  ///< [rad] by the root of the way [m], 1 sigma
};

/// What was matched at each scan of a drive, in order, and the true way between.
struct MatchedDrive {
  struct Scan {
    std::vector<core::BeliefMatch> matches;  ///< by falling probability of the scan alone
    double known = 0.0;                      ///< probability that it is of any place
    std::vector<core::Pose2d> way;           ///< as RecognitionTrial::way
    std::vector<std::string> accept;
  };

  std::string name;
  std::vector<std::string> labels;  ///< of place 1, 2, ...
  std::vector<core::Pose2d> map_from_place;
  std::vector<Scan> scans;
};

/// Learns the places of a drive and puts its scans to them. Every trial must have a way.
MatchedDrive matchDrive(const trials::TrialSet& set, const Method& method);

/// What the belief says after a scan.
struct BeliefAnswer {
  bool single = false;  ///< the best match of the scan alone is right
  bool right = false;   ///< the place nearest to where the robot most probably is
  double probability = 0.0;
};

/// Follows a drive by matches and odometry; errors of odometry are repeatable by the seed.
std::vector<BeliefAnswer> followDrive(const MatchedDrive& drive,
                                      const core::PlaceBeliefOptions& options,
                                      const OdometryNoise& noise, std::uint64_t seed);

/// A row for each drive and one for all, over `seeds` errors of odometry from 1 on: how often the
/// scan alone is right, and the belief, and the latter with 0.9 and more.
Table beliefTable(const std::vector<MatchedDrive>& drives, const core::PlaceBeliefOptions& options,
                  const OdometryNoise& noise, std::size_t seeds);

}  // namespace place_memory::experiments

#endif  // PLACE_MEMORY_EXPERIMENTS_BELIEF_DRIVE_H
