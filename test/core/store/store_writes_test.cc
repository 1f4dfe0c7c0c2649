#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/store/store_fixture.h"

namespace place_memory::core {
namespace {

/// What this process has handed to the system to be written, journals too [bytes].
std::uint64_t bytesWritten() {
  std::ifstream file("/proc/self/io");
  std::string name;
  std::uint64_t value = 0;
  while (file >> name >> value) {
    if (name == "wchar:") return value;
  }
  return std::numeric_limits<std::uint64_t>::max();
}

std::shared_ptr<const std::vector<SonarReading>> makeScanReadings() {
  std::vector<SonarReading> readings(480);  // of 24 sonars that turn by 15 degrees
  for (std::size_t i = 0; i < readings.size(); ++i) {
    readings[i].sensor_pose = {0.1, 0.2, 0.013 * static_cast<double>(i)};
    readings[i].spec = {0.4, 0.2, 4.0};
    readings[i].range = 1.0 + 0.001 * static_cast<double>(i);
  }
  return std::make_shared<std::vector<SonarReading>>(std::move(readings));
}

TEST_F(PlaceStoreTest, ALearnWritesAtMost100KiB) {
  const char* wanted = std::getenv("PLACE_MEMORY_PLACES");
  const PlaceId places = wanted == nullptr ? 10000 : std::atoll(wanted);
  const auto readings = makeScanReadings();
  const std::vector<EvidenceGrid> grids{makeGrid(1), makeGrid(2), makeGrid(3)};
  const auto edits_of = [&](PlaceId id) {
    PlaceAdded added = addition(id, makePlace("place " + std::to_string(id)),
                                grids[static_cast<std::size_t>(id) % 3]);
    added.readings = readings;
    std::vector<MapEdit> edits{added};
    if (id > 1) edits.emplace_back(LinkAdded{makeLink(id - 1, id)});
    return edits;
  };
  {
    PlaceStore store = open();
    for (PlaceId id = 1; id <= places;) {
      std::vector<MapEdit> edits;
      for (int i = 0; i < 1000 && id <= places; ++i, ++id) {
        for (MapEdit& edit : edits_of(id)) edits.push_back(std::move(edit));
      }
      commit(store, std::move(edits));
    }
  }
  PlaceStore store = open();
  ASSERT_TRUE(store.setAside().empty());
  if (bytesWritten() == std::numeric_limits<std::uint64_t>::max()) {
    GTEST_SKIP() << "the system does not say what was written";
  }
  std::uint64_t most = 0;
  std::uint64_t all = 0;
  constexpr int kLearns = 70;  // twice a row of bit planes is begun
  for (int i = 0; i < kLearns; ++i) {
    const std::uint64_t before = bytesWritten();
    commit(store, edits_of(store.nextId()));
    most = std::max(most, bytesWritten() - before);
    all += bytesWritten() - before;
  }
  RecordProperty("most", static_cast<int>(most));
  RecordProperty("mean", static_cast<int>(all / kLearns));
  std::printf("a learn wrote %d bytes in the mean, %d at most\n", static_cast<int>(all / kLearns),
              static_cast<int>(most));
  EXPECT_LE(most, std::uint64_t{100} << 10U);
}

}  // namespace
}  // namespace place_memory::core
