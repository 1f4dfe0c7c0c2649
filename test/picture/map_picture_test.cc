#include "picture/map_picture.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>

namespace place_memory::picture {
namespace {

core::Place makePlace(core::PlaceId id, double x, double y) {
  core::Place place;
  place.id = id;
  place.label = "p" + std::to_string(id);
  place.map_from_place = {x, y, 0.0};
  return place;
}

template <class Kind>
std::vector<Kind> shapesOf(const Picture& picture) {
  std::vector<Kind> found;
  for (const Shape& shape : picture.shapes) {
    if (const auto* one = std::get_if<Kind>(&shape)) found.push_back(*one);
  }
  return found;
}

DrawnMap someMap() {
  DrawnMap map;
  map.places = {makePlace(1, 0.0, 0.0), makePlace(2, 6.0, 0.0), makePlace(3, 6.0, 8.0)};
  core::PlaceLink link;
  link.first = 1;
  link.second = 2;
  map.links.push_back(link);
  link.second = 77;  // a place that is not drawn
  map.links.push_back(link);
  map.ways = {{{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {6.0, 0.0, 0.0}, {6.0, 9.0, 0.0}}};
  map.cells.resolution = 0.5;
  map.cells.left = -2.0;
  map.cells.bottom = -1.0;
  map.cells.columns = 3;
  map.cells.rows = 2;
  map.cells.evidence = {-100, 0, 0, 100, 0, 0};
  return map;
}

TEST(MapPicture, ShowsPlacesLinksWayAndBuilding) {
  const Picture picture = mapPicture(someMap());
  EXPECT_EQ(shapesOf<Disc>(picture).size(), 5U);  // with both ends of the way
  EXPECT_EQ(shapesOf<Line>(picture).size(), 3U);  // way, link and scale
  const auto rasters = shapesOf<Raster>(picture);
  ASSERT_EQ(rasters.size(), 1U);
  EXPECT_EQ(rasters[0].colors[0], (Color{255, 255, 255}));
  EXPECT_EQ(rasters[0].colors[3], (Color{0, 0, 0}));
  EXPECT_EQ(rasters[0].colors[1], picture.background);
  std::vector<std::string> texts;
  for (const Text& text : shapesOf<Text>(picture)) texts.push_back(text.text);
  EXPECT_EQ(texts, (std::vector<std::string>{"p1", "p2", "p3", "2 m"}));
}

TEST(MapPicture, HoldsAllThatIsDrawn) {
  const Picture picture = mapPicture(someMap());
  EXPECT_LT(picture.lower_left.x, -2.0);
  EXPECT_LT(picture.lower_left.y, -1.0);
  EXPECT_GT(picture.upper_right.x, 6.0);
  EXPECT_GT(picture.upper_right.y, 9.0);
  EXPECT_GT(picture.lower_left.x, -4.0);  // but not what nothing is known of
}

TEST(MapPicture, AMapWithoutAnythingIsAPictureToo) {
  const std::string png = toPng(mapPicture({}), 50);
  EXPECT_EQ(png.substr(1, 3), "PNG");
}

TEST(MapPicture, EachSessionIsDrawnWithItsGridsWhereTheyAreKnown) {
  core::MapSnapshot map;
  map.places = {makePlace(1, 0.0, 0.0), makePlace(2, 6.0, 0.0)};
  map.places[1].session = 2;
  const auto without = mapPictures(map, nullptr, core::kDefaultCellSize);
  EXPECT_EQ(without.find("<image"), std::string::npos);
  EXPECT_NE(without.find("Session 2: 1 place<"), std::string::npos);
  const auto with = mapPictures(
      map,
      [](core::PlaceId) {
        auto grid = std::make_shared<core::EvidenceGrid>();
        grid->add(30, 30, 90);
        return grid;
      },
      core::kDefaultCellSize);
  EXPECT_NE(with.find("<image"), with.rfind("<image"));
}

}  // namespace
}  // namespace place_memory::picture
