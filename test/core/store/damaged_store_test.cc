#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <iterator>
#include <ostream>
#include <string>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

// What happened to a good store, and what its refusal says.
struct Damage {
  const char* name;
  std::function<void(const std::string& path)> inflict;
  const char* message;
};

void PrintTo(const Damage& damage, std::ostream* out) { *out << damage.name; }

std::function<void(const std::string&)> sql(const std::string& statements) {
  return [statements](const std::string& path) { runSql(path, statements); };
}

std::function<void(const std::string&)> cutTo(double share) {
  return [share](const std::string& path) {
    const std::string bytes = readFile(path);
    writeFile(path,
              bytes.substr(0, static_cast<std::size_t>(share * static_cast<double>(bytes.size()))));
  };
}

std::function<void(const std::string&)> replaceBy(const std::string& bytes) {
  return [bytes](const std::string& path) { writeFile(path, bytes); };
}

std::function<void(const std::string&)> scribbleAt(std::size_t offset) {
  return [offset](const std::string& path) {
    std::string bytes = readFile(path);
    bytes.replace(offset, 600, 600, '\x5a');
    writeFile(path, bytes);
  };
}

const Damage kDamages[] = {
    {"Empty", cutTo(0.0), "cut short"},
    {"CutToHalfAHeader",
     [](const std::string& path) { writeFile(path, readFile(path).substr(0, 50)); }, "cut short"},
    {"CutToHalf", cutTo(0.5), "cut short"},
    {"CutByAByte", cutTo(0.99999), "cut short"},
    {"Text", replaceBy(std::string(5000, 'x')), "is not a place store"},
    {"ShortText", replaceBy("label,x,y\n"), "cut short"},
    {"OtherDatabase", sql("PRAGMA application_id = 7"), "is not a place store"},
    {"NewerVersion", sql("PRAGMA user_version = 3"), "newer version"},
    {"ScribbledSchema", scribbleAt(110), "damaged"},
    {"ScribbledTable", scribbleAt(65536), "damaged"},
    {"NoTables", sql("DROP TABLE link; DROP TABLE grid; DROP TABLE planes; DROP TABLE place"),
     "no such table"},
    {"PlaceWithoutGrid", sql("DELETE FROM grid WHERE place_id = 2"), "damaged"},
    {"GridWithoutPlace", sql("DELETE FROM place WHERE id = 2"), "damaged"},
    {"LinkToNowhere", sql("INSERT INTO link VALUES(1, 77)"), "damaged"},
    {"EmptyLabel", sql("UPDATE place SET label = '' WHERE id = 2"), "damaged"},
    {"ControlCharacterInLabel", sql("UPDATE place SET label = char(7) WHERE id = 2"), "damaged"},
    {"InfiniteLocation", sql("UPDATE place SET x = 9e999 WHERE id = 2"), "damaged"},
    {"ShortGrid", sql("UPDATE grid SET cells = x'00' WHERE place_id = 2"), "damaged"},
    {"GridOfNull", sql("UPDATE grid SET cells = zeroblob(4096) WHERE place_id = 2"), "damaged"},
    {"PlaceWithoutPlanes", sql("DELETE FROM planes WHERE place_id = 2"), "damaged"},
    {"ShortPlanes", sql("UPDATE planes SET cells = x'00' WHERE place_id = 2"), "damaged"},
    {"PlanesOfNull", sql("UPDATE planes SET cells = zeroblob(1024) WHERE place_id = 2"), "damaged"},
    {"ShortGridOfFormat1",
     sql(std::string(kToFormat1) + "UPDATE grid SET cells = x'00' WHERE place_id = 2"), "damaged"},
    {"OtherCellSize", sql("UPDATE grid SET cell_size = 0.2 WHERE place_id = 2"), "cells of 0.2"},
    {"OtherCellSizeOfFormat1",
     sql(std::string(kToFormat1) + "UPDATE grid SET cell_size = 0.2 WHERE place_id = 2"),
     "cells of 0.2"},
};

class DamagedStoreTest : public PlaceStoreTest, public testing::WithParamInterface<Damage> {};

TEST_P(DamagedStoreTest, IsRefusedWithTheReasonAndLeftAsItIs) {
  fill();
  GetParam().inflict(path_);
  const std::string before = readFile(path_);
  try {
    const PlaceStore store = open();
    store.map();
    store.forEachGrid([](PlaceId, const EvidenceGrid&) {});
    store.forEachPlanes([](PlaceId, const CellPlanes&) {});
    FAIL() << "the store was taken";
  } catch (const StoreError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(path_), std::string::npos) << message;
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
  }
  EXPECT_EQ(readFile(path_), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

INSTANTIATE_TEST_SUITE_P(All, DamagedStoreTest, testing::ValuesIn(kDamages),
                         [](const auto& damage) { return std::string(damage.param.name); });

// A store that is too large to be checked in full at every start.
class LargeStoreTest : public PlaceStoreTest {
 protected:
  PlaceStore openLarge() {
    StoreOpening opening;
    opening.full_check_size = 0;
    opening.progress = [this](const std::string& sentence) { said_ += sentence + '\n'; };
    return PlaceStore(path_, kDefaultCellSize, opening);
  }

  void readForMatching() {
    const PlaceStore store = openLarge();
    store.map();
    store.forEachPlanes([](PlaceId, const CellPlanes&) {});
  }

  std::string said_;
};

TEST_F(LargeStoreTest, IsReadWithoutBeingChecked) {
  fill();
  EXPECT_NO_THROW(readForMatching());
  EXPECT_EQ(said_, "");
}

TEST_F(LargeStoreTest, FindsDamageInWhatIsRead) {
  for (const Damage& damage : kDamages) {
    const std::string name = damage.name;
    const bool in_what_matching_needs = name != "GridWithoutPlace" && name != "PlaceWithoutGrid" &&
                                        name != "ShortGrid" && name != "GridOfNull" &&
                                        name != "OtherCellSize";
    if (!in_what_matching_needs) continue;
    fs::remove(path_);
    fill();
    damage.inflict(path_);
    EXPECT_THROW(readForMatching(), StoreError) << name;
  }
}

TEST_F(LargeStoreTest, FindsDamageOfAGridWhenItIsAskedFor) {
  fill();
  runSql(path_, "UPDATE grid SET cells = zeroblob(4096) WHERE place_id = 2");
  EXPECT_NO_THROW(readForMatching());
  const PlaceStore store = openLarge();
  EXPECT_THROW(store.grid(2), StoreError);
  EXPECT_EQ(store.grid(3), makeGrid(3));
}

TEST_F(LargeStoreTest, RefusesAStoreOfOtherCells) {
  fill();
  runSql(path_, "UPDATE grid SET cell_size = 0.2");
  EXPECT_THROW(openLarge(), StoreError);
}

TEST_F(LargeStoreTest, IsCheckedInFullWhereItsLastUserDidNotEndWell) {
  fill();
  runSql(path_, "DELETE FROM place WHERE id = 2");  // leaves its grid: SQLite's default
  EXPECT_NO_THROW(openLarge());
  writeFile(path_ + "-journal", "");
  EXPECT_THROW(openLarge(), StoreError);
  EXPECT_NE(said_.find("checking"), std::string::npos) << said_;
}

}  // namespace
}  // namespace place_memory::core
