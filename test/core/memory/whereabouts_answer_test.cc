#include <gtest/gtest.h>

#include "core/memory/whereabouts.h"

namespace place_memory::core {
namespace {

Sighting sightingOf(const Place& place) {
  Sighting sighting;
  sighting.place = place;
  return sighting;
}

TEST(WhereaboutsAnswer, OfTwoAnswersTheNewerHasTheHigherVersion) {
  WhereaboutsOwner owner(true, true, kFirstSession);
  Place place;
  place.id = 1;
  std::uint64_t last = owner.now().version;
  const auto expect_newer = [&] {
    EXPECT_GT(owner.now().version, last);
    last = owner.now().version;
  };
  // Two that are not sure, in a row, change nothing else.
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(owner.notRecognized(owner.ask()));
    expect_newer();
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(owner.recognized(owner.ask(), sightingOf(place)).superseded);
    expect_newer();
  }
}

TEST(WhereaboutsAnswer, OneThatWasOvertakenChangesNothing) {
  WhereaboutsOwner owner(true, true, kFirstSession);
  Place place;
  place.id = 1;
  const std::uint64_t older = owner.ask();
  EXPECT_FALSE(owner.notRecognized(owner.ask()));
  const std::uint64_t version = owner.now().version;
  EXPECT_TRUE(owner.notRecognized(older));
  EXPECT_TRUE(owner.recognized(older, sightingOf(place)).superseded);
  EXPECT_EQ(owner.now().version, version);
  EXPECT_EQ(owner.now().current, kNoPlace);
}

}  // namespace
}  // namespace place_memory::core
