#include "core/map/pose_relaxation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace place_memory::core {
namespace {

constexpr double kDegree = kPi / 180.0;

/// Laps about a square, as they were and as odometry saw them.
struct Laps {
  std::vector<Pose2d> truth;
  RelaxationProblem problem;
  std::mt19937 random;

  explicit Laps(unsigned seed) : random(seed) {}

  double noise(double sigma) { return std::normal_distribution<double>(0.0, sigma)(random); }

  /// `errors` are what odometry gets wrong; it sees `position` and `yaw` noise a step as well. With
  /// `both_ways` every other lap goes the other way about.
  void drive(std::size_t laps, const OdometryErrors& errors, double position, double yaw,
             bool both_ways = false) {
    constexpr std::size_t kSide = 20;
    Pose2d at, seen;
    add(at, seen);
    for (std::size_t step = 0; step < 4 * kSide * laps; ++step) {
      const double corner = !both_ways || step / (4 * kSide) % 2 == 0 ? kPi / 2.0 : -kPi / 2.0;
      const Pose2d motion{0.5, 0.0, step % kSide == kSide - 1 ? corner : 0.0};
      // What is measured is what the errors, once taken out, turn into the motion.
      const double turn = (motion.yaw - errors.bend * 0.5) / (1.0 + errors.turn_factor);
      const Pose2d half{0.0, 0.0, -0.5 * (motion.yaw - turn)};
      Pose2d measured = half * motion * half;
      measured = measured * Pose2d{noise(position), noise(position), noise(yaw)};
      at = at * motion;
      seen = seen * measured;
      const Eigen::Vector3d information(1e4, 1e4, 1.0 / std::pow(1.0 * kDegree, 2));
      problem.relatives.push_back(
          {truth.size() - 1, truth.size(), measured, information.asDiagonal(), 0.5, turn, 0.0});
      add(at, seen);
    }
    problem.held[0] = 1;
  }

  void tie(std::size_t from, std::size_t to, const Pose2d& relative) {
    const Eigen::Vector3d information(400.0, 400.0, 1.0 / std::pow(2.0 * kDegree, 2));
    problem.relatives.push_back({from, to, relative, information.asDiagonal(), -1.0, 0.0, 2.0});
  }
  void tieTruly(std::size_t from, std::size_t to) {
    tie(from, to,
        truth[from].inverse() * truth[to] * Pose2d{noise(0.03), noise(0.03), noise(0.02)});
  }

  void tieLaps(std::size_t apart) {
    for (std::size_t i = apart; i < truth.size(); ++i) tieTruly(i - apart, i);
  }

  double rmse() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      sum += std::pow(problem.poses[i].x - truth[i].x, 2) +
             std::pow(problem.poses[i].y - truth[i].y, 2);
    }
    return std::sqrt(sum / static_cast<double>(truth.size()));
  }

 private:
  void add(const Pose2d& at, const Pose2d& seen) {
    truth.push_back(at);
    problem.poses.push_back(seen);
    problem.held.push_back(0);
  }
};

TEST(PoseRelaxation, LapsThatAreTiedComeToLieWhereTheyWere) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Laps laps(seed);
    laps.drive(3, {}, 0.01, 1.0 * kDegree);
    const double before = laps.rmse();
    laps.tieLaps(80);
    const RelaxationResult result = relax(laps.problem, {30, 1e-4});
    EXPECT_TRUE(result.solved);
    EXPECT_LT(laps.rmse(), 0.35);
    EXPECT_LT(laps.rmse(), 0.6 * before);
  }
}

TEST(PoseRelaxation, FindsTheBendAndTheTurnFactorOfTheWheels) {
  Laps laps(7);
  const OdometryErrors errors{0.3 * kDegree, 0.02};
  laps.drive(4, errors, 0.005, 0.1 * kDegree, true);
  laps.tieLaps(160);
  for (RelativePose& relative : laps.problem.relatives) relative.doubt = 0.0;
  laps.problem.find_errors = true;
  relax(laps.problem, {40, 1e-5});
  EXPECT_NEAR(laps.problem.errors.bend, errors.bend, 0.15 * kDegree);
  EXPECT_NEAR(laps.problem.errors.turn_factor, errors.turn_factor, 0.015);
  EXPECT_LT(laps.rmse(), 0.3);
}

