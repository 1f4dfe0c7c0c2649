#ifndef PLACE_MEMORY_TEST_CORE_MEMORY_DRIVEN_PLACES_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_MEMORY_DRIVEN_PLACES_FIXTURE_H

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "core/mapping/mapper.h"
#include "core/store/store_fixture.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::core {

inline std::shared_ptr<const std::vector<SonarReading>> makeReadings() {
  std::vector<SonarReading> readings;
  for (int i = 0; i < 24; ++i) {
    SonarReading reading;
    reading.sensor_pose = {0.1, 0.0, i * kPi / 12.0};
    reading.spec = {0.4, 0.1, 4.0};
    reading.range = 1.0 + 0.1 * i;
    readings.push_back(reading);
  }
  return std::make_shared<const std::vector<SonarReading>>(readings);
}

inline ScanNode makeNode(PlaceId place, const Pose2d& pose) {
  ScanNode node;
  node.stamp = std::chrono::nanoseconds(1000 + place);
  node.session = 1;
  node.pose = pose;
  node.place = place;
  node.readings = makeReadings();
  return node;
}

class DrivenPlacesTest : public PlaceStoreTest {
 protected:
  PlaceMemoryOptions options() const {
    PlaceMemoryOptions options;
    options.store_path = path_;
    return options;
  }

  static std::string labelOf(const PlaceMemory& memory, PlaceId id) {
    const auto place = memory.place(id);
    return place ? place->label : "";
  }

  // Places 1 and 2 with a scan between them.
  void keepTwo() const {
    KeptMap map;
    map.nodes = {makeNode(1, {1.0, 2.0, 0.5}), makeNode(kNoPlace, {2.0, 2.0, 0.25}),
                 makeNode(2, {3.0, 2.0, -1.0})};
    map.nodes[1].before = 0;
    map.nodes[2].before = 1;
    map.nodes[1].motion = {1.0, 0.0, kPi / 2.0};
    map.nodes[2].motion = {1.0, 0.0, 0.0};
    PlaceMemory(options()).keep(map);
  }
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_MEMORY_DRIVEN_PLACES_FIXTURE_H
