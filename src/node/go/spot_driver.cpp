#include "node/go/spot_driver.h"

namespace place_memory::node {

std::string inWords(const DriveReport& report) {
  switch (report.state) {
    case DriveReport::State::kWaiting:
      return "waits for what stands in the way to go";
    case DriveReport::State::kBackingOff:
      return "backs off";
    default:
      return "goes";
  }
}

}  // namespace place_memory::node
