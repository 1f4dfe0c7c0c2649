#include "core/views/pose_candidates.h"

#include <algorithm>
#include <cmath>

namespace place_memory::core {
namespace {

constexpr double kSameSpot = 1.0;                    // [m]
constexpr double kSameHeading = 30.0 * kPi / 180.0;  // [rad]
constexpr double kLeastShare = 0.02;
constexpr std::size_t kMost = 8;

bool isSame(const PoseCandidate& one, const PoseCandidate& other) {
  if (one.session != other.session) return false;
  const Pose2d off = one.map_from_base.inverse() * other.map_from_base;
  return std::hypot(off.x, off.y) <= kSameSpot && std::abs(off.yaw) <= kSameHeading;
}

void sortByProbability(std::vector<PoseCandidate>& candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const PoseCandidate& one, const PoseCandidate& other) {
                     return one.probability > other.probability;
                   });
}

double sumOf(const std::vector<PoseCandidate>& candidates) {
  double sum = 0.0;
  for (const PoseCandidate& candidate : candidates) sum += candidate.probability;
  return sum;
}

}  // namespace

std::vector<PoseCandidate> mergedCandidates(std::vector<PoseCandidate> candidates) {
  sortByProbability(candidates);
  std::vector<PoseCandidate> merged;
  for (const PoseCandidate& candidate : candidates) {
    if (!(candidate.probability > 0.0)) continue;
    const auto same = std::find_if(merged.begin(), merged.end(), [&](const PoseCandidate& other) {
      return isSame(candidate, other);
    });
    if (same == merged.end()) {
      merged.push_back(candidate);
    } else {
      same->probability += candidate.probability;
    }
  }
  sortByProbability(merged);
  const double least = kLeastShare * sumOf(merged);
  while (merged.size() > kMost || (!merged.empty() && merged.back().probability < least)) {
    merged.pop_back();
  }
  const double sum = sumOf(merged);
  for (PoseCandidate& candidate : merged) candidate.probability /= sum;
  return merged;
}

}  // namespace place_memory::core
