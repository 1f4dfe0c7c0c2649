#include "node/drive/drive_events.h"

#include <gtest/gtest.h>
#include <place_memory/MapEvent.h>

namespace place_memory::node {
namespace {

using core::Pose2d;

class DriveEventsTest : public testing::Test {
 protected:
  std::vector<DriveEvent> update(const std::optional<Pose2d>& map_from_odom,
                                 const std::vector<core::ScanDecision>& decisions = {},
                                 const std::vector<core::MapperEvent>& of_map = {}) {
    const OdometryMoment now{std::chrono::nanoseconds(5), {10.0, 0.0, 0.0}};
    return events_.update(now, decisions, of_map, map_from_odom);
  }

  DriveEvents events_{0.5, [](core::PlaceId id) { return "room " + std::to_string(id); }};
};

TEST_F(DriveEventsTest, ANewPlaceIsTold) {
  core::ScanDecision decision;
  decision.kind = core::ScanDecision::Kind::kNewPlace;
  decision.place = 4;
  core::ScanDecision other;
  const auto events = update(std::nullopt, {decision, other});
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, MapEvent::NEW_PLACE);
  EXPECT_EQ(events[0].places, std::vector<core::PlaceId>{4});
  EXPECT_EQ(events[0].sentence, "new place room 4");
}

TEST_F(DriveEventsTest, AClosureNamesItsWitnesses) {
  const core::MapperEvent closed{
      core::MapperEvent::Kind::kClosed, std::chrono::nanoseconds(7), {2, 3}};
  const auto events = update(std::nullopt, {}, {closed});
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, MapEvent::CLOSED);
  EXPECT_EQ(events[0].stamp.count(), 7);
  EXPECT_NE(events[0].sentence.find("room 2, room 3"), std::string::npos);
}

TEST_F(DriveEventsTest, ACorrectionThatMovesTheRobotFarIsToldWithItsReason) {
  EXPECT_EQ(update(Pose2d{}).at(0).kind, MapEvent::FOUND);
  EXPECT_TRUE(update(Pose2d{0.4, 0.0, 0.0}).empty());
  // The frame turns a little, and the robot is far from its origin.
  const core::MapperEvent closed{core::MapperEvent::Kind::kClosed, {}, {2}};
  const auto events = update(Pose2d{0.4, 0.0, 0.06}, {}, {closed});
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1].kind, MapEvent::JUMP);
  EXPECT_NE(events[1].sentence.find("0.60 m"), std::string::npos) << events[1].sentence;
  EXPECT_NE(events[1].sentence.find("a loop was closed"), std::string::npos);
  EXPECT_TRUE(update(std::nullopt).empty());
  EXPECT_EQ(update(Pose2d{9.0, 0.0, 0.0}).at(0).kind, MapEvent::FOUND);
}

}  // namespace
}  // namespace place_memory::node
