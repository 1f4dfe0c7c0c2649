#include "node/answer/answer_words.h"

#include <cmath>

namespace place_memory::node {
namespace {

std::string percent(double probability) {
  return std::to_string(std::lround(100.0 * probability)) + " %";
}

std::string verdictInWords(const core::PlaceMemory::Answer& answer) {
  const core::Recognition& found = answer.recognition;
  if (found.matches.empty()) return "not recognised: no place was learned yet";
  const std::string best = quoted(answer.labels.front()) + " with probability " +
                           percent(found.matches.front().probability);
  switch (found.verdict) {
    case core::Verdict::kRecognized:
      return "recognised " + best;
    case core::Verdict::kAmbiguous:
      return "ambiguous: the best of " + placesInWords(found.matches.size()) + " is " + best;
    case core::Verdict::kUnknown:
      break;
  }
  if (found.no_echo) {
    return "not recognised: no echo lies in the scan's grid, so that it tells nothing of where it "
           "was taken; the space is open, or the sensors hear nothing, or their ranges are not "
           "metres";
  }
  return "not recognised: the best of " + placesInWords(found.matches.size()) + " is " + best;
}

}  // namespace

std::string quoted(const std::string& label) { return '"' + label + '"'; }

std::string placesInWords(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " place" : " places");
}

std::string inWords(const core::PlaceMemory::Answer& answer) {
  std::string words = verdictInWords(answer);
  if (answer.adapted) words += "; the scan was folded into " + quoted(answer.labels.front());
  if (answer.joined > 0) {
    words += "; " + placesInWords(answer.joined) +
             " learned before it was known where the robot was moved to where they belong";
  }
  if (!answer.adapt_problem.empty()) {
    words += "; the map did not follow, the scan was not folded into " +
             quoted(answer.labels.front()) + ": " + answer.adapt_problem;
  }
  if (answer.superseded) {
    words +=
        "; a newer scan, or a jump of time or odometry, overtook this answer: it does not say "
        "where the robot is now";
  }
  return words;
}

}  // namespace place_memory::node
