#include "core/explore/new_ground.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

TEST(NewGround, AtFirstItDrivesTheLeastWay) {
  NewGround ground({20.0, 0.5, 0.05});
  ground.note(0.0, 10.0);
  EXPECT_FALSE(ground.isInVain(20.0));
  EXPECT_TRUE(ground.isInVain(20.1));
}

TEST(NewGround, LaterAShareOfTheWayBefore) {
  NewGround ground({20.0, 0.5, 0.05});
  ground.note(100.0, 80.0);
  EXPECT_FALSE(ground.isInVain(150.0));
  EXPECT_TRUE(ground.isInVain(150.1));
  EXPECT_EQ(ground.grewAt(), 100.0);
}

TEST(NewGround, LittleByLittleItGrowsToo) {
  NewGround ground({20.0, 0.5, 0.05});
  ground.note(0.0, 100.0);
  ground.note(10.0, 103.0);
  EXPECT_EQ(ground.grewAt(), 0.0);
  ground.note(15.0, 106.0);
  EXPECT_EQ(ground.grewAt(), 15.0);
  EXPECT_FALSE(ground.isInVain(30.0));
}

TEST(NewGround, WhatIsForgottenByAMapThatMovedIsNoGrowth) {
  NewGround ground({20.0, 0.5, 0.05});
  ground.note(0.0, 100.0);
  ground.note(5.0, 80.0);
  ground.note(10.0, 100.0);
  EXPECT_EQ(ground.grewAt(), 0.0);
}

}  // namespace
}  // namespace place_memory::core
