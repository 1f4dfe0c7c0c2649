#include "core/memory/twins.h"

#include <gtest/gtest.h>

#include <map>

#include "core/random_scan.h"

namespace place_memory::core {
namespace {

/// Places 1 to 5, ten metres apart along x, each linked to the next; 1 and 4 look alike but for a
/// wall to the north of 4.
class TwinsTest : public testing::Test {
 protected:
  TwinsTest() {
    std::vector<Place> places;
    std::vector<PlaceLink> links;
    for (PlaceId id = 1; id <= 5; ++id) {
      Place place;
      place.id = id;
      place.label = "place " + std::to_string(id);
      place.map_from_place = {10.0 * static_cast<double>(id), 0.0, 0.0};
      places.push_back(place);
      scans_[id] = makeRandomScan(id == 4 ? 1 : static_cast<unsigned>(id));
      if (id == 4) {
        for (std::size_t column = 25; column < 39; ++column) {
          scans_[id].grid.cells()[50 * 64 + column] = 70;
        }
      }
      index_.put(id, scans_[id].grid);
      if (id == 1) continue;
      PlaceLink link;
      link.first = id - 1;
      link.second = id;
      links.push_back(link);
    }
    map_ = PlaceMap(places, links, 1, {});
  }

  std::vector<Twin> find(const TwinOptions& options) const {
    return findTwins(
        map_, index_, Recognizer(RecognizerOptions{}),
        [this](const Place& place) { return scans_.at(place.id); }, options);
  }

  std::map<PlaceId, Scan> scans_;
  PlaceMap map_;
  PlaceIndex index_;
};

TEST_F(TwinsTest, AreNamedBothWaysWithWhatPartsThem) {
  TwinOptions options;
  options.most = 1;
  options.least_likeness = 0.5;
  options.heading_window = 0.2;
  const std::vector<Twin> twins = find(options);
  ASSERT_EQ(twins.size(), 2U);
  for (const Twin& twin : twins) {
    EXPECT_EQ(twin.place + twin.other, 5);  // 1 and 4
    EXPECT_GT(twin.likeness, 0.5);
    EXPECT_LT(twin.likeness, 1.01);
    EXPECT_NEAR(twin.parting_bearing, kPi / 2.0, 0.5);
    const GridGeometry geometry;
    EXPECT_NEAR(twin.parting_distance, geometry.centre(50), 0.6);
    // What lies beside them looks like nothing else.
    EXPECT_NE(twin.parting_place, kNoPlace);
  }
}

/// Rooms of one plan, and four places that look like nothing else.
TEST(Twins, OfCopiedRoomsEachIsNamedWithAllOthers) {
  constexpr PlaceId kRooms = 8;
  std::vector<Place> places;
  PlaceIndex index;
  for (PlaceId id = 1; id <= kRooms + 4; ++id) {
    Place place;
    place.id = id;
    place.label = "place " + std::to_string(id);
    place.map_from_place = {10.0 * static_cast<double>(id), 0.0, 0.0};
    places.push_back(place);
    index.put(id, makeRandomScan(id <= kRooms ? 1 : static_cast<unsigned>(id)).grid);
  }
  const auto scan_of = [](const Place& place) {
    return makeRandomScan(place.id <= kRooms ? 1 : static_cast<unsigned>(place.id));
  };
  std::map<PlaceId, std::size_t> named;
  for (const Twin& twin : findTwins(PlaceMap(places, {}, 1, {}), index,
                                    Recognizer(RecognizerOptions{}), scan_of, TwinOptions{})) {
    if (twin.other <= kRooms && twin.place <= kRooms) ++named[twin.place];
  }
  for (PlaceId id = 1; id <= kRooms; ++id) EXPECT_EQ(named[id], kRooms - 1) << id;
}

TEST_F(TwinsTest, WhatLooksLikeNothingElseHasNone) {
  TwinOptions options;
  options.least_likeness = 0.9999;
  EXPECT_TRUE(find(options).empty());
}

}  // namespace
}  // namespace place_memory::core
