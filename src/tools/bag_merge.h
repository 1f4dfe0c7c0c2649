#ifndef PLACE_MEMORY_TOOLS_BAG_MERGE_H
#define PLACE_MEMORY_TOOLS_BAG_MERGE_H

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tools/stamp_order.h"

namespace place_memory::tools {

/// The messages of several bags by rising time; what several of them hold comes once.
class BagMerge {
 public:
  explicit BagMerge(std::vector<StampOrder> orders) : orders_(std::move(orders)) {}

  /// Nothing: there is no more. Throws what StampOrder throws.
  std::optional<TimedMessage> next();

 private:
  struct Visited {
    std::size_t bag = 0;
    TimedMessage timed;
  };

  StampOrder* earliest();
  bool isCopy(const StampOrder& from, const TimedMessage& timed);

  std::vector<StampOrder> orders_;
  std::vector<Visited> now_;  // of the newest time
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_BAG_MERGE_H
