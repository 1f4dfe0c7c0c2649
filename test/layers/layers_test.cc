// The parts of the package depend in one direction. This reads the sources: a header that happens
// to be installed beside ROS's would let a compiler accept what a machine without ROS does not.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "layers/include_reader.h"
#include "layers/table.h"

namespace place_memory::layers {
namespace {

TEST(Layers, TheTableKnowsRosInThePartsWithoutIt) {
  const auto headers = includesIn(
      "#include <ros/ros.h>\n# include \"nav_msgs/OccupancyGrid.h\"\n"
      "#include \"place_memory/PlaceGraph.h\"\n#include \"tf2/utils.h\"\n");
  ASSERT_EQ(headers.size(), 4U);
  for (const char* file : {"src/support/csv.h", "src/core/grid/fusion.h", "src/config/reader.cpp",
                           "src/sim/world/world.cpp", "include/place_memory/core/scan.h"}) {
    EXPECT_EQ(violations(file, headers).size(), 4U) << file;
  }
  EXPECT_EQ(violations("src/node/scan/goal.cpp", headers).size(), 0U);
}

TEST(Layers, TheTableKnowsEveryWrongDirection) {
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"src/support/csv.h", "core/grid/cell_planes.h"},
      {"src/core/grid/grid_fusion.h", "place_memory/core/sonar_model.h"},
      {"src/core/kernels/pair_kernel.h", "core/match/lattice.h"},
      {"src/core/index/place_index.h", "place_memory/core/place.h"},
      {"src/core/match/climber.h", "place_memory/core/recognizer_options.h"},
      {"src/core/match/climber.h", "core/sensing/sweep_turner.h"},
      {"src/core/recognize/verdict.cpp", "core/map/place_label.h"},
      {"src/core/recognize/verdict.cpp", "core/memory/session.h"},
      {"src/core/map/routes.cpp", "core/store/sqlite.h"},
      {"src/core/store/place_store.h", "core/index/place_index.h"},
      {"src/core/store/place_store.h", "config/parameters.h"},
      {"include/place_memory/core/recognition.h", "place_memory/core/place_memory.h"},
      {"src/core/match/climber.h", "node/base/conversions.h"},
      {"src/config/parameters.h", "node/base/conversions.h"},
      {"src/sim/world/world.h", "sim/robot/simulation.h"},
      {"src/sim/scene/scene.h", "config/parameters.h"},
      {"src/node/input/planar.h", "node/scan/scan_server.h"},
      {"src/node/scan/scan_server.h", "node/place_memory_node.h"},
      {"src/node/conversions.h", "tools/bag_scanner.h"},
      {"src/tools/bag_scanner.h", "node/answer/place_services.h"},
      {"src/tools/bag_scanner.h", "trials/trial_set.h"},
      {"src/rviz/panel.cpp", "place_memory/core/place.h"},
      {"lab/trials/trial_set.h", "training/candidates.h"},
      {"lab/training/candidates.h", "ros/ros.h"},
      {"lab/training/candidates.h", "node/base/conversions.h"},
      {"src/core/match/climber.h", "benchmark/benchmark.h"},
  };
  for (const auto& [file, header] : wrong) {
    EXPECT_EQ(violations(file, {header}).size(), 1U) << file << " includes " << header;
  }
}

TEST(Layers, WhatTheTableAllowsIsNoViolation) {
  const std::vector<std::pair<std::string, std::string>> right{
      {"src/core/grid/grid_fusion.h", "place_memory/core/pose2d.h"},
      {"src/core/index/place_index.h", "place_memory/core/place_id.h"},
      {"src/core/match/climber.h", "support/worker_pool.h"},
      {"src/core/match/climber.h", "place_memory/core/grid_geometry.h"},  // by way of kernels
      {"src/core/kernels/block_kernel.cpp", "immintrin.h"},
      {"src/core/memory/place_memory.cpp", "core/recognize/recognizer.h"},
      {"src/node/scan/scan_server.h", "node/input/range_check.h"},
      {"src/tools/bag_scanner.h", "rosbag/bag.h"},
      {"lab/benchmark/parts.cpp", "benchmark/benchmark.h"},
      {"lab/training/candidates.h", "trials/trial_set.h"},
  };
  for (const auto& [file, header] : right) {
    EXPECT_EQ(violations(file, {header}).size(), 0U) << file << " includes " << header;
  }
}

TEST(Layers, AFileOutsideTheTableIsAViolation) {
  EXPECT_EQ(violations("src/core/loose.h", {}).size(), 1U);
  EXPECT_EQ(violations("src/core/newgroup/thing.h", {}).size(), 1U);
  EXPECT_EQ(violations("src/misc/thing.h", {}).size(), 1U);
  EXPECT_EQ(violations("include/place_memory/core/unlisted.h", {}).size(), 1U);
}

TEST(Layers, NoIncludeRunsAgainstTheTable) {
  std::size_t files = 0;
  for (const char* folder : {"include", "src", "lab"}) {
    for (const std::string& file : sourcesBelow(folder)) {
      ++files;
      for (const std::string& problem : violations(file, includesIn(contents(kRoot / file)))) {
        ADD_FAILURE() << problem;
      }
    }
  }
  EXPECT_GT(files, 100U);
}

TEST(Layers, WhatHasNoRosLinksNothingOfCatkin) {
  for (const char* layer : {"support", "core", "config", "sim"}) {
    const std::string text = contents(kRoot / "src" / layer / "CMakeLists.txt");
    ASSERT_NE(text.find("place_memory_" + std::string(layer)), std::string::npos) << layer;
    EXPECT_EQ(text.find("catkin_LIBRARIES"), std::string::npos) << layer;
    EXPECT_EQ(text.find("place_memory_ros"), std::string::npos) << layer;
  }
}

}  // namespace
}  // namespace place_memory::layers
