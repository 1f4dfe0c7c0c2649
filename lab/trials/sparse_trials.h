#ifndef PLACE_MEMORY_TRIALS_SPARSE_TRIALS_H
#define PLACE_MEMORY_TRIALS_SPARSE_TRIALS_H

#include <array>
#include <cstdint>
#include <vector>

#include "trials/trial_set.h"

namespace place_memory::trials {

/// What leaves a scan with little to go by.
enum class SparseKind {
  kOpenSpace,   ///< walls far out of reach, a few things standing about
  kHall,        ///< a large room heard at short reach
  kDeadRing,    ///< a known building, the sensors nearly or wholly dead as the robot comes back
  kWrongUnits,  ///< ranges in centimetres, feet and the like, taken for metres
  kFewSensors,  ///< one, three or four sensors of short reach, that turn little or all round
};

constexpr std::array<SparseKind, 5> kEverySparseKind{SparseKind::kOpenSpace, SparseKind::kHall,
                                                     SparseKind::kDeadRing, SparseKind::kWrongUnits,
                                                     SparseKind::kFewSensors};

/// "open space", "hall", "dead ring", "wrong units" or "few sensors".
const char* nameOf(SparseKind kind);

/// A memory, scans of its places, and scans of the same robot elsewhere, of which nothing is right.
struct SparseTrials {
  TrialSet known;
  std::vector<RecognitionTrial> strangers;
};

/// Random world, robot and changes; the same for the same kind and seed. Memories of dead rings and
/// wrong units hold an open space besides the building. Scans without any echo are among them.
SparseTrials simulateSparse(SparseKind kind, std::uint64_t seed);

}  // namespace place_memory::trials

#endif  // PLACE_MEMORY_TRIALS_SPARSE_TRIALS_H
