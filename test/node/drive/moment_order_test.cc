#include "node/drive/moment_order.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace place_memory::node {
namespace {

using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using std::chrono::seconds;

DriveMoment reading(int stamp, const std::string& frame) {
  core::Measurement measurement;
  measurement.stamp = nanoseconds(stamp);
  measurement.frame = frame;
  return {nanoseconds(stamp), measurement};
}

DriveMoment odometry(int stamp) {
  DrivenTransform moved;
  moved.transform.child_frame_id = "base_link";
  return {nanoseconds(stamp), moved};
}

DriveMoment heading(int stamp) { return {nanoseconds(stamp), DrivenHeading{0.0}}; }

/// As "h10 s10 o10".
std::string inWords(const std::vector<DriveMoment>& moments) {
  std::string words;
  for (const DriveMoment& moment : moments) {
    words += (words.empty() ? "" : " ") + std::string(1, "hso"[moment.what.index()]) +
             std::to_string(moment.stamp.count());
  }
  return words;
}

class MomentOrderTest : public testing::Test {
 protected:
  void add(const DriveMoment& moment) { EXPECT_TRUE(order_.add(moment, now_)); }
  std::string take() { return inWords(order_.take(now_)); }
  /// Past the start, at which it is waited for inputs that were not heard yet.
  void start() {
    add(heading(1));
    add(reading(1, "a"));
    add(odometry(1));
    now_ += MomentOrder::kPatience;
    EXPECT_EQ(take(), "h1 s1 o1");
  }

  MomentOrder order_;
  nanoseconds now_ = seconds(100);
};

TEST_F(MomentOrderTest, AtFirstEveryInputIsWaitedFor) {
  add(reading(1, "a"));
  add(reading(2, "a"));
  now_ += MomentOrder::kPatience - milliseconds(1);
  EXPECT_EQ(take(), "");
  add(heading(1));
  now_ += milliseconds(1);
  EXPECT_EQ(take(), "h1 s1 s2");
}

TEST_F(MomentOrderTest, WhicheverInputIsAheadTheOrderIsThatOfStamps) {
  start();
  add(odometry(10));
  add(odometry(20));
  add(reading(10, "a"));
  EXPECT_EQ(take(), "");  // the heading is at 1
  add(heading(10));
  EXPECT_EQ(take(), "");  // more of that very stamp may come
  add(heading(15));
  add(reading(20, "a"));
  EXPECT_EQ(take(), "h10 s10 o10");
  add(heading(25));
  EXPECT_EQ(take(), "h15");
}

TEST_F(MomentOrderTest, AnInputThatIsBehindIsWaitedForSoLong) {
  start();
  add(odometry(10));
  add(reading(12, "a"));
  now_ += MomentOrder::kPatience - milliseconds(1);
  EXPECT_EQ(take(), "");
  add(reading(13, "a"));
  now_ += milliseconds(1);
  EXPECT_EQ(take(), "o10 s12");
  EXPECT_FALSE(order_.add(heading(11), now_));
  add(heading(12));
  EXPECT_EQ(order_.waiting(), 2U);
}

TEST_F(MomentOrderTest, ASilentInputHoldsNothingUp) {
  start();
  now_ += MomentOrder::kSilence;
  add(odometry(10));
  add(reading(11, "a"));
  now_ += milliseconds(1);
  EXPECT_EQ(take(), "");  // the heading is silent for just so long
  add(odometry(20));
  add(reading(21, "a"));
  now_ += milliseconds(1);
  EXPECT_EQ(take(), "o10 s11");
}

TEST_F(MomentOrderTest, AfterTimeHasJumpedItBeginsAnew) {
  start();
  add(odometry(50));
  order_.clear();
  EXPECT_EQ(order_.waiting(), 0U);
  start();
}

}  // namespace
}  // namespace place_memory::node
