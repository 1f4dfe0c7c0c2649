#include "tools/standing_stretches.h"

#include <gtest/gtest.h>

namespace place_memory::tools {
namespace {

/// Appends so many seconds of odometry at 10 Hz, along x at `speed` [m/s].
void move(double seconds, double speed, std::vector<TrackPoint>& track) {
  TrackPoint at = track.empty() ? TrackPoint{ros::Time(1000.0), 0.0, 0.0} : track.back();
  for (int i = 0; i < static_cast<int>(seconds * 10.0 + 0.5); ++i) {
    at.stamp += ros::Duration(0.1);
    at.x += 0.1 * speed;
    track.push_back(at);
  }
}

TEST(StandingStretches, AreThoseBetweenDrives) {
  std::vector<TrackPoint> track;
  move(5.0, 0.0, track);
  move(10.0, 0.3, track);
  move(4.0, 0.0, track);
  move(5.0, -0.3, track);
  const auto stretches = standingStretches(track, StandingOptions());
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_NEAR(stretches[0].start.toSec(), 1000.1, 1e-6);
  EXPECT_NEAR(stretches[0].end.toSec(), 1005.0, 0.21);
  EXPECT_NEAR(stretches[1].start.toSec(), 1015.0, 0.21);
  EXPECT_NEAR(stretches[1].end.toSec(), 1019.0, 0.21);
}

TEST(StandingStretches, ShortStopsAndSlowDrivesAreNone) {
  std::vector<TrackPoint> track;
  move(5.0, 0.3, track);
  move(2.0, 0.0, track);
  move(5.0, 0.3, track);
  move(20.0, 0.05, track);
  EXPECT_TRUE(standingStretches(track, StandingOptions()).empty());
  EXPECT_TRUE(standingStretches({}, StandingOptions()).empty());
}

TEST(StandingStretches, OfALongOneTheFirstPartIsTaken) {
  std::vector<TrackPoint> track;
  move(300.0, 0.0, track);
  const auto stretches = standingStretches(track, StandingOptions());
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_NEAR((stretches[0].end - stretches[0].start).toSec(), 60.0, 1e-6);
}

TEST(StandingStretches, SilenceOfOdometryEndsOne) {
  std::vector<TrackPoint> track;
  move(5.0, 0.0, track);
  track.push_back({track.back().stamp + ros::Duration(10.0), 0.0, 0.0});
  move(5.0, 0.0, track);
  EXPECT_EQ(standingStretches(track, StandingOptions()).size(), 2U);
}

}  // namespace
}  // namespace place_memory::tools
