#ifndef PLACE_MEMORY_NODE_SCAN_SCAN_STATUS_H
#define PLACE_MEMORY_NODE_SCAN_SCAN_STATUS_H

#include <place_memory/ScanPlaceResult.h>

#include <cstdint>
#include <memory>
#include <string>

#include "place_memory/core/scan.h"

namespace place_memory::node {

/// How a scan ended: the constants of ScanPlace.action.
enum class ScanStatus : std::uint8_t {
  kSucceeded = ScanPlaceResult::SUCCEEDED,
  kCanceled = ScanPlaceResult::CANCELED,
  kTimeout = ScanPlaceResult::TIMEOUT,
  kTooFewReadings = ScanPlaceResult::TOO_FEW_READINGS,
  kNoHeading = ScanPlaceResult::NO_HEADING,
  kOdometryJump = ScanPlaceResult::ODOMETRY_JUMP,
  kTimeJump = ScanPlaceResult::TIME_JUMP,
  kInvalidGoal = ScanPlaceResult::INVALID_GOAL,
  kNoTime = ScanPlaceResult::NO_TIME,
  kShutdown = ScanPlaceResult::SHUTDOWN,
  kNoOdometry = ScanPlaceResult::NO_ODOMETRY,
  kFailed = ScanPlaceResult::FAILED,
  kBaseDisobeys = ScanPlaceResult::BASE_DISOBEYS,
  kBusy = ScanPlaceResult::BUSY,
};

/// One word, e.g. "too_few_readings"; of success "ok".
const char* toString(ScanStatus status);

struct ScanOutcome {
  ScanStatus status = ScanStatus::kSucceeded;
  std::string message;                     ///< a sentence a person can act on
  std::shared_ptr<const core::Scan> scan;  ///< where it succeeded, otherwise null
  /// Where it succeeded: what was wrong with an input all the same, in a sentence; empty: nothing.
  std::string problem;
};

}  // namespace place_memory::node

#endif  // PLACE_MEMORY_NODE_SCAN_SCAN_STATUS_H
