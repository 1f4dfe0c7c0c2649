#include "routes/explore_account.h"

#include <gtest/gtest.h>

namespace place_memory::routes {
namespace {

using Aim = core::Explorer::Aim;

constexpr double kFloor = 100.0;  // [m^2]

// It looks, drives to a frontier that shows half of the floor, to one that shows nothing, back to
// where it was sure, to one that shows the rest, and home.
const std::vector<TickOfTask> kTicks{
    {0, Aim::kFrontier, 0.0}, {1, Aim::kFrontier, 2.0},  {1, Aim::kFrontier, 5.0},
    {2, Aim::kFrontier, 6.5}, {2, Aim::kFrontier, 9.0},  {3, Aim::kLoop, 11.0},
    {3, Aim::kLoop, 16.0},    {4, Aim::kFrontier, 22.0}, {5, Aim::kHome, 30.0}};
const std::vector<double> kSeen{0.2, 0.5, 0.7, 0.7, 0.7, 0.7, 0.7, 0.96, 1.0};

TEST(ExploreAccountTest, EachMetreIsOfWhatTheRobotWasAbout) {
  const ExploreAccount account = accountOf(kTicks, kSeen, kFloor);
  EXPECT_DOUBLE_EQ(account.fruitful, 5.0 + 6.0);
  EXPECT_DOUBLE_EQ(account.fruitless, 4.0);
  EXPECT_DOUBLE_EQ(account.loops, 7.0);
  EXPECT_DOUBLE_EQ(account.home, 8.0);
  EXPECT_EQ(account.tasks, 3U);
  EXPECT_EQ(account.in_vain, 1U);
}

TEST(ExploreAccountTest, ItAddsUpToTheWay) {
  const ExploreAccount account = accountOf(kTicks, kSeen, kFloor);
  EXPECT_DOUBLE_EQ(account.fruitful + account.fruitless + account.loops + account.home,
                   kTicks.back().way);
}

TEST(ExploreAccountTest, EnoughIsSeenWhereNearlyAllIs) {
  EXPECT_DOUBLE_EQ(accountOf(kTicks, kSeen, kFloor).enough, 22.0);
  const std::vector<double> little(kTicks.size(), 0.5);
  EXPECT_DOUBLE_EQ(accountOf(kTicks, little, kFloor).enough, 30.0);
}

}  // namespace
}  // namespace place_memory::routes
