// Why the mapper decided as it did.
#include <cmath>
#include <cstdio>
#include <string>

#include "core/mapping/mapper.h"

namespace place_memory::core {
namespace {

constexpr double kTold = 3.0;      ///< places further off are not worth a word [m]
constexpr std::size_t kAsked = 2;  ///< scans that agree, before a person is asked

std::string fixed(double number, int digits) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, number);
  return text;
}

std::string named(PlaceId id) { return "place " + std::to_string(id); }

/// How much speaks for a candidate, and what is missing.
std::string evidence(const ClosureCandidate& candidate, const ClosureOptions& asked) {
  const double spread = candidate.witnesses.back().way - candidate.witnesses.front().way;
  return std::to_string(candidate.witnesses.size()) + " scans over " + fixed(spread, 1) +
         " m put it about " + named(candidate.witnesses.back().place) + ", " +
         std::to_string(candidate.misses) + " do not (evidence " + fixed(candidate.weight(), 1) +
         " of " + fixed(asked.score, 1) + ", " + std::to_string(asked.witnesses) +
         " scans are asked for)";
}

}  // namespace

std::vector<ClosureQuestion> Mapper::closureQuestions() const {
  std::vector<ClosureQuestion> questions;
  for (const ClosureCandidates* kind : {&loops_, &carried_, &joins_}) {
    for (const ClosureCandidate& candidate : kind->all()) {
      const PlaceId place = candidate.witnesses.back().place;
      const std::size_t scans = candidate.witnesses.size();
      if (candidate.cut || scans < kAsked || !shelf_.has(place)) continue;
      questions.push_back({place, scans, evidence(candidate, kind->options())});
    }
  }
  return questions;
}

std::string Mapper::reasonOf(NodeIndex at, const View& view, const ScanDecision& decision) const {
  const ScanNode& node = graph_.node(at);
  const auto near = shelf_.near(node.pose, node.session, kTold, true);
  const std::string nearest =
      near.empty() ? "no place is within " + fixed(kTold, 0) + " m"
                   : named(near.front().id) + " is " + fixed(near.front().distance, 2) + " m off";
  std::string reason;
  switch (decision.kind) {
    case ScanDecision::Kind::kNewPlace:
      reason = "no other place is within " + fixed(options_.spacing, 1) + " m";
      break;
    case ScanDecision::Kind::kTracked:
      reason = "it looks like where odometry has it; " + nearest;
      if (view.agreement.newest) {
        reason += "; agreement of its newest readings " + fixed(*view.agreement.newest, 2);
      }
      break;
    case ScanDecision::Kind::kClosed:
      reason = "scans enough agree on where the robot came back to; " + nearest;
      break;
    case ScanDecision::Kind::kCandidate:
    case ScanDecision::Kind::kLost: {
      const ClosureCandidate* join = joins_.foremost();
      const ClosureCandidate* carried = carried_.foremost();
      const ClosureCandidate* loop = loops_.foremost();
      if (session_ != kMapSession) {
        reason = "where this session lies in the map is not known; ";
        reason += join ? evidence(*join, joins_.options())
                       : "the scan is of no place of the map that is known by far";
      } else if (carried) {
        reason = "odometry cannot have brought the robot there, but " +
                 evidence(*carried, options_.carried);
      } else if (loop) {
        reason = "perhaps a loop closes: " + evidence(*loop, options_.closure);
      } else {
        reason = "what it sees is not what should be there; " + nearest;
      }
      break;
    }
    case ScanDecision::Kind::kBetween:
      if (view.agreement.newest && *view.agreement.newest < kAgrees) {
        reason = "its newest readings do not fit " +
                 (near.empty() ? std::string("what is near") : named(near.front().id)) +
                 " (agreement " + fixed(*view.agreement.newest, 2) + ")";
      } else if (view.at_place) {
        reason = "it should be of " + named(near.front().id) +
                 ", but does not look so (best match " + fixed(view.best, 2) + ")";
      } else {
        reason = nearest;
      }
      break;
  }
  return reason + tooFast(at);
}

std::string Mapper::tooFast(NodeIndex at) const {
  const std::size_t readings = graph_.node(at).readings->size();
  if (readings >= options_.scan.readings) return "";
  return "; only " + std::to_string(readings) + " of " + std::to_string(options_.scan.readings) +
         " readings on the longest stretch of " + fixed(options_.scan.longest, 1) +
         " m: it drives too fast for its sensors";
}

ScanDecision Mapper::lateDecision(NodeIndex at) const {
  ScanDecision decision;
  decision.stamp = graph_.node(at).stamp;
  decision.kind = ScanDecision::Kind::kNewPlace;
  decision.place = graph_.node(at).place;
  decision.lost = lost();
  decision.reason = "no place was near, once it was clear which loops close" + tooFast(at);
  return decision;
}

}  // namespace place_memory::core
