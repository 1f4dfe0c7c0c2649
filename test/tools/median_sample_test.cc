#include "tools/median_sample.h"

#include <gtest/gtest.h>

namespace place_memory::tools {
namespace {

TEST(MedianSample, IsTheLowerOneOfAFew) {
  MedianSample sample;
  EXPECT_TRUE(sample.empty());
  sample.add(3.0);
  EXPECT_EQ(sample.median(), 3.0);
  sample.add(1.0);
  EXPECT_EQ(sample.median(), 1.0);
  sample.add(2.0);
  EXPECT_EQ(sample.median(), 2.0);
}

TEST(MedianSample, IsNearTheOneOfMany) {
  MedianSample sample;
  for (int i = 0; i < 1000000; ++i) sample.add(i);
  EXPECT_NEAR(sample.median(), 500000.0, 2000.0);
}

TEST(MedianSample, WildValuesDoNotMoveIt) {
  MedianSample sample;
  for (int i = 0; i < 30000; ++i) sample.add(i % 3 == 0 ? 1.7e9 : 0.25);
  EXPECT_EQ(sample.median(), 0.25);
}

}  // namespace
}  // namespace place_memory::tools
