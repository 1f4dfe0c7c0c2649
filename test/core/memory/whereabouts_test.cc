#include "core/memory/whereabouts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace place_memory::core {
namespace {

constexpr bool kLocated = true;
constexpr bool kEmpty = true;

Place makePlace(PlaceId id, SessionId session, const Pose2d& map_from_place) {
  Place place;
  place.id = id;
  place.label = "place of " + std::to_string(id);
  place.session = session;
  place.map_from_place = map_from_place;
  return place;
}

/// Seen from its middle.
Sighting sightingOf(const Place& place, const Pose2d& odom_from_scan) {
  return {place, {}, odom_from_scan, {}};
}

void expectNear(const Pose2d& expected, const Pose2d& pose) {
  EXPECT_NEAR(expected.x, pose.x, 1e-9);
  EXPECT_NEAR(expected.y, pose.y, 1e-9);
  EXPECT_NEAR(wrapAngle(expected.yaw - pose.yaw), 0.0, 1e-9);
}

const Place kKitchen = makePlace(4, 1, {7.5, 1.0, kPi / 2.0});

TEST(Whereabouts, InAnEmptyMapOdometrysFrameIsTheMaps) {
  const WhereaboutsOwner owner(kLocated, kEmpty, 1);
  EXPECT_EQ(owner.now().session, 1);
  EXPECT_EQ(owner.now().map_from_odom, Pose2d{});
  EXPECT_EQ(owner.now().previous, kNoPlace);
  const Footing footing = owner.footing(9);
  EXPECT_EQ(footing.session, 1);
  EXPECT_FALSE(footing.apart);
  EXPECT_FALSE(footing.previous);
}

TEST(Whereabouts, WithPlacesKnownWhereOdometryBeganIsNot) {
  const WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  EXPECT_EQ(owner.now().session, kNoSession);
  EXPECT_FALSE(owner.now().map_from_odom);
  const Footing footing = owner.footing(2);
  EXPECT_EQ(footing.session, 2);
  EXPECT_EQ(footing.map_from_odom, Pose2d{});
  EXPECT_TRUE(footing.apart);
}

TEST(Whereabouts, ARecognizedPlaceSaysWhereOdometryBegan) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  const std::uint64_t version = owner.now().version;
  const Settled settled =
      owner.recognized(owner.ask(), {kKitchen, {0.5, 0.0, 0.0}, {2.0, 0.0, 0.0}, {}});
  EXPECT_FALSE(settled.superseded);
  EXPECT_FALSE(settled.join);
  EXPECT_EQ(settled.came_from, kNoPlace);
  const Whereabouts& now = owner.now();
  EXPECT_GT(now.version, version);
  EXPECT_EQ(now.session, 1);
  expectNear({7.5, -0.5, kPi / 2.0}, *now.map_from_odom);
  EXPECT_EQ(now.previous, 4);
  EXPECT_EQ(now.current, 4);
  EXPECT_EQ(now.current_label, kKitchen.label);
  const Footing footing = owner.footing(2);
  EXPECT_EQ(footing.session, 1);
  EXPECT_FALSE(footing.apart);
  expectNear({1.5, 0.0, 0.0}, footing.previous->odom_from_place);
}

TEST(Whereabouts, ASessionApartIsJoinedByTheFirstPlaceRecognized) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  const Place apart = makePlace(5, 2, {3.42, 0.0, 0.0});
  EXPECT_FALSE(owner.learned(owner.ask(), owner.footing(2), apart, apart.map_from_place));
  EXPECT_TRUE(owner.now().apart);
  EXPECT_EQ(owner.now().session, 2);
  EXPECT_EQ(owner.now().map_from_odom, Pose2d{});
  const Settled settled = owner.recognized(owner.ask(), sightingOf(kKitchen, {}));
  ASSERT_TRUE(settled.join);
  EXPECT_EQ(settled.join->from, 2);
  EXPECT_EQ(settled.join->into, 1);
  expectNear({7.5, 4.42, kPi / 2.0}, settled.join->into_from_from * apart.map_from_place);
  EXPECT_FALSE(owner.now().apart);
  EXPECT_EQ(owner.now().session, 1);
}

TEST(Whereabouts, TheLaterOfTwoSessionsMoves) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 9);
  owner.recognized(owner.ask(), sightingOf(kKitchen, {}));
  const Pose2d map_from_odom = *owner.now().map_from_odom;
  const Place later = makePlace(8, 3, {100.0, 0.0, 0.0});
  const Settled settled = owner.recognized(owner.ask(), sightingOf(later, {2.0, 0.0, 0.0}));
  ASSERT_TRUE(settled.join);
  EXPECT_EQ(settled.join->from, 3);
  EXPECT_EQ(settled.join->into, 1);
  expectNear({7.5, 3.0, kPi / 2.0}, settled.join->into_from_from * later.map_from_place);
  EXPECT_EQ(owner.now().session, 1);
  expectNear(map_from_odom, *owner.now().map_from_odom);
}

