#include "place_memory/core/pose2d.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace place_memory::core {
namespace {

constexpr double kTolerance = 1e-9;

class RandomPoses {
 public:
  Pose2d next() { return {metres_(engine_), metres_(engine_), radians_(engine_)}; }
  double nextAngle() { return radians_(engine_); }

 private:
  std::mt19937 engine_{20240607};
  std::uniform_real_distribution<double> metres_{-50.0, 50.0};
  std::uniform_real_distribution<double> radians_{-40.0, 40.0};  // several turns either way
};

void expectSamePose(const Pose2d& actual, const Pose2d& expected) {
  EXPECT_NEAR(actual.x, expected.x, kTolerance);
  EXPECT_NEAR(actual.y, expected.y, kTolerance);
  EXPECT_NEAR(wrapAngle(actual.yaw - expected.yaw), 0.0, kTolerance);
}

TEST(WrapAngle, KeepsTheDirectionAndStaysInRange) {
  RandomPoses random;
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.nextAngle();
    const double wrapped = wrapAngle(angle);
    EXPECT_GE(wrapped, -kPi);
    EXPECT_LT(wrapped, kPi);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), kTolerance);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), kTolerance);
  }
}

TEST(WrapAngle, TheHalfTurnBelongsToTheLowerEnd) {
  EXPECT_DOUBLE_EQ(wrapAngle(kPi), -kPi);
  EXPECT_DOUBLE_EQ(wrapAngle(-kPi), -kPi);
  EXPECT_DOUBLE_EQ(wrapAngle(0.0), 0.0);
}

TEST(WrapAngle, StaysInRangeNextToTheHalfTurn) {
  for (const double turn : {-3.0 * kPi, -kPi, kPi, 3.0 * kPi}) {
    for (const double towards : {-100.0, 100.0}) {
      const double wrapped = wrapAngle(std::nextafter(turn, towards));
      EXPECT_GE(wrapped, -kPi);
      EXPECT_LT(wrapped, kPi);
    }
  }
}

TEST(WrapAngle, NonFiniteGivesNan) {
  EXPECT_TRUE(std::isnan(wrapAngle(std::numeric_limits<double>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(wrapAngle(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(wrapAngle(-std::numeric_limits<double>::infinity())));
}

TEST(Pose2d, AQuarterTurnPutsForwardToTheLeft) {
  expectSamePose(Pose2d{1.0, 2.0, kPi / 2.0} * Pose2d{3.0, 0.0, 0.0}, {1.0, 5.0, kPi / 2.0});
}

TEST(Pose2d, IdentityChangesNothing) {
  RandomPoses random;
  for (int i = 0; i < 100; ++i) {
    const Pose2d pose = random.next();
    expectSamePose(pose * Pose2d{}, pose);
    expectSamePose(Pose2d{} * pose, pose);
  }
}

TEST(Pose2d, CompositionIsAssociative) {
  RandomPoses random;
  for (int i = 0; i < 100; ++i) {
    const Pose2d a = random.next();
    const Pose2d b = random.next();
    const Pose2d c = random.next();
    expectSamePose((a * b) * c, a * (b * c));
  }
}

TEST(Pose2d, InverseUndoesThePoseOnEitherSide) {
  RandomPoses random;
  for (int i = 0; i < 100; ++i) {
    const Pose2d pose = random.next();
    expectSamePose(pose * pose.inverse(), {});
    expectSamePose(pose.inverse() * pose, {});
  }
}

TEST(Pose2d, IsFiniteOnlyWhereEveryPartIs) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE((Pose2d{1.0, 2.0, 3.0}.isFinite()));
  EXPECT_FALSE((Pose2d{nan, 0.0, 0.0}.isFinite()));
  EXPECT_FALSE((Pose2d{0.0, infinity, 0.0}.isFinite()));
  EXPECT_FALSE((Pose2d{0.0, 0.0, -infinity}.isFinite()));
}

}  // namespace
}  // namespace place_memory::core
