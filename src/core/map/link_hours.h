#ifndef PLACE_MEMORY_CORE_MAP_LINK_HOURS_H
#define PLACE_MEMORY_CORE_MAP_LINK_HOURS_H

#include <array>
#include <chrono>
#include <cstddef>
#include <map>
#include <utility>

#include "place_memory/core/place_map.h"

namespace place_memory::core {

/// At which hours of the day links tend to be open, both ways alike, as doors are.
///
/// Each traversal is foretold twice before it counts: by the odds alone, and with what earlier ones
/// found at that hour. The hours of a link are used where they foretold better, twenty to one by
/// the sum of log likelihoods, of which older ones fade (prequential validation: Dawid 1984). A
/// link that never failed has no hours, and costs no memory.
class LinkHours {
 public:
  /// `half_life` of the odds alone [s], as LinkLearningOptions has it.
  explicit LinkHours(double half_life) : half_life_(half_life) {}

  /// Traversals come in the order of their time; one that is older counts as of the newest's time.
  void note(const Traversal& traversal);
  void forget(PlaceId one, PlaceId other);
  void clear() { links_.clear(); }

  /// The chance `odds` of getting through, with the hour at `now` weighed in where that foretells
  /// better, in [kLeastOdds, 1). What is all but closed is not opened by the hour: somebody said
  /// so.
  double weighed(const PlaceLink& link, double odds, std::chrono::nanoseconds now) const;
  /// Whether there is a link whose hours are used.
  bool any() const;

  /// In [0, 24), of UTC.
  static int hourOf(std::chrono::nanoseconds time);

 private:
  struct Count {
    double through = 0.0;
    double blocked = 0.0;
  };
  /// What traversals of one link say.
  struct Hours {
    std::array<Count, 24> at{};
    Count lately;       ///< as the odds alone count them
    double gain = 0.0;  ///< of the log likelihood, by the hours
    std::chrono::nanoseconds last{0};
  };

  static void age(Count& count, double left);
  static double shift(const Hours& hours, int hour);

  double half_life_;
  std::map<std::pair<PlaceId, PlaceId>, Hours> links_;  ///< that failed once, by their ends
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MAP_LINK_HOURS_H
