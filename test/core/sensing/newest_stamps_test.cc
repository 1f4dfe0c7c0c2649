#include "core/sensing/newest_stamps.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

using std::chrono::milliseconds;

constexpr SensorId kLeft = 1;
constexpr SensorId kRight = 2;

TEST(NewestStamps, FollowEachSensorByItself) {
  NewestStamps stamps;
  EXPECT_EQ(stamps.note(kLeft, milliseconds(10000)), TimeOrder::kForward);
  EXPECT_EQ(stamps.note(kRight, milliseconds(5000)), TimeOrder::kForward);
  EXPECT_EQ(stamps.note(kLeft, milliseconds(9500)), TimeOrder::kLate);
  EXPECT_EQ(stamps.note(kRight, milliseconds(3000)), TimeOrder::kBackwards);
}

TEST(NewestStamps, AStaleStampIsNotTheNewest) {
  NewestStamps stamps;
  stamps.note(kLeft, milliseconds(10000));
  EXPECT_EQ(stamps.note(kLeft, milliseconds(5000)), TimeOrder::kBackwards);
  EXPECT_EQ(stamps.note(kLeft, milliseconds(5100)), TimeOrder::kBackwards);
  EXPECT_EQ(stamps.newest(kLeft), milliseconds(10000));
  EXPECT_EQ(stamps.note(kLeft, milliseconds(10100)), TimeOrder::kForward);
}

TEST(NewestStamps, ALateStampIsNotTheNewest) {
  NewestStamps stamps;
  stamps.note(kLeft, milliseconds(10000));
  stamps.note(kLeft, milliseconds(9200));
  EXPECT_EQ(stamps.note(kLeft, milliseconds(8900)), TimeOrder::kBackwards);
}

TEST(NewestStamps, ASecondIsLateAndMoreIsStale) {
  NewestStamps stamps;
  stamps.note(kLeft, milliseconds(10000));
  EXPECT_EQ(stamps.note(kLeft, milliseconds(9000)), TimeOrder::kLate);
  EXPECT_EQ(stamps.note(kLeft, milliseconds(8999)), TimeOrder::kBackwards);
  EXPECT_EQ(stamps.note(kLeft, milliseconds(10000)), TimeOrder::kForward);
}

}  // namespace
}  // namespace place_memory::core
