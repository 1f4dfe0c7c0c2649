#include "rviz/verdict_words.h"

#include <cmath>

namespace place_memory::panel {
namespace {

std::string inWords(const PlaceMatch& match) {
  return '"' + match.label + "\" with " + percent(match.probability);
}

}  // namespace

std::string percent(double probability) {
  return std::to_string(std::lround(100.0 * probability)) + " %";
}

std::string counted(std::size_t count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string verdictInWords(const Recognition& recognition) {
  const auto& matches = recognition.matches;
  if (matches.empty()) return "Not recognized: no place was learned yet.";
  const std::string best = inWords(matches.front());
  if (recognition.verdict == Recognition::RECOGNIZED) return "Recognized: " + best + ".";
  if (recognition.verdict == Recognition::AMBIGUOUS && matches.size() > 1) {
    return "Ambiguous: some places look alike from here, " + best + ", " + inWords(matches[1]) +
           ". A scan from another spot may part them.";
  }
  return "Not recognized: no place is sure to fit; the best of " + std::to_string(matches.size()) +
         " is " + best + ".";
}

}  // namespace place_memory::panel
