#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <sstream>
#include <utility>

#include "node/scan/scan_collector.h"

// What has come of a scan, in words that a person can act on.
namespace place_memory::node {
namespace {

/// Of a scan with fewer echoes than one in so many readings it is said that they are few.
constexpr std::size_t kFewEchoes = 8;

/// What the readings heard.
std::string heard(const core::Scan& scan) {
  std::ostringstream text;
  if (scan.echoes == 0) {
    text
        << ", none with an echo in the grid, which reaches " << scan.grid.geometry().halfWidth()
        << " m: such a scan tells nothing of where it was taken; is the space open so far, are the "
           "sensors under power, are their ranges metres?";
    return text.str();
  }
  text << ", " << scan.echoes << " with an echo in the grid";
  if (scan.echoes * kFewEchoes < scan.readings.size()) {
    text
        << ": few to know the place by; the room is larger than the sensors reach, or some of them "
           "hear nothing: scan nearer to walls and furniture";
  }
  return text.str();
}

}  // namespace

ScanOutcome ScanCollector::outcome(std::chrono::nanoseconds end) const {
  if (failure_) return *failure_;
  if (readings() < static_cast<std::size_t>(parameters_.scan.min_readings)) return tooFew();
  auto scan = snapshot(end);
  if (!scan) {
    return {ScanStatus::kNoHeading,
            "no heading came on " + parameters_.heading_topic +
                ": a scan needs the compass, or whatever stands in for it, since its grid lies "
                "along compass north; a robot without a compass has heading_topic: \"\"" +
                (scan_problems_.empty() ? "" : "; " + scan_problems_.inWords()),
            nullptr,
            {}};
  }
  scan->id = core::newScanId();
  std::ostringstream text;
  text << readings() << " readings at " << sweep_->coverage().headings() << " headings"
       << heard(*scan) << leftOut();
  std::string problems = scan_problems_.inWords();
  if (!scan->doubt.empty()) {
    text << "; not to be relied on: " << scan->doubt;
    problems += (problems.empty() ? "" : "; ") + scan->doubt;
  }
  return {ScanStatus::kSucceeded, text.str(), std::make_shared<const core::Scan>(std::move(*scan)),
          problems};
}

std::optional<core::Scan> ScanCollector::snapshot(std::chrono::nanoseconds end) const {
  if (readings() == 0) return std::nullopt;
  const std::optional<double> offset = compassOffset();
  if (!offset) return std::nullopt;
  core::Scan scan = sweep_->scan(*offset, baseAtEnd(end), model_, parameters_.grid);
  scan.doubt = doubt_.ofScan();
  scan.begin = start_;
  scan.end = end;
  return scan;
}

std::optional<double> ScanCollector::compassOffset() const {
  // Without a compass the scan lies by odometry's yaw.
  if (!locator_.usesOdometry() || parameters_.heading_topic.empty()) return 0.0;
  if (const auto mean = compass_offset_.mean()) return mean;
  // A slow compass may not have spoken during a short scan.
  const core::LocatedReading& first = sweep_->readings().front();
  const std::optional<double> heading = history_.at(first.stamp);
  if (!heading) return std::nullopt;
  return *heading - first.fixed_from_base.yaw;
}

core::Pose2d ScanCollector::baseAtEnd(std::chrono::nanoseconds end) const {
  std::string problem;
  if (const auto base = locator_.baseAt(end, problem)) return *base;
  // Odometry is a little older than the clock, and the robot may have turned since the last
  // reading.
  const core::LocatedReading& last = sweep_->readings().back();
  if (locator_.usesOdometry()) {
    const auto newest = locator_.newestBase();
    if (newest && newest->stamp >= last.stamp) return newest->pose;
  }
  return last.fixed_from_base;
}

ScanOutcome ScanCollector::tooFew() const {
  const Reject reason = mostFrequent(rejected_);
  const bool any_rejected = rejected_.at(static_cast<std::size_t>(reason)) > 0;
  ScanStatus status = ScanStatus::kTooFewReadings;
  if (any_rejected && reason == Reject::kNoHeading) status = ScanStatus::kNoHeading;
  if (any_rejected && reason == Reject::kNoOdometry) status = ScanStatus::kNoOdometry;

  std::ostringstream text;
  text << readings() << " readings can be used, " << parameters_.scan.min_readings
       << " are needed (scan/min_readings)" << leftOut();
  if (readings() == 0 && !any_rejected) {
    text << "; is anything published on " << boost::algorithm::join(parameters_.sonar_topics, ", ")
         << "?";
  }
  if (!scan_problems_.empty()) {
    text << "; " << scan_problems_.inWords();
  } else if (any_rejected) {
    text << ": " << adviceOn(reason);
  }
  return {status, text.str(), nullptr, {}};
}

std::string ScanCollector::leftOut() const {
  const std::string words = inWords(rejected_);
  return words.empty() ? words : "; left out: " + words;
}

}  // namespace place_memory::node
