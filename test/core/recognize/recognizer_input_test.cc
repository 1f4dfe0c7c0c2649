#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/random_room.h"
#include "core/recognize/recognizer.h"

namespace place_memory::core {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kWindow = 0.35;  ///< of headings [rad]

std::optional<std::vector<PlaceFrame>> atOrigin(const std::vector<PlaceId>& places) {
  return std::vector<PlaceFrame>(places.size());
}

PlaceIndex onePlace() {
  PlaceIndex index;
  index.put(1, RandomRoom(1).scanFrom({}).grid);
  return index;
}

TEST(RecognizerInput, StopsWhenItIsCancelled) {
  const Recognizer recognizer(RecognizerOptions{});
  const Scan scan = RandomRoom(1).scanFrom({});
  EXPECT_THROW(recognizer.recognize(scan, onePlace(), atOrigin, kWindow, [] { return true; }),
               std::runtime_error);
  EXPECT_NO_THROW(recognizer.recognize(scan, onePlace(), atOrigin, kWindow, [] { return false; }));
}

TEST(RecognizerInput, StopsBetweenTheBlocksOfALongIndex) {
  PlaceIndex places;
  const EvidenceGrid grid = RandomRoom(1).scanFrom({}).grid;
  for (PlaceId id = 1; id <= 3 * static_cast<PlaceId>(PlaceIndex::kBlockSize); ++id) {
    places.put(id, grid);
  }
  int polls = 0;
  const auto second_time = [&polls] { return ++polls == 2; };
  RecognizerOptions options;
  options.method = SearchMethod::kNearestNeighbour;
  EXPECT_THROW(Recognizer(options).recognize(RandomRoom(1).scanFrom({}), places, atOrigin, kWindow,
                                             second_time),
               std::runtime_error);
}

TEST(RecognizerInput, AHeadingWindowOutOfRangeIsRefused) {
  const Recognizer recognizer(RecognizerOptions{});
  const PlaceIndex places = onePlace();
  for (const double window : {-1e-3, -kPi, 1.01 * kPi, 360.0, kInfinity, -kInfinity, kNan}) {
    try {
      recognizer.recognize(Scan(), places, atOrigin, window);
      ADD_FAILURE() << window << " was taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("heading_window"), std::string::npos)
          << error.what();
    }
  }
  EXPECT_NO_THROW(recognizer.recognize(Scan(), places, atOrigin, 0.0));
  EXPECT_NO_THROW(recognizer.recognize(Scan(), places, atOrigin, kPi));
}

struct BadOption {
  const char* name;
  double RecognizerOptions::*option;
  double value;
};

TEST(RecognizerInput, ABadOptionIsNamed) {
  const BadOption cases[] = {
      {"position_window", &RecognizerOptions::position_window, 0.0},
      {"position_window", &RecognizerOptions::position_window, -1.0},
      {"position_window", &RecognizerOptions::position_window, kInfinity},
      {"position_window", &RecognizerOptions::position_window, kNan},
      {"confidence", &RecognizerOptions::confidence, 0.5},
      {"confidence", &RecognizerOptions::confidence, 1.0},
      {"confidence", &RecognizerOptions::confidence, -0.8},
      {"confidence", &RecognizerOptions::confidence, kNan},
  };
  for (const BadOption& bad : cases) {
    RecognizerOptions options = RecognizerOptions{};
    options.*bad.option = bad.value;
    try {
      const Recognizer recognizer(options);
      ADD_FAILURE() << bad.name << " = " << bad.value << " was taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(bad.name), std::string::npos) << error.what();
    }
  }
}

TEST(RecognizerInput, TooManyThreadsAreRefused) {
  RecognizerOptions options;
  options.threads = kMostThreads + 1;
  EXPECT_THROW(Recognizer{options}, std::invalid_argument);
  options.threads = 1;
  EXPECT_NO_THROW(Recognizer{options});
}

}  // namespace
}  // namespace place_memory::core
