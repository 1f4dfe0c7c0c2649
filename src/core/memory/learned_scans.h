#ifndef PLACE_MEMORY_CORE_MEMORY_LEARNED_SCANS_H
#define PLACE_MEMORY_CORE_MEMORY_LEARNED_SCANS_H

#include <cstdint>
#include <map>
#include <tuple>

#include "place_memory/core/place_id.h"
#include "place_memory/core/scan.h"

namespace place_memory::core {

/// Which place each scan has become since the memory was opened.
///
/// A scan is told from others by its id and pose, one without an id by its stamps and pose. One
/// that has neither id nor stamps is taken as another scan each time.
class LearnedScans {
 public:
  /// kNoPlace: none that is known of.
  PlaceId find(const Scan& scan) const;
  void add(const Scan& scan, PlaceId place);

 private:
  using Key = std::tuple<std::uint64_t, std::int64_t, std::int64_t, double, double, double>;

  static Key keyOf(const Scan& scan);

  std::map<Key, PlaceId> places_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_LEARNED_SCANS_H
