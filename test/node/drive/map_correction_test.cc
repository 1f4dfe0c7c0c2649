#include "node/drive/map_correction.h"

#include <gtest/gtest.h>

namespace place_memory::node {
namespace {

using config::Correct;
using core::Pose2d;

const std::optional<Pose2d> kUnknown;
const Pose2d kOne{1.0, 0.0, 0.0}, kOther{2.0, 0.0, 0.0};

TEST(MapCorrection, AlwaysFollows) {
  MapCorrection correction(Correct::kAlways);
  EXPECT_FALSE(correction.update(kUnknown));
  EXPECT_FALSE(correction.given());
  EXPECT_TRUE(correction.update(kOne));
  EXPECT_FALSE(correction.update(kOther));
  EXPECT_EQ(correction.given(), kOther);
  EXPECT_FALSE(correction.update(kUnknown));
  EXPECT_FALSE(correction.given());
  EXPECT_TRUE(correction.update(kOne));
}

TEST(MapCorrection, WhenLostFollowsOnceItIsKnownAnew) {
  MapCorrection correction(Correct::kWhenLost);
  EXPECT_TRUE(correction.update(kOne));
  EXPECT_FALSE(correction.update(kOther));
  EXPECT_EQ(correction.given(), kOne);
  correction.update(kUnknown);
  EXPECT_FALSE(correction.given());
  EXPECT_TRUE(correction.update(kOther));
  EXPECT_EQ(correction.given(), kOther);
  correction.request();
  EXPECT_TRUE(correction.update(kOne));
  EXPECT_EQ(correction.given(), kOne);
}

TEST(MapCorrection, OnRequestFollowsOnceForEach) {
  MapCorrection correction(Correct::kOnRequest);
  EXPECT_FALSE(correction.update(kOne));
  EXPECT_FALSE(correction.given());
  correction.request();
  EXPECT_FALSE(correction.update(kUnknown));
  EXPECT_TRUE(correction.update(kOne));
  EXPECT_FALSE(correction.update(kOther));
  EXPECT_FALSE(correction.update(kUnknown));
  EXPECT_EQ(correction.given(), kOne);
}

}  // namespace
}  // namespace place_memory::node
