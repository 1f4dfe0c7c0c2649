#include "node/map/place_markers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "node/base/conversions.h"
#include "node/map/map_fixture.h"

namespace place_memory::node {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

const std_msgs::Header kHeader = makeHeader("map", ros::Time(7, 8));

MarkerArray markersOf(const core::MapSnapshot& map, std::size_t labels = 100,
                      const core::Pose2d& robot = {}) {
  return toMarkers(map, robot, labels, kHeader);
}

std::vector<Marker> under(const std::string& name, const MarkerArray& array) {
  std::vector<Marker> found;
  std::copy_if(array.markers.begin(), array.markers.end(), std::back_inserter(found),
               [&name](const Marker& marker) { return marker.ns == name; });
  return found;
}

std::set<std::string> labelsOf(const MarkerArray& array) {
  std::set<std::string> labels;
  for (const Marker& marker : under("labels", array)) labels.insert(marker.text);
  return labels;
}

core::MapSnapshot makeRow(int places) {
  core::MapSnapshot map;
  for (int i = 1; i <= places; ++i) map.places.push_back(makePlace(i, std::to_string(i), i));
  return map;
}

TEST(ToMarkers, RegionsAreOneListOfSpheresFiveFeetAcross) {
  const MarkerArray array = markersOf(makeChain());
  for (const Marker& marker : array.markers) EXPECT_EQ(marker.header.frame_id, "map");
  const std::vector<Marker> regions = under("regions", array);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].type, Marker::SPHERE_LIST);
  EXPECT_NEAR(regions[0].scale.x, 1.524, 1e-9);
  ASSERT_EQ(regions[0].points.size(), 3U);
  EXPECT_NEAR(regions[0].points[2].x, 6.0, 1e-9);
  EXPECT_NEAR(regions[0].points[2].y, 2.0, 1e-9);
  ASSERT_EQ(regions[0].colors.size(), 3U);
  EXPECT_GT(regions[0].colors[0].a, 0.0F);
  EXPECT_EQ(labelsOf(array), (std::set<std::string>{"a", "b", "c"}));
}

TEST(ToMarkers, ALinkIsALineBetweenItsPlaces) {
  const std::vector<Marker> links = under("links", markersOf(makeChain()));
  ASSERT_EQ(links.size(), 1U);
  EXPECT_EQ(links[0].type, Marker::LINE_LIST);
  ASSERT_EQ(links[0].points.size(), 4U);
  EXPECT_EQ(links[0].points[2].x, 3.0);
  EXPECT_EQ(links[0].points[3].x, 6.0);
  EXPECT_EQ(links[0].points[3].y, 2.0);
  EXPECT_EQ(links[0].colors.size(), 4U);
}

TEST(ToMarkers, EachSessionHasAColour) {
  core::MapSnapshot map = makeChain();
  map.places[2].session = 2;
  const MarkerArray array = markersOf(map);
  const Marker regions = under("regions", array).front();
  EXPECT_EQ(regions.colors[0], regions.colors[1]);
  EXPECT_NE(regions.colors[0], regions.colors[2]);
  const Marker links = under("links", array).front();
  EXPECT_EQ(links.colors[0], links.colors[2]);
  EXPECT_NE(links.colors[2], links.colors[3]);
}

TEST(ToMarkers, OnlyThePlacesNearestToTheRobotHaveALabel) {
  const core::MapSnapshot row = makeRow(50);
  EXPECT_EQ(labelsOf(markersOf(row, 3, {20.1, 2.0, 0.0})),
            (std::set<std::string>{"19", "20", "21"}));
  EXPECT_TRUE(labelsOf(markersOf(row, 0)).empty());
  EXPECT_EQ(labelsOf(markersOf(row, 50)).size(), 50U);
  EXPECT_EQ(under("regions", markersOf(row, 3)).front().points.size(), 50U);
}

TEST(ToMarkers, LabelsOfACrowdedMapLeaveEachOtherRoom) {
  core::MapSnapshot map;
  for (int i = 0; i < 1000; ++i) {
    map.places.push_back(makePlace(i + 1, "place " + std::to_string(i), 0.2 * (i % 40)));
    map.places.back().map_from_place.y = 0.2 * (i / 40);
  }
  const std::vector<Marker> labels = under("labels", markersOf(map, 50));
  EXPECT_GT(labels.size(), 5U);
  for (const Marker& a : labels) {
    for (const Marker& b : labels) {
      if (a.text == b.text) continue;
      const double apart = std::abs(a.pose.position.x - b.pose.position.x);
      const double above = std::abs(a.pose.position.y - b.pose.position.y);
      EXPECT_TRUE(apart > 2.0 || above >= 0.5) << a.text << " and " << b.text;
    }
  }
}

TEST(ToMarkers, OfPlacesAtOneSpotOneHasALabel) {
  core::MapSnapshot map = makeChain();
  map.places[1].map_from_place = map.places[0].map_from_place;
  EXPECT_EQ(labelsOf(markersOf(map)), (std::set<std::string>{"a", "c"}));
}

TEST(ToMarkers, APlaceIsADiscInItsRegion) {
  const MarkerArray array = markersOf(makeChain());
  const Marker regions = under("regions", array).front();
  const Marker places = under("places", array).front();
  EXPECT_EQ(places.points.size(), regions.points.size());
  EXPECT_LT(places.scale.x, 0.5 * regions.scale.x);
  EXPECT_GT(places.colors[0].a, regions.colors[0].a);
}

TEST(ToMarkers, TheirNumberIsBoundedHoweverManyPlacesThereAre) {
  EXPECT_LE(markersOf(makeRow(20000)).markers.size(), 104U);
}

TEST(ToMarkers, WhatIsNotInTheMapVanishes) {
  const MarkerArray array = markersOf({});
  ASSERT_EQ(array.markers.size(), 1U);
  EXPECT_EQ(array.markers.front().action, Marker::DELETEALL);
  EXPECT_EQ(markersOf(makeChain()).markers.front().action, Marker::DELETEALL);
}

}  // namespace
}  // namespace place_memory::node
