#include "core/memory/map_writer.h"

#include <utility>

namespace place_memory::core {
namespace {

/// Makes the edits in the index.
class IndexEditor {
 public:
  /// `map`: as it is after the change.
  IndexEditor(PlaceIndex& index, const PlaceMap& map) : index_(index), map_(map) {}

  void operator()(const PlaceAdded& edit) { put(edit.place.id, CellPlanes(*edit.grid)); }
  void operator()(const GridAdapted& edit) { put(edit.id, CellPlanes(*edit.grid)); }
  void operator()(const PlaceMoved& edit) { put(edit.id, index_.cells(edit.id)); }
  void operator()(const PlaceRemoved& edit) { index_.erase(edit.id); }
  void operator()(const MapCleared& /*edit*/) { index_.clear(); }
  template <class Edit>
  void operator()(const Edit& /*edit*/) {}

 private:
  void put(PlaceId id, const CellPlanes& cells) {
    const Place* place = map_.find(id);
    if (place != nullptr) index_.put(id, place->map_from_place, cells);
  }

  PlaceIndex& index_;
  const PlaceMap& map_;
};

// A listener cannot undo what is kept, and must not keep others from hearing of it.
template <class Listener, class News>
void tell(const std::vector<Listener>& listeners, const News& news) {
  for (const Listener& listener : listeners) {
    try {
      listener(news);
    } catch (...) {
    }
  }
}

}  // namespace

MemoryState::MemoryState(const PlaceStore& store, bool located)
    : map(store.map()), whereabouts(located, map.size() == 0, store.nextSession()) {
  store.forEachPlanes([this](PlaceId id, const CellPlanes& planes) {
    index.put(id, map.find(id)->map_from_place, planes);
  });
}

MapWriter::MapWriter(PlaceStore store, MemoryState& state, Clock clock)
    : store_(std::move(store)), state_(state), clock_(std::move(clock)) {}

void MapWriter::commit(std::vector<MapEdit> edits, const std::function<void()>& settle) {
  if (edits.empty()) return;
  const MapChange change{state_.map.version() + 1, clock_(), std::move(edits)};
  state_.map.check(change);
  keep(change);
  apply(change, settle);
  std::vector<PlaceMemory::Listener> listeners;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    listeners = listeners_;
  }
  tell(listeners, change);
}

void MapWriter::keep(const MapChange& change) {
  try {
    store_.commit(change);
  } catch (const StoreError& error) {
    report(error.what());
    throw PlaceMemoryError(PlaceMemoryError::Reason::kStoreFailed, error.what());
  }
  report("");
}

void MapWriter::apply(const MapChange& change, const std::function<void()>& settle) {
  const std::lock_guard<std::mutex> lock(state_.mutex);
  state_.map.apply(change);
  IndexEditor editor(state_.index, state_.map);
  for (const MapEdit& edit : change.edits) std::visit(editor, edit);
  state_.whereabouts.follow(change, state_.map.size() == 0);
  if (settle) settle();
}

void MapWriter::report(const std::string& problem) {
  std::vector<PlaceMemory::HealthListener> watchers;
  StoreHealth health;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (problem == health_.problem) return;
    health_ = {problem.empty(), problem, clock_()};
    health = health_;
    watchers = watchers_;
  }
  tell(watchers, health);
}

void MapWriter::listen(PlaceMemory::Listener listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  listeners_.push_back(std::move(listener));
}

void MapWriter::watch(PlaceMemory::HealthListener listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  watchers_.push_back(std::move(listener));
}

StoreHealth MapWriter::health() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return health_;
}

}  // namespace place_memory::core
