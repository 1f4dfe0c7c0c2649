#include "training/strangers.h"

#include <algorithm>
#include <cmath>

namespace place_memory::training {

std::vector<CandidateList> withoutNearPlaces(const trials::TrialSet& set,
                                             const std::vector<CandidateList>& lists,
                                             double distance) {
  std::vector<CandidateList> strangers = lists;
  for (std::size_t i = 0; i < strangers.size(); ++i) {
    const core::Pose2d& scan = set.trials[i].map_from_scan;
    const auto near = [&](const Candidate& candidate) {
      const core::Pose2d& place = set.learned[candidate.place].map_from_scan;
      return candidate.right || std::hypot(place.x - scan.x, place.y - scan.y) < distance;
    };
    auto& candidates = strangers[i].candidates;
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(), near), candidates.end());
  }
  return strangers;
}

}  // namespace place_memory::training
