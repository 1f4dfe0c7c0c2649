#include "core/recognize/pose_estimate.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <random>

#include "core/random_room.h"

namespace place_memory::core {
namespace {

const LatticeMetric kMetric{{{{1.0, 0.0, -1.0}, {0.0, 0.0, -1.0}, {-2.0, -1.0, 3.0}}}, 0.0, 0.0};

struct Found {
  PoseEstimate estimate;
  Pose2d lattice;
};

Found find(const Scan& scan, const Scan& learned, double sharpness) {
  const double cell = scan.grid.geometry().cell_size;
  const SearchWindow window = searchWindow(1.0, 0.5, cell);
  const QueryPlanes query(scan.grid, kHeadingStep, window.rotations);
  const CellPlanes planes(learned.grid);
  const Alignment best = findAlignment(query, planes, kMetric, window, SearchMethod::kExhaustive);
  return {estimatePose(query, planes, kMetric, window, best, cell, sharpness),
          {best.shift.columns * cell, best.shift.rows * cell, best.rotation * kHeadingStep}};
}

TEST(EstimatePose, LiesBetweenTheLatticePointsNearerToTheTruth) {
  double estimated = 0.0, on_lattice = 0.0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    const RandomRoom room(seed);
    const Pose2d truth{0.21, -0.07 * seed / 2.0, 0.075};
    const Found found = find(room.scanFrom(truth), room.scanFrom({}), 0.05);
    const Pose2d& pose = found.estimate.place_from_scan;
    estimated += std::hypot(pose.x - truth.x, pose.y - truth.y);
    on_lattice += std::hypot(found.lattice.x - truth.x, found.lattice.y - truth.y);
  }
  EXPECT_LT(estimated, on_lattice);
}

TEST(EstimatePose, CovarianceIsSymmetricAndNeverBelowTheLattice) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const RandomRoom room(seed);
    const Eigen::Matrix3d c =
        find(room.scanFrom({0.1, 0.2, 0.05}), room.scanFrom({}), 10.0).estimate.covariance;
    EXPECT_TRUE(c.isApprox(c.transpose()));
    const double cell = kDefaultCellSize;
    EXPECT_GE(c(0, 0), cell * cell / 12.0 - 1e-12);
    EXPECT_GE(c(2, 2), kHeadingStep * kHeadingStep / 12.0 - 1e-12);
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(c).eigenvalues()[0], 0.0);
  }
}

TEST(EstimatePose, ASharperLikelihoodIsSurer) {
  const RandomRoom room(3);
  const Scan learned = room.scanFrom({});
  const Scan scan = room.scanFrom({0.1, 0.2, 0.05});
  EXPECT_GT(find(scan, learned, 0.01).estimate.covariance.trace(),
            find(scan, learned, 1.0).estimate.covariance.trace());
}

TEST(EstimatePose, ACorridorIsUnsureAlongItself) {
  EvidenceGrid grid;
  for (int column = 0; column < kGridSize; ++column) {
    grid.add(24, column, 50);
    grid.add(40, column, 50);
    for (int row = 25; row < 40; ++row) grid.add(row, column, -50);
  }
  Scan corridor;
  corridor.grid = grid;
  const Eigen::Matrix3d c = find(corridor, corridor, 0.05).estimate.covariance;
  EXPECT_GT(c(0, 0), 4.0 * c(1, 1));
}

/// Draws of the pose that the estimate stands for, put through the frames one by one.
Eigen::Matrix3d drawnCovariance(const Pose2d& map_from_place, const PoseEstimate& estimate,
                                const Pose2d& robot_in_scan) {
  constexpr int kDraws = 200000;
  const Eigen::Matrix3d root = estimate.covariance.llt().matrixL();
  const Pose2d mean = map_from_place * estimate.place_from_scan * robot_in_scan;
  std::mt19937 engine(5);
  std::normal_distribution<double> normal;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d draw(normal(engine), normal(engine), normal(engine));
    const Eigen::Vector3d off = root * draw;
    Pose2d place_from_scan = estimate.place_from_scan;
    place_from_scan.x += off.x();
    place_from_scan.y += off.y();
    place_from_scan.yaw += off.z();
    const Pose2d robot = map_from_place * place_from_scan * robot_in_scan;
    const Eigen::Vector3d from_mean(robot.x - mean.x, robot.y - mean.y,
                                    wrapAngle(robot.yaw - mean.yaw));
    sum += from_mean * from_mean.transpose();
  }
  return sum / kDraws;
}

TEST(RobotPose, OfARobotAwayFromTheScansOriginIsAsUnsureAsDrawsOfItAre) {
  PoseEstimate estimate;
  estimate.place_from_scan = {0.4, -0.2, 0.3};
  estimate.covariance << 4e-3, 1e-3, 2e-4, 1e-3, 2e-3, -3e-4, 2e-4, -3e-4, 1.6e-3;
  const Pose2d map_from_place{12.0, -7.0, 2.1};
  for (const Pose2d& robot_in_scan :
       {Pose2d{}, Pose2d{2.0, 0.0, 0.4}, Pose2d{-1.5, 2.5, -2.0}, Pose2d{0.0, -3.0, kPi}}) {
    const RobotPose robot = robotPose(map_from_place, estimate, robot_in_scan);
    const Eigen::Matrix3d drawn = drawnCovariance(map_from_place, estimate, robot_in_scan);
    EXPECT_LT((robot.covariance - drawn).norm(), 0.02 * drawn.norm()) << robot.covariance << "\n\n"
                                                                      << drawn;
    const Pose2d stands = map_from_place * estimate.place_from_scan * robot_in_scan;
    EXPECT_EQ(robot.map_from_robot.x, stands.x);
    EXPECT_EQ(robot.map_from_robot.y, stands.y);
    EXPECT_EQ(robot.map_from_robot.yaw, stands.yaw);
  }
}

}  // namespace
}  // namespace place_memory::core
