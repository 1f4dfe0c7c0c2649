#include "config/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace place_memory::config {
namespace {

constexpr std::size_t kMostLetters = 2;

std::size_t lettersToChange(const std::string& from, const std::string& to) {
  std::vector<std::size_t> row(to.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t change = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearestName(const std::string& name, const std::set<std::string>& known) {
  // A table of a node, as `rosparam dump /` has it, holds the known names one table deeper.
  for (const std::string& candidate : known) {
    const std::string end = "/" + candidate;
    if (name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0) {
      return candidate;
    }
  }
  std::string best;
  std::size_t least = kMostLetters + 1;
  for (const std::string& candidate : known) {
    if (name.size() > candidate.size() + kMostLetters) continue;
    const std::size_t letters = lettersToChange(name, candidate);
    if (letters < least) {
      least = letters;
      best = candidate;
    }
  }
  return best;
}

}  // namespace place_memory::config
