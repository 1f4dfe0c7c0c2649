#include "training/strangers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace place_memory::training {

std::vector<CandidateList> withoutNearPlaces(const trials::TrialSet& set,
                                             const std::vector<CandidateList>& lists,
                                             double distance) {
  std::vector<CandidateList> strangers = lists;
  for (std::size_t i = 0; i < strangers.size(); ++i) {
    const core::Pose2d& scan = set.trials[i].odom_from_scan;
    const auto near = [&](const Candidate& candidate) {
      const core::Pose2d& place = set.learned[candidate.place].odom_from_scan;
      return candidate.right || std::hypot(place.x - scan.x, place.y - scan.y) < distance;
    };
    auto& candidates = strangers[i].candidates;
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), near), candidates.end());
  }
  return strangers;
}

std::vector<CandidateList> amongFewPlaces(const std::vector<CandidateList>& lists) {
  std::mt19937 engine(1);
  constexpr std::size_t kOneIn = 10;
  std::vector<CandidateList> few;
  for (std::size_t i = 0; i < lists.size(); i += kOneIn) few.push_back(lists[i]);
  for (CandidateList& list : few) {
    auto& candidates = list.candidates;
    std::shuffle(candidates.begin(), candidates.end(), engine);
    std::stable_partition(candidates.begin(), candidates.end(),
                          [](const Candidate& candidate) { return candidate.right; });
    const auto right = std::count_if(candidates.begin(), candidates.end(),
                                     [](const Candidate& candidate) { return candidate.right; });
    if (right > 1) candidates.erase(candidates.begin() + 1, candidates.begin() + right);
    const std::size_t places = 1 + engine() % 4;
    if (candidates.size() > places) {
      candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(places), candidates.end());
    }
  }
  return few;
}

}  // namespace place_memory::training
