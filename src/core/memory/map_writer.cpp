#include "core/memory/map_writer.h"

#include <iterator>
#include <stdexcept>
#include <utility>

#include "core/map/change_words.h"
#include "core/map/inverse_change.h"

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
  routes.remember(store.traversals());
  store.forEachPlanes([this](PlaceId id, const CellPlanes& planes) { index.put(id, planes); });
}

MapWriter::MapWriter(PlaceStore store, MemoryState& state, Clock clock)
    : store_(std::move(store)), state_(state), clock_(std::move(clock)) {
  report(store_.whyReadOnly());
}

MapChange MapWriter::changeOf(std::vector<MapEdit> edits) const {
  MapChange change{state_.map.version() + 1, clock_(), std::move(edits)};
  state_.map.check(change);
  return change;
}

HistoryEdit MapWriter::historyOf(const MapChange& change, const std::string& words) const {
  HistoryEdit history;
  const std::string said = words.empty() ? editsInWords(change.edits, state_.map) : words;
  if (said.empty()) return history;
  HistoryEdit::Row row{{change.version, change.stamp, said, false}, {}};
  try {
    auto inverse = inverseOf(change.edits, state_.map,
                             {[this](PlaceId id) { return store_.grid(id); },
                              [this](PlaceId id) { return store_.readings(id); }},
                             kMostInverseBytes);
    row.change.can_be_undone = inverse.has_value();
    if (inverse) row.inverse = std::move(*inverse);
  } catch (const StoreError&) {
    // What is damaged cannot be brought back, but it may go.
  }
  history.add = std::move(row);
  return history;
}

void MapWriter::commit(std::vector<MapEdit> edits, const std::function<void()>& settle,
                       const std::string& words) {
  if (edits.empty()) return;
  const MapChange change = changeOf(std::move(edits));
  make(change, historyOf(change, words), settle);
}

std::vector<PastChange> MapWriter::undo(std::size_t count) {
  using Reason = PlaceMemoryError::Reason;
  const std::vector<PastChange> changes =
      query([count](PlaceStore& store) { return store.history(count); });
  if (changes.size() < count) {
    throw PlaceMemoryError(Reason::kNothingToUndo, changes.empty()
                                                       ? "there is no change in the history"
                                                       : "there are no more than " +
                                                             std::to_string(changes.size()) +
                                                             " changes in the history");
  }
  std::vector<MapEdit> edits;
  HistoryEdit history;
  for (const PastChange& change : changes) {
    auto inverse = query([&change](PlaceStore& store) { return store.inverse(change.version); });
    if (!inverse) {
      throw PlaceMemoryError(Reason::kCannotUndo,
                             "what was there before this change was too much to be kept, or is "
                             "damaged: " +
                                 change.words);
    }
    std::move(inverse->begin(), inverse->end(), std::back_inserter(edits));
    history.remove.push_back(change.version);
  }
  try {
    make(changeOf(std::move(edits)), history, nullptr);
  } catch (const std::invalid_argument& error) {
    throw PlaceMemoryError(Reason::kCannotUndo,
                           std::string("the map has changed since: ") + error.what());
  }
  return changes;
}

void MapWriter::commitDriven(std::vector<MapEdit> edits, const KeptMap* scans) {
  if (!edits.empty()) {
    const MapChange change = changeOf(std::move(edits));
    keep([&](PlaceStore& store) {
      scans != nullptr ? store.commit(change, *scans) : store.commit(change);
    });
    show(change, nullptr);
  } else if (scans != nullptr) {
    const MapChange nothing{state_.map.version(), state_.map.stamp(), {}};
    keep([&](PlaceStore& store) { store.commit(nothing, *scans); });
  }
}

void MapWriter::make(const MapChange& change, const HistoryEdit& history,
                     const std::function<void()>& settle) {
  keep([&](PlaceStore& store) { store.commit(change, history); });
  show(change, settle);
}

void MapWriter::show(const MapChange& change, const std::function<void()>& settle) {
  apply(change, settle);
  std::vector<PlaceMemory::Listener> listeners;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    listeners = listeners_;
  }
  tell(listeners, change);
}

void MapWriter::keep(const std::function<void(PlaceStore&)>& commit) {
  try {
    commit(store_);
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
