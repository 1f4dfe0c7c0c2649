#ifndef PLACE_MEMORY_CORE_LINK_LEARNING_H
#define PLACE_MEMORY_CORE_LINK_LEARNING_H

namespace place_memory::core {

/// How links learn from traversals what to expect of the next one.
///
/// The odds of getting through are those of a Beta distribution: a / (a + b), never below
/// kLeastOdds. Each traversal that succeeds adds one to a, each that fails one to b, and what they
/// added loses half its weight in every half_life; so a and b return to (4, 1) where the robot went
/// along the link before, either way, and to (2, 1) where it never did. How often traversals fail
/// in the whole map scales that last 1 of all links: where nothing ever closes, nothing is feared
/// of links that are seldom used.
///
/// (After the idea of ELDEN, paper 10. Every link may be found open again, because its odds never
/// get to zero.)
struct LinkLearningOptions {
  double half_life = 172800.0;  ///< [s], > 0
  double speed = 0.3;  ///< at which a link is taken to be driven until it was timed [m/s], > 0
};

constexpr double kLeastOdds = 0.05;

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_LINK_LEARNING_H
