#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <random>
#include <set>
#include <stdexcept>

#include "core/map/place_map_fixture.h"

namespace place_memory::core {
namespace {

/// A set of places and a set of links that are searched through.
class PlainMap {
 public:
  /// Whether the edit fits; then it is made.
  bool add(PlaceId id) { return ids_.insert(id).second; }
  bool remove(PlaceId id) {
    for (auto link = links_.begin(); link != links_.end();) {
      link = link->first == id || link->second == id ? links_.erase(link) : std::next(link);
    }
    return ids_.erase(id) > 0;
  }
  bool link(PlaceId one, PlaceId other) {
    if (one >= other || ids_.count(one) == 0 || ids_.count(other) == 0) return false;
    links_.insert({one, other});
    return true;
  }
  bool unlink(PlaceId one, PlaceId other) { return links_.erase(std::minmax(one, other)) > 0; }
  bool learn(PlaceId one, PlaceId other) const { return links_.count(std::minmax(one, other)) > 0; }
  void clear() {
    ids_.clear();
    links_.clear();
  }

  Ids ids() const { return Ids(ids_.begin(), ids_.end()); }
  Ends ends() const { return Ends(links_.begin(), links_.end()); }

 private:
  std::set<PlaceId> ids_;
  std::set<std::pair<PlaceId, PlaceId>> links_;
};

class RandomEdits {
 public:
  /// A random edit, made in `plain` where it fits; whether it does.
  std::pair<MapEdit, bool> next(PlainMap& plain) {
    const PlaceId one = id();
    const PlaceId other = id();
    switch (random_() % 9) {
      case 0:
      case 1:
      case 2:
        return {added(one, "place " + std::to_string(one)), plain.add(one)};
      case 3:
        return {PlaceRemoved{one}, plain.remove(one)};
      case 4:
        return {LinkRemoved{one, other}, plain.unlink(one, other)};
      case 5:
        return {LinkLearned{one, other, {1, 1, nanoseconds(1)}}, plain.learn(one, other)};
      case 6:
        if (random_() % 100 == 0) {
          plain.clear();
          return {MapCleared{}, true};
        }
        [[fallthrough]];
      default:
        return {LinkAdded{makeLink(one, other)}, plain.link(one, other)};
    }
  }

 private:
  PlaceId id() { return static_cast<PlaceId>(random_() % 20) + 1; }

  std::mt19937 random_{7};
};

TEST(PlaceMap, AgreesWithPlainSetsAfterRandomChanges) {
  RandomEdits random;
  PlaceMap map;
  PlainMap plain;
  int made = 0;
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    PlainMap after = plain;
    std::vector<MapEdit> edits;
    bool fits = true;
    for (int length = 1 + i % 3; length > 0; --length) {
      const auto [one, one_fits] = random.next(after);
      edits.push_back(one);
      fits = fits && one_fits;
    }
    if (fits) {
      edit(map, edits);
      plain = after;
      ++made;
    } else {
      EXPECT_THROW(edit(map, edits), std::invalid_argument);
      ++refused;
    }
    ASSERT_EQ(idsOf(map), plain.ids());
    ASSERT_EQ(endsOf(map), plain.ends());
    ASSERT_EQ(map.version(), static_cast<std::uint64_t>(made));
    expectSame(map, PlaceMap(map.places(), map.links(), map.version(), map.stamp()));
  }
  EXPECT_GT(made, 300);
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace place_memory::core
