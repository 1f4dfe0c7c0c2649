#include "node/scan/newest_stamps.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using core::TimeOrder;
using std::chrono::milliseconds;

TEST(NewestStamps, FollowEachFrameByItself) {
  NewestStamps stamps;
  EXPECT_EQ(stamps.note("left", milliseconds(10000)), TimeOrder::kForward);
  EXPECT_EQ(stamps.note("right", milliseconds(5000)), TimeOrder::kForward);
  EXPECT_EQ(stamps.note("left", milliseconds(9500)), TimeOrder::kLate);
  EXPECT_EQ(stamps.note("right", milliseconds(3000)), TimeOrder::kBackwards);
}

TEST(NewestStamps, GoOnFromWhereTimeWasSetBackTo) {
  NewestStamps stamps;
  stamps.note("left", milliseconds(10000));
  EXPECT_EQ(stamps.note("left", milliseconds(5000)), TimeOrder::kBackwards);
  EXPECT_EQ(stamps.note("left", milliseconds(5100)), TimeOrder::kForward);
}

TEST(NewestStamps, ALateStampIsNotTheNewest) {
  NewestStamps stamps;
  stamps.note("left", milliseconds(10000));
  stamps.note("left", milliseconds(9200));
  EXPECT_EQ(stamps.note("left", milliseconds(8900)), TimeOrder::kBackwards);
}

TEST(NewestStamps, FollowABoundedNumberOfFrames) {
  NewestStamps stamps;
  for (std::size_t i = 0; i <= NewestStamps::kMaxFrames; ++i) {
    stamps.note(std::to_string(i), milliseconds(10000));
  }
  EXPECT_EQ(stamps.note("0", milliseconds(0)), TimeOrder::kBackwards);
  EXPECT_EQ(stamps.note(std::to_string(NewestStamps::kMaxFrames), milliseconds(0)),
            TimeOrder::kForward);
}

}  // namespace
}  // namespace place_memory::node