TEST(PoseRelaxation, SaysHowWellItKnowsTheErrorsOfTheWheels) {
  const OdometryErrors errors{0.3 * kDegree, 0.02};
  for (unsigned seed = 7; seed < 13; ++seed) {
    Laps laps(seed);
    laps.drive(4, errors, 0.005, 0.1 * kDegree, true);
    laps.tieLaps(160);
    for (RelativePose& relative : laps.problem.relatives) relative.doubt = 0.0;
    laps.problem.find_errors = true;
    const RelaxationResult result = relax(laps.problem, {40, 1e-5});
    ASSERT_TRUE(result.error_sigmas);
    EXPECT_LT(result.error_sigmas->bend, 0.5 * kBendSigma);
    EXPECT_LT(result.error_sigmas->turn_factor, 0.5 * kTurnFactorSigma);
    EXPECT_LT(std::abs(laps.problem.errors.bend - errors.bend), 4.0 * result.error_sigmas->bend);
    EXPECT_LT(std::abs(laps.problem.errors.turn_factor - errors.turn_factor),
              4.0 * result.error_sigmas->turn_factor);
  }
  // Before a loop is closed nothing is known.
  Laps straight(2);
  straight.drive(1, errors, 0.005, 0.1 * kDegree);
  straight.problem.find_errors = true;
  EXPECT_NEAR(relax(straight.problem).error_sigmas->bend, kBendSigma, 0.1 * kBendSigma);
}

TEST(PoseRelaxation, OneFalseTieInTenIsOutvoted) {
  for (unsigned seed = 11; seed <= 14; ++seed) {
    Laps clean(seed), faulty(seed);
    for (Laps* laps : {&clean, &faulty}) {
      laps->drive(3, {}, 0.01, 0.5 * kDegree);
      laps->tieLaps(80);
    }
    for (std::size_t i = 85; i < faulty.truth.size(); i += 10) {
      faulty.tie(i - 85, i, Pose2d{4.0, -3.0, 1.0});
    }
    relax(clean.problem, {30, 1e-4});
    relax(faulty.problem, {30, 1e-4});
    EXPECT_LT(faulty.rmse(), 1.2 * clean.rmse() + 0.02) << "seed " << seed;
  }
}

TEST(PoseRelaxation, HeldPosesStay) {
  Laps laps(3);
  laps.drive(3, {}, 0.01, 1.0 * kDegree);
  laps.tieLaps(80);
  for (std::size_t i = 0; i <= 100; ++i) laps.problem.held[i] = 1;
  const std::vector<Pose2d> before = laps.problem.poses;
  relax(laps.problem);
  for (std::size_t i = 0; i <= 100; ++i) {
    EXPECT_EQ(laps.problem.poses[i].x, before[i].x);
    EXPECT_EQ(laps.problem.poses[i].yaw, before[i].yaw);
  }
  EXPECT_NE(laps.problem.poses.back().x, before.back().x);
}

TEST(PoseRelaxation, ACompassTurnsTheWay) {
  Laps laps(5);
  laps.drive(1, {2.0 * kDegree, 0.0}, 0.01, 0.5 * kDegree);
  for (std::size_t i = 1; i < laps.truth.size(); ++i) {
    laps.problem.yaws.push_back(
        {i, laps.truth[i].yaw + laps.noise(5.0 * kDegree), 1.0 / std::pow(10.0 * kDegree, 2)});
  }
  const double before = laps.rmse();
  laps.problem.find_errors = true;
  relax(laps.problem, {30, 1e-4});
  EXPECT_LT(laps.rmse(), 0.3 * before);
}

TEST(PoseRelaxation, CorrectedMotionTurnsByWhatIsMissed) {
  const OdometryErrors errors{0.1, 0.05};
  const Pose2d corrected = errors.corrected({1.0, 0.0, 0.2}, 1.0, 0.2);
  EXPECT_NEAR(corrected.yaw, 0.2 + 0.1 + 0.05 * 0.2, 1e-12);
  EXPECT_NEAR(std::hypot(corrected.x, corrected.y), 1.0, 1e-12);
  // A turn of more than half a circle is not taken for one the other way.
  EXPECT_NEAR(errors.corrected({0.0, 0.0, wrapAngle(3.5)}, 0.0, 3.5).yaw, wrapAngle(3.5 * 1.05),
              1e-12);
}

}  // namespace
}  // namespace place_memory::core
