#include "core/drive/passage_watch.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

using std::chrono::seconds;

TEST(PassageWatch, TellsOfEachWayFromOnePlaceToTheNext) {
  PassageWatch watch("driving");
  EXPECT_FALSE(watch.at(1, seconds(10)));
  EXPECT_FALSE(watch.at(1, seconds(12)));
  const auto came = watch.at(2, seconds(20));
  ASSERT_TRUE(came);
  EXPECT_EQ(*came, (Traversal{1, 2, seconds(12), seconds(20), true, "driving"}));
  EXPECT_EQ(*watch.at(1, seconds(25)),
            (Traversal{2, 1, seconds(20), seconds(25), true, "driving"}));
}

TEST(PassageWatch, SaysNothingOfARobotThatWasCarriedOrOfTimeThatRanBack) {
  PassageWatch watch("");
  watch.at(1, seconds(10));
  watch.lost();
  EXPECT_FALSE(watch.at(2, seconds(20)));
  EXPECT_FALSE(watch.at(3, seconds(5)));
}

}  // namespace
}  // namespace place_memory::core
