#ifndef PLACE_MEMORY_TEST_CORE_STORE_STORE_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_STORE_STORE_FIXTURE_H

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <string>

#include "core/random_scan.h"
#include "core/store/place_store.h"
#include "core/temporary_folder.h"

namespace place_memory::core {

inline Place makePlace(const std::string& label) {
  Place place;
  place.label = label;
  place.map_from_place = {1.25, -7.5, 0.3};
  place.learned = std::chrono::nanoseconds(1234567890123456789);
  return place;
}

inline EvidenceGrid makeGrid(unsigned seed) { return makeRandomScan(seed).grid; }

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
    const PlaceId a = store.add(makePlace("a"), makeGrid(1), kNoPlace);
    const PlaceId b = store.add(makePlace("b"), makeGrid(2), a);
    store.add(makePlace("c"), makeGrid(3), b);
  }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.file("places.db");
};

/// What format 1 did not have.
constexpr char kToFormat1[] = "DROP TABLE planes; PRAGMA user_version = 1;";

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_STORE_FIXTURE_H
