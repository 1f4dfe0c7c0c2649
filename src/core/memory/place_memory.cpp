#include "place_memory/core/place_memory.h"

#include <utility>

#include "core/map/place_label.h"
#include "core/memory/place_memory_impl.h"

namespace place_memory::core {
namespace {

using Reason = PlaceMemoryError::Reason;

std::chrono::nanoseconds systemTime() {
  return std::chrono::system_clock::now().time_since_epoch();
}

AdaptationOptions checked(const AdaptationOptions& options) {
  // Written so that NaN fails.
  if (!(options.retention >= 0.0 && options.retention < 1.0)) {
    throw std::invalid_argument("adaptation retention must lie in [0, 1)");
  }
  return options;
}

}  // namespace

const Place& findPlace(const PlaceMap& map, const std::string& label) {
  const Place* place = map.find(label);
  if (place == nullptr) {
    // What is no label is not repeated: it may be too long or too broken to be shown.
    throw PlaceMemoryError(Reason::kUnknownPlace, isValidLabel(label)
                                                      ? "there is no place \"" + label + "\""
                                                      : "there is no place with that label");
  }
  return *place;
}

PlaceMemory::Impl::Impl(const PlaceMemoryOptions& options, PlaceStore store)
    : cell_size_(options.cell_size),
      located_(options.recognizer.located),
      sonar_(options.sonar),
      tuning_(tuningOf(options.recognizer, options.adaptation)),
      state_(store, located_, options.links),
      links_(options.links),
      writer_(std::move(store), state_, options.clock ? options.clock : systemTime),
      driven_places_(options.cell_size, options.sonar, options.links) {}

PlaceMemory::Impl::Tuning PlaceMemory::Impl::tuningOf(const RecognizerOptions& recognizer,
                                                      const AdaptationOptions& adaptation) {
  return {recognizer, std::make_shared<const Recognizer>(recognizer), checked(adaptation)};
}

PlaceMemory::Impl::Tuning PlaceMemory::Impl::tuning() const {
  const std::lock_guard<std::mutex> lock(tuning_mutex_);
  return tuning_;
}

void PlaceMemory::Impl::setOptions(const RecognizerOptions& recognizer,
                                   const AdaptationOptions& adaptation) {
  RecognizerOptions options = recognizer;
  options.located = located_;
  Tuning tuned = tuningOf(options, adaptation);
  const std::lock_guard<std::mutex> lock(tuning_mutex_);
  tuning_ = std::move(tuned);
}

void PlaceMemory::Impl::rename(const std::string& label, const std::string& new_label) {
  queue_.run([&] {
    const PlaceId id = findPlace(state_.map, label).id;
    if (new_label.empty()) refuseLabel();
    if (new_label == label) return;
    writer_.commit({PlaceRenamed{id, newLabel(state_.map, new_label)}});
  });
}

void PlaceMemory::Impl::remove(const std::string& label) {
  queue_.run([&] { writer_.commit({PlaceRemoved{findPlace(state_.map, label).id}}); });
}

std::size_t PlaceMemory::Impl::clear() {
  return queue_.run([&] {
    const std::size_t places = state_.map.size();
    writer_.commit({MapCleared{}});
    return places;
  });
}

EvidenceGrid PlaceMemory::Impl::grid(PlaceId id) {
  return queue_.run([&] {
    if (state_.map.find(id) == nullptr) {
      throw PlaceMemoryError(Reason::kUnknownPlace, "there is no place " + std::to_string(id));
    }
    return writer_.query([&](PlaceStore& store) { return store.grid(id); });
  });
}

void PlaceMemory::Impl::forgetWhereabouts() {
  const std::lock_guard<std::mutex> lock(state_.mutex);
  state_.whereabouts.forget(state_.map.size() == 0);
}

PlaceMemory::PlaceMemory(const PlaceMemoryOptions& options)
    : impl_(std::make_unique<Impl>(
          options, PlaceStore(options.store_path, options.cell_size, options.opening))) {}

PlaceMemory::~PlaceMemory() = default;

PlaceMemory::Learned PlaceMemory::learn(const Scan& scan, const std::string& label, bool force) {
  return impl_->learn(scan, label, force);
}

PlaceMemory::Answer PlaceMemory::recognize(const Scan& scan, std::optional<double> heading_window,
                                           const std::function<bool()>& cancelled) {
  return impl_->recognize(scan, heading_window, cancelled);
}

void PlaceMemory::setOptions(const RecognizerOptions& recognizer,
                             const AdaptationOptions& adaptation) {
  impl_->setOptions(recognizer, adaptation);
}

void PlaceMemory::rename(const std::string& label, const std::string& new_label) {
  impl_->rename(label, new_label);
}

void PlaceMemory::remove(const std::string& label) { impl_->remove(label); }

std::size_t PlaceMemory::clear() { return impl_->clear(); }

std::size_t PlaceMemory::size() const {
  return impl_->read([](const MemoryState& state) { return state.map.size(); });
}

std::uint64_t PlaceMemory::version() const {
  return impl_->read([](const MemoryState& state) { return state.map.version(); });
}

MapSnapshot PlaceMemory::map() const {
  return impl_->read([](const MemoryState& state) {
    const PlaceMap& map = state.map;
    return MapSnapshot{map.version(), map.stamp(), map.places(), map.links()};
  });
}

std::optional<Place> PlaceMemory::place(PlaceId id) const {
  return impl_->read([id](const MemoryState& state) {
    const Place* place = state.map.find(id);
    return place == nullptr ? std::nullopt : std::optional<Place>(*place);
  });
}

std::optional<Place> PlaceMemory::place(const std::string& label) const {
  return impl_->read([&label](const MemoryState& state) {
    const Place* place = state.map.find(label);
    return place == nullptr ? std::nullopt : std::optional<Place>(*place);
  });
}

EvidenceGrid PlaceMemory::grid(PlaceId id) const { return impl_->grid(id); }

RoutePlan PlaceMemory::plan(const RouteQuery& query) { return impl_->plan(query); }

void PlaceMemory::reportTraversal(const Traversal& traversal) { impl_->reportTraversal(traversal); }

void PlaceMemory::setLink(PlaceId from, PlaceId to, LinkOrder order, double toll, bool both_ways) {
  impl_->setLink(from, to, order, toll, both_ways);
}

std::pair<double, double> PlaceMemory::linkOdds(PlaceId first, PlaceId second) const {
  return impl_->linkOdds(first, second);
}

std::vector<Traversal> PlaceMemory::traversals() const { return impl_->traversals(); }

Whereabouts PlaceMemory::whereabouts() const {
  return impl_->read([](const MemoryState& state) { return state.whereabouts.now(); });
}

void PlaceMemory::forgetWhereabouts() { impl_->forgetWhereabouts(); }

KeptMap PlaceMemory::drivenMap() const { return impl_->drivenMap(); }

void PlaceMemory::keep(const KeptMap& map) { impl_->keep(map); }
void PlaceMemory::keepTravels(const KeptMap& map) { impl_->keepTravels(map); }

void PlaceMemory::keepNewPlaces(const KeptMap& map) { impl_->keepNewPlaces(map); }

void PlaceMemory::followDrive(const std::optional<DriveWhereabouts>& whereabouts) {
  impl_->followDrive(whereabouts);
}

void PlaceMemory::listen(Listener listener) { impl_->writer().listen(std::move(listener)); }

StoreHealth PlaceMemory::storeHealth() const { return impl_->writer().health(); }

void PlaceMemory::watchStore(HealthListener listener) {
  impl_->writer().watch(std::move(listener));
}

}  // namespace place_memory::core
