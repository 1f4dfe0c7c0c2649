#include "core/memory/map_writer.h"

#include <utility>

namespace place_memory::core {
namespace {

/// Makes the edits in the index.
class IndexEditor {
 public:
  explicit IndexEditor(PlaceIndex& index) : index_(index) {}

  void operator()(const PlaceAdded& edit) { index_.put(edit.place.id, *edit.grid); }
  void operator()(const GridAdapted& edit) { index_.put(edit.id, *edit.grid); }
  void operator()(const PlaceRemoved& edit) { index_.erase(edit.id); }
  void operator()(const MapCleared& /*edit*/) { index_.clear(); }
  template <class Edit>
  void operator()(const Edit& /*edit*/) {}

 private:
  PlaceIndex& index_;
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

MemoryState::MemoryState(const PlaceStore& store, bool located, const LinkLearningOptions& links)
    : map(store.map()),
      whereabouts(located, map.size() == 0, store.nextSession()),
      routes(map, links) {
  store.forEachPlanes([this](PlaceId id, const CellPlanes& planes) { index.put(id, planes); });
}

MapWriter::MapWriter(PlaceStore store, MemoryState& state, Clock clock)
    : store_(std::move(store)), state_(state), clock_(std::move(clock)) {
  report(store_.whyReadOnly());
}

void MapWriter::commit(std::vector<MapEdit> edits, const std::function<void()>& settle,
                       const KeptMap* scans) {
  if (edits.empty()) {
    if (scans != nullptr) keep({state_.map.version(), state_.map.stamp(), {}}, scans);
    return;
  }
  const MapChange change{state_.map.version() + 1, clock_(), std::move(edits)};
  state_.map.check(change);
  keep(change, scans);
  apply(change, settle);
  std::vector<PlaceMemory::Listener> listeners;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    listeners = listeners_;
  }
  tell(listeners, change);
}

void MapWriter::keep(const MapChange& change, const KeptMap* scans) {
  try {
    if (scans == nullptr) {
      store_.commit(change);
    } else {
      store_.commit(change, *scans);
    }
  } catch (const StoreError& error) {
    report(error.what());
    refuse(error);
  }
  report("");
}

void MapWriter::refuse(const StoreError& error) {
  throw PlaceMemoryError(PlaceMemoryError::Reason::kStoreFailed, error.what());
}

void MapWriter::apply(const MapChange& change, const std::function<void()>& settle) {
  const std::lock_guard<std::mutex> routes_lock(state_.routes_mutex);
  const std::lock_guard<std::mutex> lock(state_.mutex);
  state_.map.apply(change);
  state_.routes.follow(change);
  IndexEditor editor(state_.index);
  for (const MapEdit& edit : change.edits) std::visit(editor, edit);
  state_.whereabouts.follow(change, state_.map.size() == 0);
  if (settle) settle();
}

void MapWriter::report(const std::string& problem) {
  std::vector<PlaceMemory::HealthListener> watchers;
  StoreHealth health;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (problem == health_.problem && store_.setAside() == health_.set_aside) return;
    health_ = {problem.empty(), problem, clock_(), store_.setAside()};
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
