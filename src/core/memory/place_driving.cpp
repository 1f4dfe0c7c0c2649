#include "core/memory/place_memory_impl.h"

namespace place_memory::core {

KeptMap PlaceMemory::Impl::drivenMap() {
  return queue_.run([&] {
    return writer_.query([&](PlaceStore& store) { return driven_places_.take(state_.map, store); });
  });
}

void PlaceMemory::Impl::keep(const KeptMap& map) {
  queue_.run([&] {
    const PlaceId next = writer_.query([](PlaceStore& store) { return store.nextId(); });
    writer_.commitDriven(driven_places_.edits(state_.map, map, next, false), &map);
    driven_places_.kept(state_.map, map);
  });
}

void PlaceMemory::Impl::keepNewPlaces(const KeptMap& map) {
  queue_.run([&] {
    const PlaceId next = writer_.query([](PlaceStore& store) { return store.nextId(); });
    writer_.commitDriven(driven_places_.edits(state_.map, map, next, true), nullptr);
    driven_places_.kept(state_.map, map);
  });
}

void PlaceMemory::Impl::keepTravels(const KeptMap& map) {
  queue_.run([&] { writer_.commitDriven(driven_places_.travels(state_.map, map), nullptr); });
}

void PlaceMemory::Impl::followDrive(const std::optional<DriveWhereabouts>& whereabouts) {
  const std::lock_guard<std::mutex> lock(state_.mutex);
  const Place* current = whereabouts ? state_.map.find(whereabouts->current) : nullptr;
  state_.whereabouts.drive(whereabouts, current);
}

SessionId PlaceMemory::Impl::mapSession() const {
  SessionId oldest = kNoSession;
  for (const Place& place : state_.map.places()) {
    if (oldest == kNoSession || place.session < oldest) oldest = place.session;
  }
  return oldest == kNoSession ? kFirstSession : oldest;
}

}  // namespace place_memory::core
