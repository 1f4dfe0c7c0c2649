#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <iterator>
#include <string>

#include "core/store/damage.h"
#include "core/store/old_store_fixture.h"

namespace place_memory::core {
namespace {

namespace fs = std::filesystem;

std::function<void(const std::string&)> ofFormat(int format, const std::string& statements) {
  return [=](const std::string& path) {
    fs::remove(path);
    makeOldStore(path, format);
    runSql(path, statements);
  };
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
    {"NewerVersion", sql("PRAGMA user_version = 6"), "newer version"},
    {"OlderVersionThanItsTables", sql("PRAGMA user_version = 2"), "damaged"},
    {"ScribbledSchema", scribbleAt(110), "damaged"},
    {"ScribbledTable", scribbleAt(2 * 4096), "damaged"},
    {"NoTables", sql("DROP TABLE link; DROP TABLE grid; DROP TABLE planes; DROP TABLE place"),
     "tables"},
    {"OneTableMore", sql("CREATE TABLE more(id INTEGER)"), "tables"},
    {"GridlessPlaceOfFormat2", ofFormat(2, "DELETE FROM grid WHERE place_id = 2"), "damaged"},
    {"LinkToNowhereOfFormat2", ofFormat(2, "INSERT INTO link VALUES(1, 77)"), "damaged"},
    {"EmptyLabelOfFormat2", ofFormat(2, "UPDATE place SET label = '' WHERE id = 2"), "damaged"},
    {"InfiniteLocationOfFormat1", ofFormat(1, "UPDATE place SET x = 9e999 WHERE id = 2"),
     "damaged"},
    {"ShortGridOfFormat1", ofFormat(1, "UPDATE grid SET cells = x'00' WHERE place_id = 2"),
     "damaged"},
    {"GridOfNullOfFormat2",
     ofFormat(2, "UPDATE grid SET cells = zeroblob(4096) WHERE place_id = 2"), "damaged"},
    {"OtherCellSizeOfFormat1", ofFormat(1, "UPDATE grid SET cell_size = 0.2 WHERE place_id = 2"),
     "cells of 0.2"},
    {"OtherCellSizeOfFormat2", ofFormat(2, "UPDATE grid SET cell_size = 0.2 WHERE place_id = 2"),
     "cells of 0.2"},
};

class DamagedStoreTest : public PlaceStoreTest, public testing::WithParamInterface<Damage> {};

TEST_P(DamagedStoreTest, IsRefusedWithTheReasonAndLeftAsItIs) {
  fill();
  GetParam().inflict(path_);
  const std::string before = readFile(path_);
  try {
    open();
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

}  // namespace
}  // namespace place_memory::core
