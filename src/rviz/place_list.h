#ifndef PLACE_MEMORY_RVIZ_PLACE_LIST_H
#define PLACE_MEMORY_RVIZ_PLACE_LIST_H

#include <place_memory/MapChange.h>
#include <place_memory/PlaceGraph.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace place_memory::panel {

struct PlaceRow {
  std::int64_t id = 0;
  std::string label;
  std::int64_t session = 0;
  double x = 0.0;  ///< in the map frame [m]
  double y = 0.0;
};

using PlaceRows = std::vector<PlaceRow>;

/// A copy of the map's places, kept by its changes as MapChange.msg says.
class PlaceList {
 public:
  void reset(const PlaceGraph& graph);

  /// The node is another one now, or is gone: nothing is known.
  void forget();

  /// False where changes were missed, so that the whole is to be asked for.
  bool apply(const MapChange& change);

  /// By rising id; the same object as long as nothing changes.
  std::shared_ptr<const PlaceRows> rows() const;

 private:
  void doWhatItSays(const MapChange& change);

  std::map<std::int64_t, PlaceRow> places_;
  std::optional<std::uint64_t> version_;
  mutable std::shared_ptr<const PlaceRows> rows_;  // nullptr: to be made anew
};

}  // namespace place_memory::panel

#endif  // PLACE_MEMORY_RVIZ_PLACE_LIST_H
