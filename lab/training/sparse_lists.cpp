#include "training/sparse_lists.h"

#include "training/strangers.h"

namespace place_memory::training {

CalibrationScans alignSparse(trials::SparseKind kind, std::uint64_t seed,
                             const core::SonarModel& model, const core::MatchMetric& metric) {
  const trials::SparseTrials made = trials::simulateSparse(kind, seed);
  trials::TrialSet elsewhere;
  elsewhere.trials = made.strangers;
  CalibrationScans scans;
  scans.known = alignAll(made.known, model, metric);
  scans.strangers = withoutNearPlaces(made.known, scans.known, kStrangerDistance);
  for (CandidateList& list : alignStrangers(made.known, elsewhere, model, metric)) {
    scans.strangers.push_back(std::move(list));
  }
  return scans;
}

}  // namespace place_memory::training
