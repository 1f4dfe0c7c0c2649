#include "tools/quantile_sample.h"

#include <gtest/gtest.h>

namespace place_memory::tools {
namespace {

TEST(QuantileSample, IsAmongAFew) {
  QuantileSample sample;
  EXPECT_TRUE(sample.empty());
  sample.add(3.0);
  EXPECT_EQ(sample.quantile(0.5), 3.0);
  sample.add(1.0);
  EXPECT_EQ(sample.quantile(0.5), 1.0);
  sample.add(2.0);
  EXPECT_EQ(sample.quantile(0.5), 2.0);
  EXPECT_EQ(sample.quantile(0.1), 1.0);
  EXPECT_EQ(sample.quantile(1.0), 3.0);
  EXPECT_EQ(sample.quantile(0.1, 1.5), 2.0);
}

TEST(QuantileSample, IsNearThatOfMany) {
  QuantileSample sample;
  for (int i = 0; i < 1000000; ++i) sample.add(i);
  EXPECT_NEAR(sample.quantile(0.5), 500000.0, 2000.0);
  EXPECT_NEAR(sample.quantile(0.1), 100000.0, 2000.0);
}

TEST(QuantileSample, WildValuesDoNotMoveIt) {
  QuantileSample sample;
  for (int i = 0; i < 30000; ++i) sample.add(i % 3 == 0 ? 1.7e9 : 0.25);
  EXPECT_EQ(sample.quantile(0.5), 0.25);
}

}  // namespace
}  // namespace place_memory::tools
