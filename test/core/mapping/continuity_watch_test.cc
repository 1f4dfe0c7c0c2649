#include "core/mapping/continuity_watch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace place_memory::core {
namespace {

const SonarSpec kSpec{0.4, 0.1, 4.5};

/// A rectangle of walls about its middle [m].
struct Room {
  double half_length, half_width;
};

/// A robot with sixteen sonars that drives along the x axis, through whatever room it is in.
class Robot {
 public:
  std::vector<Spot> drive(const Room& room, double way) {
    std::vector<Spot> spots;
    for (double driven = 0.0; driven < way; driven += 0.04) {
      x_ += 0.04;
      at_ += 0.04;
      ++moment_;
      for (int i = moment_ % 4; i < 16; i += 4) {
        const double bearing = (i + 0.5) * kPi / 8.0;
        const double range = i < blocked ? 0.4 : rangeIn(room, bearing);
        watch_.add({{}, {x_, 0.0, 0.0}, {x_, 0.0, 0.0}, x_, 0.0},
                   {{0.0, 0.0, bearing}, kSpec, range}, compass);
      }
      if (moment_ % 12 == 0) spots.push_back(watch_.take());
    }
    return spots;
  }
  void putAt(double x) { at_ = x; }
  double way() const { return x_; }

  std::optional<double> compass;
  int blocked = 0;  ///< sonars that somebody stands before

 private:
  double rangeIn(const Room& room, double bearing) const {
    const double ends = (room.half_length - std::copysign(at_, at_ * std::cos(bearing))) /
                        std::abs(std::cos(bearing));
    const double range = std::min(ends, room.half_width / std::abs(std::sin(bearing)));
    return range <= kSpec.max_range ? range : INFINITY;
  }

  ContinuityWatch watch_;
  double x_ = 0.0;   ///< by odometry [m]
  double at_ = 0.0;  ///< in the room [m]
  int moment_ = 0;
};

constexpr int kMany = 12;  ///< sonars that hear nothing but somebody who stands by
const Room kHall{6.0, 2.0}, kCloset{1.5, 0.8};

std::size_t count(const std::vector<Spot>& spots, Continuity kind) {
  return static_cast<std::size_t>(std::count_if(
      spots.begin(), spots.end(), [kind](const Spot& spot) { return spot.readings == kind; }));
}

auto otherwise(const std::vector<Spot>& spots) {
  return std::count_if(spots.begin(), spots.end(),
                       [](const Spot& spot) { return spot.compass == CompassTurn::kOtherwise; });
}

TEST(ContinuityWatch, AlongARoomReadingsGoOn) {
  Robot robot;
  robot.putAt(-2.0);
  const std::vector<Spot> spots = robot.drive(kHall, 4.0);
  EXPECT_EQ(spots.front().readings, Continuity::kUnseen);
  EXPECT_GE(count(spots, Continuity::kGoesOn), 5U);
  EXPECT_EQ(count(spots, Continuity::kGoesOn) + count(spots, Continuity::kUnseen), spots.size());
}

TEST(ContinuityWatch, PutIntoAnotherRoomTheyDoNot) {
  Robot robot;
  robot.putAt(-2.0);
  robot.drive(kHall, 3.0);
  const double carried = robot.way();
  robot.putAt(-0.5);
  const std::vector<Spot> spots = robot.drive(kCloset, 1.0);
  const auto broken = std::find_if(spots.begin(), spots.end(), [](const Spot& spot) {
    return spot.readings == Continuity::kSurelyBreaks;
  });
  ASSERT_NE(broken, spots.end());
  EXPECT_NEAR(broken->way, carried, 0.15);
}

TEST(ContinuityWatch, SomebodyWhoStepsBesideTheRobotIsNoBreak) {
  Robot robot;
  robot.putAt(-2.0);
  robot.drive(kHall, 2.0);
  robot.blocked = 3;
  const std::vector<Spot> spots = robot.drive(kHall, 1.5);
  EXPECT_EQ(count(spots, Continuity::kBreaks) + count(spots, Continuity::kSurelyBreaks), 0U);
}

TEST(ContinuityWatch, WhereReadingsFlickerABreakHasToStandOut) {
  const Room corridor{40.0, 2.0};
  const auto broken = [](const std::vector<Spot>& spots) {
    return count(spots, Continuity::kBreaks) + count(spots, Continuity::kSurelyBreaks);
  };
  Robot steady, flickering;
  for (Robot* robot : {&steady, &flickering}) robot->putAt(-20.0);
  for (int i = 0; i < 16; ++i) {
    flickering.blocked = i % 2 == 0 ? 0 : kMany;
    for (Robot* robot : {&steady, &flickering}) robot->drive(corridor, 1.0);
  }
  steady.blocked = flickering.blocked = 0;
  for (Robot* robot : {&steady, &flickering}) robot->drive(corridor, 1.0);
  steady.blocked = flickering.blocked = kMany;
  EXPECT_GE(broken(steady.drive(corridor, 1.0)), 1U);
  EXPECT_EQ(broken(flickering.drive(corridor, 1.0)), 0U);
}

TEST(ContinuityWatch, ACompassThatTurnsAloneIsSaid) {
  Robot robot;
  robot.putAt(-2.0);
  robot.compass = 0.0;
  EXPECT_EQ(otherwise(robot.drive(kHall, 1.0)), 0);
  robot.compass = 1.0;
  EXPECT_GE(otherwise(robot.drive(kHall, 1.0)), 1);
  EXPECT_EQ(otherwise(robot.drive(kHall, 1.0)), 0);
}

TEST(ContinuityWatch, WhereThereIsNothingToHearNothingIsSaid) {
  Robot robot;
  const std::vector<Spot> spots = robot.drive({100.0, 100.0}, 3.0);
  EXPECT_EQ(count(spots, Continuity::kUnseen), spots.size());
}

}  // namespace
}  // namespace place_memory::core
