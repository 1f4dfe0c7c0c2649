#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <sstream>
#include <utility>

#include "node/scan/scan_collector.h"

// What has come of a scan, in words that a person can act on.
namespace place_memory::node {

ScanOutcome ScanCollector::outcome(const ros::Time& end) const {
  if (failure_) return *failure_;
  if (placed_.size() < static_cast<std::size_t>(parameters_.scan.min_readings)) return tooFew();
  auto scan = snapshot(end);
  if (!scan) {
    return {ScanStatus::kNoHeading,
            "no heading came on " + parameters_.heading_topic +
                ": a scan needs the compass, or whatever stands in for it, since its grid lies "
                "along compass north" +
                (scan_problem_.empty() ? "" : "; " + scan_problem_),
            nullptr};
  }
  std::ostringstream text;
  text << placed_.size() << " readings at " << coverage_->headings() << " headings" << leftOut();
  return {ScanStatus::kSucceeded, text.str(), std::make_shared<const core::Scan>(std::move(*scan))};
}

ScanOutcome ScanCollector::tooFew() const {
  const auto most = std::max_element(rejected_.begin(), rejected_.end());
  const auto reason = static_cast<Reject>(most - rejected_.begin());
  ScanStatus status = ScanStatus::kTooFewReadings;
  if (*most > 0 && reason == Reject::kNoHeading) status = ScanStatus::kNoHeading;
  if (*most > 0 && reason == Reject::kNoOdometry) status = ScanStatus::kNoOdometry;

  std::ostringstream text;
  text << placed_.size() << " readings can be used, " << parameters_.scan.min_readings
       << " are needed (scan/min_readings)" << leftOut();
  if (placed_.empty() && *most == 0) {
    text << "; is anything published on " << boost::algorithm::join(parameters_.sonar_topics, ", ")
         << "?";
  }
  if (!scan_problem_.empty()) text << "; " << scan_problem_;
  return {status, text.str(), nullptr};
}

std::string ScanCollector::leftOut() const {
  const std::string words = inWords(rejected_);
  return words.empty() ? words : "; left out: " + words;
}

}  // namespace place_memory::node
