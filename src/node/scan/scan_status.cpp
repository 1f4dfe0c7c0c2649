#include "node/scan/scan_status.h"

namespace place_memory::node {

const char* toString(ScanStatus status) {
  switch (status) {
    case ScanStatus::kSucceeded:
      return "ok";
    case ScanStatus::kCanceled:
      return "canceled";
    case ScanStatus::kTimeout:
      return "timeout";
    case ScanStatus::kTooFewReadings:
      return "too_few_readings";
    case ScanStatus::kNoHeading:
      return "no_heading";
    case ScanStatus::kOdometryJump:
      return "odometry_jump";
    case ScanStatus::kTimeJump:
      return "time_jump";
    case ScanStatus::kInvalidGoal:
      return "invalid_goal";
    case ScanStatus::kNoTime:
      return "no_time";
    case ScanStatus::kShutdown:
      return "shutdown";
    case ScanStatus::kNoOdometry:
      return "no_odometry";
    case ScanStatus::kFailed:
      return "failed";
    case ScanStatus::kBaseDisobeys:
      return "base_disobeys";
    case ScanStatus::kBusy:
      return "busy";
  }
  return "unknown";
}

}  // namespace place_memory::node