TEST(Whereabouts, WhatWasOvertakenChangesNothing) {
  WhereaboutsOwner owner(kLocated, kEmpty, 1);
  const std::uint64_t old = owner.ask();
  const Place place = makePlace(5, 1, {1.0, 0.0, 0.0});
  owner.learned(owner.ask(), owner.footing(1), place, place.map_from_place);
  const std::uint64_t version = owner.now().version;
  EXPECT_TRUE(owner.recognized(old, sightingOf(kKitchen, {})).superseded);
  EXPECT_TRUE(owner.notRecognized(old));
  EXPECT_EQ(owner.now().version, version);
  EXPECT_EQ(owner.now().previous, 5);
  EXPECT_EQ(owner.now().map_from_odom, Pose2d{});
}

TEST(Whereabouts, WhatIsNotRecognizedLeavesThePreviousPlace) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  owner.recognized(owner.ask(), sightingOf(kKitchen, {}));
  EXPECT_FALSE(owner.notRecognized(owner.ask()));
  EXPECT_EQ(owner.now().current, kNoPlace);
  EXPECT_EQ(owner.now().current_label, "");
  EXPECT_EQ(owner.now().previous, 4);
  EXPECT_TRUE(owner.now().map_from_odom);
}

TEST(Whereabouts, AJumpForgetsAllButTheVersion) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  const std::uint64_t before = owner.ask();
  owner.recognized(owner.ask(), sightingOf(kKitchen, {}));
  const std::uint64_t version = owner.now().version;
  owner.forget(!kEmpty);
  EXPECT_GT(owner.now().version, version);
  EXPECT_EQ(owner.now().session, kNoSession);
  EXPECT_FALSE(owner.now().map_from_odom);
  EXPECT_EQ(owner.now().previous, kNoPlace);
  EXPECT_EQ(owner.now().current, kNoPlace);
  EXPECT_EQ(owner.now().current_label, "");
  EXPECT_TRUE(owner.recognized(before, sightingOf(kKitchen, {})).superseded);
}

TEST(Whereabouts, APlaceLearnedBeforeAJumpSaysNothingOfAfterIt) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  const Footing footing = owner.footing(2);
  const std::uint64_t question = owner.ask();
  owner.forget(!kEmpty);
  EXPECT_FALSE(owner.learned(question, footing, makePlace(5, 2, {}), {}));
  EXPECT_EQ(owner.now().session, kNoSession);
  EXPECT_EQ(owner.now().previous, kNoPlace);
}

// An older question is answered while a place that was learned after it is being stored.
TEST(Whereabouts, APlaceStoredApartWhileTheRobotIsRecognizedIsJoined) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  const std::uint64_t older = owner.ask();
  const std::uint64_t question = owner.ask();
  const Footing footing = owner.footing(2);
  owner.recognized(older, sightingOf(kKitchen, {}));
  const Place apart = makePlace(5, 2, {2.0, 0.0, 0.0});
  const auto join = owner.learned(question, footing, apart, apart.map_from_place);
  ASSERT_TRUE(join);
  EXPECT_EQ(join->from, 2);
  EXPECT_EQ(join->into, 1);
  expectNear({7.5, 3.0, kPi / 2.0}, join->into_from_from * apart.map_from_place);
  EXPECT_EQ(owner.now().session, 1);
  EXPECT_EQ(owner.now().previous, 5);
}

TEST(Whereabouts, WithoutOdometryThereIsOneFrame) {
  WhereaboutsOwner owner(!kLocated, !kEmpty, 7);
  EXPECT_EQ(owner.now().map_from_odom, Pose2d{});
  owner.recognized(owner.ask(), sightingOf(kKitchen, {}));
  EXPECT_EQ(owner.now().map_from_odom, Pose2d{});
  owner.forget(!kEmpty);
  EXPECT_EQ(owner.now().map_from_odom, Pose2d{});
  const Footing footing = owner.footing(7);
  EXPECT_EQ(footing.session, kFirstSession);
  EXPECT_FALSE(footing.apart);
}

TEST(Whereabouts, TheCurrentPlaceFollowsItsNewLabelAndItsEnd) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  owner.recognized(owner.ask(), sightingOf(kKitchen, {}));
  owner.follow({1, {}, {PlaceRenamed{3, "other"}, PlaceRenamed{4, "pantry"}}}, !kEmpty);
  EXPECT_EQ(owner.now().current_label, "pantry");
  const std::uint64_t version = owner.now().version;
  owner.follow({2, {}, {PlaceRemoved{4}}}, !kEmpty);
  EXPECT_GT(owner.now().version, version);
  EXPECT_EQ(owner.now().previous, kNoPlace);
  EXPECT_EQ(owner.now().current, kNoPlace);
  EXPECT_FALSE(owner.footing(2).previous);
  EXPECT_TRUE(owner.now().map_from_odom);
}

TEST(Whereabouts, AMapWithoutPlacesBeginsAnew) {
  WhereaboutsOwner owner(kLocated, !kEmpty, 2);
  owner.recognized(owner.ask(), sightingOf(kKitchen, {}));
  const std::uint64_t before = owner.ask();
  owner.follow({1, {}, {MapCleared{}}}, kEmpty);
  EXPECT_EQ(owner.now().map_from_odom, Pose2d{});
  EXPECT_EQ(owner.now().current, kNoPlace);
  EXPECT_TRUE(owner.notRecognized(before));
  EXPECT_FALSE(owner.footing(3).apart);
  EXPECT_EQ(owner.footing(3).session, 3);
}

}  // namespace
}  // namespace place_memory::core
