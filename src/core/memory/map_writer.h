#ifndef PLACE_MEMORY_CORE_MEMORY_MAP_WRITER_H
#define PLACE_MEMORY_CORE_MEMORY_MAP_WRITER_H

#include <chrono>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "core/index/place_index.h"
#include "core/memory/whereabouts.h"
#include "core/route/route_planner.h"
#include "core/store/place_store.h"
#include "place_memory/core/place_map.h"
#include "place_memory/core/place_memory.h"

namespace place_memory::core {

/// What everybody reads, each time for a moment.
struct MemoryState {
  mutable std::mutex mutex;  ///< guards map, index and whereabouts
  PlaceMap map;
  PlaceIndex index;
  WhereaboutsOwner whereabouts;
  /// Guards routes; the map does not change while it is held. To be locked before `mutex`.
  std::mutex routes_mutex;
  RoutePlanner routes;

  /// As the store has them; `progress` is told how far reading has come.
  MemoryState(const PlaceStore& store, bool located, const LinkLearningOptions& links);
};

/// Makes changes of the map: in store, map, index and whereabouts together, or in none of them.
///
/// All but listen(), watch(), health() and now() is for one thread, which alone changes the map: it
/// may read MemoryState::map without the mutex.
class MapWriter {
 public:
  using Clock = std::function<std::chrono::nanoseconds()>;

  MapWriter(PlaceStore store, MemoryState& state, Clock clock);

  /// What `query` returns of the store. Throws PlaceMemoryError where it throws StoreError.
  template <class Query>
  auto query(const Query& query) {
    try {
      return query(store_);
    } catch (const StoreError& error) {
      refuse(error);
    }
  }

  /// Makes the edits one change; without an edit there is none. `settle`, where given, runs in the
  /// moment in which everybody sees the change. Then listeners are told. The history has the change
  /// under `words`, or where there are none as editsInWords() has it. Throws PlaceMemoryError where
  /// the store fails, and std::invalid_argument where the edits do not fit the map; nothing is
  /// changed then.
  void commit(std::vector<MapEdit> edits, const std::function<void()>& settle = nullptr,
              const std::string& words = "");

  /// Makes the edits of a drive one change, which is in no history. `scans`, where given, take the
  /// place of those in the store, also where there is no edit. Throws likewise.
  void commitDriven(std::vector<MapEdit> edits, const KeptMap* scans);

  /// Takes back the newest changes of the history, all in one change, and returns them. Throws
  /// PlaceMemoryError; nothing is changed then.
  std::vector<PastChange> undo(std::size_t count);

  void listen(PlaceMemory::Listener listener);
  void watch(PlaceMemory::HealthListener listener);
  StoreHealth health() const;
  std::chrono::nanoseconds now() const { return clock_(); }

 private:
  MapChange changeOf(std::vector<MapEdit> edits) const;
  HistoryEdit historyOf(const MapChange& change, const std::string& words) const;
  void make(const MapChange& change, const HistoryEdit& history,
            const std::function<void()>& settle);
  void keep(const std::function<void(PlaceStore&)>& commit);
  void show(const MapChange& change, const std::function<void()>& settle);
  void apply(const MapChange& change, const std::function<void()>& settle);
  [[noreturn]] void refuse(const StoreError& error);
  void report(const std::string& problem);

  PlaceStore store_;
  MemoryState& state_;
  const Clock clock_;

  mutable std::mutex mutex_;  ///< guards everything below
  std::vector<PlaceMemory::Listener> listeners_;
  std::vector<PlaceMemory::HealthListener> watchers_;
  StoreHealth health_;
};

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_MEMORY_MAP_WRITER_H
