#include "core/map/link_hours.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace place_memory::core {
namespace {

using std::chrono::hours;
using std::chrono::nanoseconds;

constexpr double kHalfLife = 172800.0;  // [s]
constexpr double kEven = 0.6;           // odds of other links

PlaceLink link(PlaceId first = 1, PlaceId second = 2) {
  PlaceLink link;
  link.first = first;
  link.second = second;
  return link;
}

Traversal at(nanoseconds time, bool succeeded, bool back = false) {
  return {back ? 2 : 1, back ? 1 : 2, time, time, succeeded, "test"};
}

/// Someone tries the link four times a day, at random in its twelve hours, for so many days.
template <class IsOpen>
LinkHours tried(int days, std::uint64_t seed, const IsOpen& is_open) {
  LinkHours hours_of(kHalfLife);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int day = 0; day < days; ++day) {
    for (int part = 0; part < 4; ++part) {
      const double hour = 8.0 + 3.0 * (part + share(random));
      const auto time = std::chrono::duration_cast<nanoseconds>(
          std::chrono::duration<double, std::ratio<3600>>(24.0 * day + hour));
      hours_of.note(at(time, is_open(hour, share(random)), share(random) < 0.5));
    }
  }
  return hours_of;
}

bool openInTheMorning(double hour, double /*chance*/) { return hour < 13.0; }

TEST(LinkHours, ADoorThatKeepsHoursIsFoundOut) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const LinkHours found = tried(12, seed, openInTheMorning);
    EXPECT_TRUE(found.any()) << seed;
    EXPECT_GT(found.weighed(link(), kEven, hours(24 * 12 + 10)), 0.8) << seed;
    EXPECT_LT(found.weighed(link(), kEven, hours(24 * 12 + 17)), 0.25) << seed;
  }
}

TEST(LinkHours, ADoorThatClosesByChanceHasNone) {
  int used = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const LinkHours found =
        tried(30, seed, [](double /*hour*/, double chance) { return chance < 0.6; });
    used += found.any() ? 1 : 0;
  }
  EXPECT_LE(used, 10);
}

TEST(LinkHours, OddsStayAsTheyAreUntilHoursForetellBetter) {
  LinkHours hours_of(kHalfLife);
  EXPECT_EQ(hours_of.weighed(link(), kEven, hours(10)), kEven);
  hours_of.note(at(hours(17), false));
  EXPECT_FALSE(hours_of.any());
  EXPECT_EQ(hours_of.weighed(link(), kEven, hours(17)), kEven);
  EXPECT_EQ(tried(12, 1, openInTheMorning).weighed(link(2, 3), kEven, hours(17)), kEven)
      << "another link";
}

TEST(LinkHours, ADoorThatIsOpenAllDayAgainIsTrustedAgain) {
  LinkHours found = tried(12, 1, openInTheMorning);
  for (int day = 12; day < 26; ++day) {
    for (const int hour : {9, 12, 15, 18}) found.note(at(hours(24 * day + hour), true));
  }
  EXPECT_GT(found.weighed(link(), 0.9, hours(24 * 26 + 17)), 0.7);
}

TEST(LinkHours, TheHourOpensNothingThatWasSaidToBeClosed) {
  const LinkHours found = tried(12, 1, openInTheMorning);
  EXPECT_EQ(found.weighed(link(), 0.05, hours(24 * 12 + 10)), 0.05);
}

TEST(LinkHours, ALinkThatIsForgottenBeginsAnew) {
  LinkHours found = tried(12, 1, openInTheMorning);
  found.forget(2, 1);
  EXPECT_FALSE(found.any());
}

TEST(LinkHours, TimesBeforeTheEpochHaveAnHourToo) {
  EXPECT_EQ(LinkHours::hourOf(hours(-1) - std::chrono::minutes(1)), 23);
  EXPECT_EQ(LinkHours::hourOf(hours(49)), 1);
}

TEST(LinkHours, ATimeThatWentBackIsCountedAsTheNewest) {
  LinkHours hours_of(kHalfLife);
  hours_of.note(at(hours(100), false));
  hours_of.note(at(hours(1), false));
  EXPECT_TRUE(std::isfinite(hours_of.weighed(link(), kEven, hours(1))));
}

}  // namespace
}  // namespace place_memory::core
