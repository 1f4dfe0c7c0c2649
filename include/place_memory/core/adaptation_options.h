#ifndef PLACE_MEMORY_CORE_ADAPTATION_OPTIONS_H
#define PLACE_MEMORY_CORE_ADAPTATION_OPTIONS_H

namespace place_memory::core {

/// Whether and how a learned grid follows lasting changes of its place, so that no early state of
/// the world is frozen into it (paper 3.1.2).
struct AdaptationOptions {
  bool enabled = false;
  /// Share of the old evidence that a cell keeps each time it is sensed again, in [0, 1).
  double retention = 0.7;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_ADAPTATION_OPTIONS_H
