// Prints what recognition answers to the last digit, for comparison between instruction sets.
// usage: print_recognitions [--sets]
//   --sets  prints the names of the instruction sets of this processor instead, one a line
#include <cstdio>
#include <exception>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "core/kernels/cpu.h"
#include "core/random_room.h"
#include "core/recognize/recognizer.h"
#include "place_memory/config/match_preset.h"

namespace place_memory::core {
namespace {

constexpr std::size_t kRooms = 30;
constexpr std::size_t kPlaces = 300;  // so many that screening leaves some out

/// Rooms, and behind them places with the lower rows of one room and the upper ones of another.
PlaceIndex places(std::size_t count) {
  std::vector<EvidenceGrid> rooms;
  for (unsigned seed = 1; seed <= kRooms; ++seed)
    rooms.push_back(RandomRoom(seed).scanFrom({}).grid);
  std::mt19937 engine(7);
  PlaceIndex index;
  for (std::size_t i = 0; i < count; ++i) {
    EvidenceGrid grid = rooms[i % kRooms];
    const EvidenceGrid& other = rooms[engine() % kRooms];
    for (std::size_t cell = engine() % kGridCells; i >= kRooms && cell < kGridCells; ++cell) {
      grid.cells()[cell] = other.cells()[cell];
    }
    index.put(static_cast<PlaceId>(i + 1), grid);
  }
  return index;
}

std::optional<std::vector<PlaceFrame>> frames(const std::vector<PlaceId>& ids) {
  std::vector<PlaceFrame> found;
  for (const PlaceId id : ids) found.push_back({{0.7 * static_cast<double>(id), 0.0, 0.0}});
  return found;
}

void print(const Recognition& recognition) {
  std::printf("%s\n", nameOf(recognition.verdict));
  for (const PlaceMatch& match : recognition.matches) {
    const Pose2d& pose = match.place_from_scan;
    std::printf("%lld %a %a %a %a %a\n", static_cast<long long>(match.id), match.score,
                match.probability, pose.x, pose.y, pose.yaw);
  }
  for (const double entry : recognition.covariance) std::printf("%a ", entry);
  const Pose2d& robot = recognition.map_from_robot;
  std::printf("%a %a %a\n", robot.x, robot.y, robot.yaw);
}

void recognizeAll() {
  const PlaceIndex many = places(kPlaces), few = places(kRooms);
  for (const char* name : {"evidence", "paper"}) {
    const config::MatchPreset preset = config::loadPreset(name);
    RecognizerOptions options;
    options.metric = preset.metric;
    options.rescoring = preset.rescoring;
    options.calibration = preset.calibration;
    for (const SearchMethod method : {SearchMethod::kRestarts, SearchMethod::kHillClimbing}) {
      options.method = method;
      const Recognizer recognizer(options);
      for (unsigned seed = 1; seed <= 3; ++seed) {
        const Scan scan = RandomRoom(seed).scanFrom({0.3, -0.1 * seed, 0.2});
        print(recognizer.recognize(scan, many, frames, 0.4).value());
        print(recognizer.recognize(scan, few, frames, kPi).value());
      }
    }
  }
}

}  // namespace
}  // namespace place_memory::core

int main(int argc, char** argv) {
  try {
    if (argc > 1 && std::string(argv[1]) == "--sets") {
      for (const auto set : place_memory::core::instructionSets()) {
        std::printf("%s\n", place_memory::core::nameOf(set));
      }
      return 0;
    }
    place_memory::core::recognizeAll();
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "print_recognitions: %s\n", error.what());
    return 1;
  }
}
