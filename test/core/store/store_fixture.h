#ifndef PLACE_MEMORY_TEST_CORE_STORE_STORE_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_STORE_STORE_FIXTURE_H

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/random_scan.h"
#include "core/store/place_store.h"
#include "core/temporary_folder.h"

namespace place_memory::core {

inline Place makePlace(const std::string& label) {
  Place place;
  place.label = label;
  place.map_from_place = {1.25, -7.5, 0.3};
  place.learned = std::chrono::nanoseconds(1234567890123456789);
  place.session = 2;
  place.place_from_robot = {0.01, -0.02, 1.5};
  return place;
}

inline EvidenceGrid makeGrid(unsigned seed) { return makeRandomScan(seed).grid; }

inline PlaceLink makeLink(PlaceId first, PlaceId second) {
  PlaceLink link;
  link.first = first;
  link.second = second;
  link.first_from_second = {-0.5, 2.25, 0.125};
  link.covariance = {0.5, 0.1, 0.0, 0.1, 0.25, 0.0, 0.0, 0.0, 0.03};
  link.forward = {3, 1, std::chrono::nanoseconds(77), 2.5, 0.75, 6.0, 1.5, 20.0, 4.0, false};
  link.backward = {1, 0, std::chrono::nanoseconds(99), 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, true};
  return link;
}

inline Traversal makeTraversal(PlaceId from, PlaceId to) {
  return {from, to, std::chrono::seconds(from), std::chrono::seconds(to), to % 2 == 0, "a person"};
}

inline void commit(PlaceStore& store, std::vector<MapEdit> edits) {
  MapChange change;
  change.version = 1;
  change.stamp = std::chrono::nanoseconds(5);
  change.edits = std::move(edits);
  store.commit(change);
}

inline PlaceAdded addition(PlaceId id, Place place, const EvidenceGrid& grid) {
  place.id = id;
  for (std::size_t i = 0; i < place.identity.size(); ++i) {
    place.identity[i] = static_cast<std::uint8_t>(i + static_cast<std::size_t>(id));
  }
  return {std::move(place), std::make_shared<EvidenceGrid>(grid), nullptr};
}

/// As a learn does it. Returns the id.
inline PlaceId add(PlaceStore& store, const Place& place, const EvidenceGrid& grid,
                   PlaceId came_from) {
  const PlaceId id = store.nextId();
  std::vector<MapEdit> edits{addition(id, place, grid)};
  if (came_from != kNoPlace)
    edits.emplace_back(LinkAdded{makeLink(came_from, id), makeTraversal(came_from, id)});
  commit(store, std::move(edits));
  return id;
}

inline void rename(PlaceStore& store, PlaceId id, const std::string& label) {
  commit(store, {PlaceRenamed{id, label}});
}

inline void update(PlaceStore& store, PlaceId id, const EvidenceGrid& grid) {
  commit(store, {GridAdapted{id, std::make_shared<EvidenceGrid>(grid)}});
}

inline void runSql(const std::string& path, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  sqlite3_close(database);
}

class PlaceStoreTest : public testing::Test {
 protected:
  PlaceStore open() const { return PlaceStore(path_, kDefaultCellSize); }

  // A store of three places in a chain.
  void fill() const {
    PlaceStore store = open();
    const PlaceId a = add(store, makePlace("a"), makeGrid(1), kNoPlace);
    const PlaceId b = add(store, makePlace("b"), makeGrid(2), a);
    add(store, makePlace("c"), makeGrid(3), b);
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("places.db");
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_STORE_FIXTURE_H
