#include <gtest/gtest.h>

#include <cstddef>
#include <iterator>
#include <random>

#include "core/mapping/known_places.h"

namespace place_memory::core {
namespace {

/// A map that is changed at random, and what is known of it.
class RandomMap {
 public:
  explicit RandomMap(unsigned seed) : engine_(seed) {}

  MapChange change() {
    MapChange change;
    for (int edit = 0; edit < 4; ++edit) change.edits.push_back(this->edit());
    return change;
  }
  const KnownPlaces& places() const { return places_; }

 private:
  Pose2d pose() {
    std::uniform_real_distribution<double> metres(-15.0, 15.0);
    std::uniform_real_distribution<double> angle(-kPi, kPi);
    return {metres(engine_), metres(engine_), angle(engine_)};
  }

  MapEdit edit() {
    const int kind = std::uniform_int_distribution<int>(0, 99)(engine_);
    if (kind < 40 || places_.empty()) {
      const Place place = makePlace(++last_, pose(), kind % 5 == 0 ? 2 : 1);
      places_[place.id] = {place, randomGrid(engine_)};
      return PlaceAdded{place, places_[place.id].grid, nullptr};
    }
    if (kind == 99) {
      places_.clear();
      return MapCleared{};
    }
    auto chosen = places_.begin();
    std::advance(chosen,
                 std::uniform_int_distribution<std::size_t>(0, places_.size() - 1)(engine_));
    auto& [id, known] = *chosen;
    if (kind < 60) {
      known.place.map_from_place = pose();
      known.place.session = kind % 5 == 0 ? 2 : 1;
      return PlaceMoved{id, known.place.map_from_place, known.place.session};
    }
    if (kind < 75) {
      known.grid = randomGrid(engine_);
      return GridAdapted{id, known.grid};
    }
    if (kind < 80) return PlaceRenamed{id, "other"};
    const PlaceId gone = id;
    places_.erase(chosen);
    return PlaceRemoved{gone};
  }

  std::mt19937 engine_;
  KnownPlaces places_;
  PlaceId last_ = 0;
};

TEST(FusedMapChanges, FollowingChangesGivesTheMapThatIsMadeAnew) {
  FusedMapOptions options;
  options.resolution = 0.1;
  for (const std::size_t most_cells : {16'000'000U, 120'000U}) {
    options.most_cells = most_cells;
    RandomMap random(7);
    FusedMap map(options, GridGeometry{});
    std::size_t left_out = 0;
    for (int round = 0; round < 60; ++round) {
      map.apply(random.change());
      if (round % 3 == 0) continue;  // several changes may come before an update
      map.update();
      const FusedMap anew = fromScratch(options, random.places());
      expectSame(map.cells(), anew.cells());
      EXPECT_EQ(map.leftOut(), anew.leftOut());
      EXPECT_LE(map.cells().evidence.size(), most_cells);
      left_out += map.leftOut();
    }
    EXPECT_EQ(left_out > 0, most_cells == 120'000U);
  }
}

}  // namespace
}  // namespace place_memory::core
