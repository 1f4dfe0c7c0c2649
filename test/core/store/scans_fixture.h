#ifndef PLACE_MEMORY_TEST_CORE_STORE_SCANS_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_STORE_SCANS_FIXTURE_H

#include <limits>
#include <memory>
#include <vector>

#include "core/map/kept_map.h"

namespace place_memory::core {

inline std::shared_ptr<const std::vector<SonarReading>> makeReadings(double range) {
  SonarReading echo;
  echo.sensor_pose = {0.25, -0.125, 1.5};
  echo.spec = {0.5, 0.25, 4.0};
  echo.range = range;
  SonarReading none = echo;
  none.range = std::numeric_limits<double>::infinity();
  return std::make_shared<const std::vector<SonarReading>>(std::vector<SonarReading>{echo, none});
}

inline ScanNode makeNode(int number, PlaceId place) {
  ScanNode node;
  node.stamp = std::chrono::nanoseconds(1000 + number);
  node.odom_from_base = {0.5 * number, 1.0, -0.25};
  node.first_way = number - 1.5;
  node.last_way = number + 1.5;
  node.session = 1;
  node.pose = {number + 0.125, -2.0, 0.5};
  if (number > 0) node.before = static_cast<NodeIndex>(number - 1);
  node.motion = {0.5, 0.0, 0.0625};
  node.motion_way = 0.5;
  node.motion_turn = 6.5;
  if (number != 1) node.compass = 0.75;
  node.place = place;
  if (number != 3) node.readings = makeReadings(1.0 + 0.5 * number);
  return node;
}

/// Four scans, of which the first is place 1.
inline KeptMap makeScans() {
  KeptMap map;
  for (int number = 0; number < 4; ++number) {
    map.nodes.push_back(makeNode(number, number == 0 ? 1 : kNoPlace));
  }
  for (const NodeIndex node : {NodeIndex{2}, NodeIndex{3}}) {
    Tie tie;
    tie.place = 0;
    tie.node = node;
    tie.relative = {1.0, 0.5, -0.125};
    tie.information << 400.0, 1.0, 2.0, 1.0, 300.0, 3.0, 2.0, 3.0, 900.0;
    tie.closure = static_cast<int>(node);
    map.ties.push_back(tie);
  }
  map.errors = {0.03, -0.02};
  return map;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_STORE_SCANS_FIXTURE_H
