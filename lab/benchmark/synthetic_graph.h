#ifndef PLACE_MEMORY_BENCHMARK_SYNTHETIC_GRAPH_H
#define PLACE_MEMORY_BENCHMARK_SYNTHETIC_GRAPH_H

#include <cstddef>
#include <cstdint>

#include "core/map/pose_relaxation.h"

namespace place_memory::measure {

/// A way back and forth through a building, a pose every metre and a half, in `rows` of `length`
/// poses that see each other: odometry from pose to pose, and every few poses a match with the row
/// beside it. The poses are the true ones. Repeatable by the seed.
core::RelaxationProblem makeGraph(std::size_t rows, std::size_t length, std::uint64_t seed);

/// The same as it is when the matches of the last row are new: its poses are relaxed without them.
core::RelaxationProblem makeGraphBeforeLoop(std::size_t rows, std::size_t length,
                                            std::uint64_t seed);

/// A single round of so many poses that ends where it began, and five matches that say so; the
/// poses are as odometry has them.
core::RelaxationProblem makeRound(std::size_t poses, std::uint64_t seed);

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_SYNTHETIC_GRAPH_H
