#include "core/mapping/closure_candidates.h"

#include <gtest/gtest.h>

namespace place_memory::core {
namespace {

constexpr std::size_t kPlaces = 20;

const auto kNowhere = [](const Pose2d&) { return false; };
const auto kEverywhere = [](const Pose2d&) { return true; };

/// A robot that drives along x and is seen elsewhere.
struct Drive {
  ClosureCandidates candidates{ClosureOptions{}};
  double way = 0.0;
  std::size_t node = 0;

  template <typename AtPlace>
  void scan(const std::vector<Sighting>& sightings, const AtPlace& at_place) {
    candidates.update(node++, way, 3.0, {way, 0.0, 0.0}, sightings, at_place);
    way += 0.5;
  }
  /// Where a shift by `dx` and `dy` would put it; each metre has a place.
  Sighting shifted(double dx, double dy, double probability) const {
    return {static_cast<PlaceId>(100.0 + way + dx), probability, {way + dx, dy, 0.0}};
  }
};

TEST(ClosureCandidates, OneSureScanIsNoWitnessEnough) {
  Drive drive;
  drive.scan({drive.shifted(5.0, 1.0, 0.999)}, kNowhere);
  EXPECT_FALSE(drive.candidates.empty());
  EXPECT_EQ(drive.candidates.accepted(kPlaces), nullptr);
}

TEST(ClosureCandidates, ScansThatAgreeOverThreeMetresAreEnough) {
  Drive drive;
  int scans = 0;
  while (!drive.candidates.accepted(kPlaces) && scans < 20) {
    drive.scan({drive.shifted(5.0, 1.0, 0.9)}, kEverywhere);
    ++scans;
  }
  ASSERT_NE(drive.candidates.accepted(kPlaces), nullptr);
  EXPECT_EQ(scans, 7);  // three metres at half a metre a scan
  EXPECT_NEAR(drive.candidates.accepted(kPlaces)->target_from_estimate.x, 5.0, 1e-6);
  EXPECT_NEAR(drive.candidates.accepted(kPlaces)->target_from_estimate.y, 1.0, 1e-6);
}

TEST(ClosureCandidates, OnePlaceSeenAgainAndAgainIsNoWayThroughTheBuilding) {
  Drive drive;
  for (int i = 0; i < 40; ++i) {
    Sighting seen = drive.shifted(3.0, 1.0, 0.9);
    seen.place = 7;
    drive.scan({seen}, kEverywhere);
  }
  EXPECT_EQ(drive.candidates.accepted(kPlaces), nullptr);
  // A map that has no more cannot show more.
  EXPECT_NE(drive.candidates.accepted(1), nullptr);
}

TEST(ClosureCandidates, AMapOfAFewPlacesMovesNoRobotFar) {
  const auto scanTwoPlaces = [](Drive& drive) {
    for (int i = 0; i < 40; ++i) {
      Sighting seen = drive.shifted(9.0, 0.0, 0.9);
      seen.place = 7 + i / 20;
      drive.scan({seen}, kEverywhere);
    }
  };
  Drive drive;
  scanTwoPlaces(drive);
  EXPECT_EQ(drive.candidates.accepted(2), nullptr);
  // One that may be anywhere is asked for no more.
  ClosureOptions options;
  options.farther = 0.0;
  Drive anywhere;
  anywhere.candidates = ClosureCandidates(options);
  scanTwoPlaces(anywhere);
  EXPECT_NE(anywhere.candidates.accepted(2), nullptr);
}

TEST(ClosureCandidates, TheFartherItMovesTheRobotTheMorePlacesItTakes) {
  const auto scansFor = [](double moves) {
    Drive drive;
    int scans = 0;
    while (!drive.candidates.accepted(kPlaces) && scans < 40) {
      drive.scan({drive.shifted(moves, 0.0, 0.9)}, kEverywhere);
      ++scans;
    }
    return scans;
  };
  EXPECT_LT(scansFor(3.0), scansFor(13.0));
  EXPECT_LT(scansFor(13.0), scansFor(21.0));
  EXPECT_LT(scansFor(21.0), 20);
}

TEST(ClosureCandidates, WhereOdometryHardlyReachesItTakesMore) {
  Drive drive;
  int scans = 0;
  while (!drive.candidates.accepted(kPlaces) && scans < 40) {
    Sighting seen = drive.shifted(5.0, 1.0, 0.9);
    seen.prior = -4.0;
    drive.scan({seen}, kEverywhere);
    ++scans;
  }
  EXPECT_EQ(scans, 15);  // seven metres
}

TEST(ClosureCandidates, SightingsAllOverThePlaceAgreeWithNothing) {
  Drive drive;
  for (int i = 0; i < 40; ++i) {
    drive.scan({drive.shifted(3.0 * (i % 7), 2.5 * (i % 5), 0.95)}, kEverywhere);
    EXPECT_EQ(drive.candidates.accepted(kPlaces), nullptr) << i;
  }
}

TEST(ClosureCandidates, TwoThatAreAsGoodWait) {
  Drive drive;
  for (int i = 0; i < 20; ++i) {
    drive.scan({drive.shifted(5.0, 0.0, 0.45), drive.shifted(9.0, 0.0, 0.45)}, kNowhere);
  }
  EXPECT_EQ(drive.candidates.accepted(kPlaces), nullptr);
  // Once one of them is not seen where it should be, the other one is it.
  for (int i = 0; i < 6; ++i) drive.scan({drive.shifted(5.0, 0.0, 0.9)}, kEverywhere);
  ASSERT_NE(drive.candidates.accepted(kPlaces), nullptr);
  EXPECT_NEAR(drive.candidates.accepted(kPlaces)->target_from_estimate.x, 5.0, 0.01);
}

TEST(ClosureCandidates, MissesAtKnownPlacesSpeakAgainst) {
  Drive drive;
  for (int i = 0; i < 12; ++i) {
    std::vector<Sighting> sightings;
    if (i % 3 == 0) sightings.push_back(drive.shifted(5.0, 0.0, 0.6));
    drive.scan(sightings, kEverywhere);
    EXPECT_EQ(drive.candidates.accepted(kPlaces), nullptr);
  }
}

TEST(ClosureCandidates, WithoutFurtherWitnessesOneIsDropped) {
  Drive drive;
  for (int i = 0; i < 4; ++i) drive.scan({drive.shifted(5.0, 0.0, 0.9)}, kNowhere);
  EXPECT_FALSE(drive.candidates.empty());
  for (int i = 0; i < 10; ++i) drive.scan({}, kNowhere);
  EXPECT_TRUE(drive.candidates.empty());
}

TEST(ClosureCandidates, NothingComesOfOneThatAPersonCut) {
  Drive drive;
  for (int i = 0; i < 3; ++i) drive.scan({drive.shifted(5.0, 1.0, 0.9)}, kEverywhere);
  const PlaceId seen = drive.candidates.foremost()->witnesses.back().place;
  EXPECT_FALSE(drive.candidates.cut(4711));
  EXPECT_TRUE(drive.candidates.cut(seen));
  EXPECT_FALSE(drive.candidates.cut(seen));
  EXPECT_TRUE(drive.candidates.empty());
  EXPECT_EQ(drive.candidates.at(seen), nullptr);
  for (int i = 0; i < 20; ++i) {
    drive.scan({drive.shifted(5.0, 1.0, 0.9)}, kEverywhere);
    EXPECT_EQ(drive.candidates.foremost(), nullptr) << i;
    EXPECT_EQ(drive.candidates.accepted(kPlaces), nullptr) << i;
  }
}

TEST(ClosureCandidates, AnotherOneGoesOnBesideOneThatWasCut) {
  Drive drive;
  for (int i = 0; i < 3; ++i) {
    drive.scan({drive.shifted(5.0, 0.0, 0.9), drive.shifted(9.0, 0.0, 0.9)}, kNowhere);
  }
  ASSERT_TRUE(drive.candidates.cut(drive.candidates.foremost()->witnesses.back().place));
  ASSERT_NE(drive.candidates.foremost(), nullptr);
  const double other = drive.candidates.foremost()->target_from_estimate.x;
  while (!drive.candidates.accepted(kPlaces) && drive.node < 20) {
    drive.scan({drive.shifted(5.0, 0.0, 0.9), drive.shifted(9.0, 0.0, 0.9)}, kNowhere);
  }
  // No more as good as each other: one of them is known to be wrong.
  ASSERT_NE(drive.candidates.accepted(kPlaces), nullptr);
  EXPECT_NEAR(drive.candidates.accepted(kPlaces)->target_from_estimate.x, other, 0.01);
}

TEST(ClosureCandidates, OneThatWasCutIsForgottenOnceScansNoMoreSaySo) {
  Drive drive;
  for (int i = 0; i < 3; ++i) drive.scan({drive.shifted(5.0, 1.0, 0.9)}, kNowhere);
  ASSERT_TRUE(drive.candidates.cut(drive.candidates.foremost()->witnesses.back().place));
  for (int i = 0; i < 10; ++i) drive.scan({}, kNowhere);
  drive.scan({drive.shifted(5.0, 1.0, 0.9)}, kNowhere);
  EXPECT_NE(drive.candidates.foremost(), nullptr);
}

TEST(ClosureCandidates, FollowsOdometryThatDrifts) {
  Drive drive;
  for (int i = 0; i < 12; ++i) {
    drive.scan({drive.shifted(5.0 + 0.05 * i, 0.02 * i, 0.9)}, kEverywhere);
  }
  ASSERT_NE(drive.candidates.accepted(kPlaces), nullptr);
  EXPECT_NEAR(drive.candidates.accepted(kPlaces)->target_from_estimate.x, 5.5, 0.15);
}

}  // namespace
}  // namespace place_memory::core
