#ifndef PLACE_MEMORY_TEST_CORE_MEMORY_PLACE_MEMORY_FIXTURE_H
#define PLACE_MEMORY_TEST_CORE_MEMORY_PLACE_MEMORY_FIXTURE_H

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/random_scan.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::core {

constexpr double kHeadingWindow = 0.2;

class PlaceMemoryTest : public testing::Test {
 protected:
  using Ends = std::pair<PlaceId, PlaceId>;

  Place learn(unsigned seed, const std::string& label) {
    return memory_.learn(makeRandomScan(seed), label).place;
  }
  PlaceMemory::Answer recognize(unsigned seed, const std::function<bool()>& cancelled = nullptr) {
    return memory_.recognize(makeRandomScan(seed), kHeadingWindow, cancelled);
  }
  std::vector<std::string> labels() const {
    std::vector<std::string> labels;
    for (const Place& place : memory_.map().places) labels.push_back(place.label);
    return labels;
  }

  std::vector<Ends> links() const {
    std::vector<Ends> ends;
    for (const PlaceLink& link : memory_.map().links) ends.emplace_back(link.first, link.second);
    return ends;
  }
  /// Label of the place that the next one is linked to; "": none.
  std::string previous() const {
    const auto place = memory_.place(memory_.whereabouts().previous);
    return place ? place->label : "";
  }

  // Random scans agree in most cells, and a place with its own scan in all 4096 of them.
  static PlaceMemoryOptions options() {
    PlaceMemoryOptions options;
    options.recognizer.calibration.right = {-20.0, 0.0, 0.0, 0.0, 30.0};
    options.recognizer.calibration.known = {-20.0};
    return options;
  }

  PlaceMemory memory_{options()};
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_TEST_CORE_MEMORY_PLACE_MEMORY_FIXTURE_H
