#include "routes/month.h"

#include <gtest/gtest.h>

namespace place_memory::routes {
namespace {

class MonthTest : public testing::TestWithParam<std::uint64_t> {};

TEST_P(MonthTest, LinksThatLearnComeNearToAnOracleThatKnowsTheOdds) {
  const MonthResult month = runMonth(GetParam(), {});
  EXPECT_LT(month.learned_after, 20.0);
  EXPECT_GT(month.learning.reached, 300U);
  EXPECT_LE(month.learning.time, 1.10 * month.odds.time);
  EXPECT_LE(month.doors.time, month.odds.time);
}

TEST_P(MonthTest, ADoorThatIsOpenedAgainIsUsedAgainWithinThreeDays) {
  const std::optional<double> days = daysToReturn(GetParam(), {});
  ASSERT_TRUE(days);
  EXPECT_LT(*days, 3.0);
}

TEST_P(MonthTest, WhereNothingClosesWaysAreHardlyLongerThanTheShortest) {
  const Detours longer = detours(GetParam(), {});
  EXPECT_LE(longer.worst, 0.05);
}

INSTANTIATE_TEST_SUITE_P(Seeds, MonthTest, testing::Values(1, 2, 3));

TEST(DoorWorld, DependsOnSeedAndTimeAlone) {
  const DoorWorld one(4, true), same(4, true), other(5, true);
  ASSERT_EQ(one.passages().size(), same.passages().size());
  bool differs = one.passages().size() != other.passages().size();
  std::size_t doors = 0;
  for (std::size_t i = 0; i < one.passages().size(); ++i) {
    if (one.passages()[i].door.kind != Door::Kind::kNone) ++doors;
    EXPECT_EQ(one.passages()[i].time, same.passages()[i].time);
    std::size_t open = 0;
    constexpr int kHours = 12 * 300;
    for (int hour = 0; hour < kHours; ++hour) {
      const double time = kDay * (hour / 12) + kWorkBegins + 3600.0 * (hour % 12) + 1800.0;
      EXPECT_EQ(one.isOpen(i, time), same.isOpen(i, time));
      if (one.isOpen(i, time)) ++open;
    }
    EXPECT_NEAR(static_cast<double>(open) / kHours, one.share(i),
                0.09);  // doors open between hours
    if (!differs) differs = one.passages()[i].time != other.passages()[i].time;
  }
  EXPECT_TRUE(differs);
  EXPECT_GT(doors, 5U);
}

}  // namespace
}  // namespace place_memory::routes
