#include <filesystem>
#include <utility>

#include "core/memory/place_memory_impl.h"
#include "core/memory/store_merge.h"
#include "core/store/store_file.h"

namespace place_memory::core {
namespace {

using Reason = PlaceMemoryError::Reason;

template <class Work>
auto withOther(const Work& work) {
  try {
    return work();
  } catch (const StoreError& error) {
    throw PlaceMemoryError(Reason::kOtherStore, error.what());
  }
}

PlaceStore openOther(const std::string& path, double cell_size) {
  return withOther([&] {
    // Otherwise a new store is made there.
    if (!std::filesystem::exists(storePath(path))) {
      throwStoreError(storePath(path), "there is no such file");
    }
    return PlaceStore(path, cell_size);
  });
}

std::string nameOf(const std::string& path) {
  return "\"" + std::filesystem::path(path).filename().string() + "\"";
}

}  // namespace

void PlaceMemory::Impl::save(const std::string& path) {
  queue_.run([&] { writer_.query([&](PlaceStore& store) { store.saveAs(path); }); });
}

std::size_t PlaceMemory::Impl::load(const std::string& path) {
  const PlaceStore other = openOther(path, cell_size_);
  const PlaceMap theirs = withOther([&] { return other.map(); });
  return queue_.run([&] {
    const auto [next_id, next_session] = writer_.query(
        [](PlaceStore& store) { return std::make_pair(store.nextId(), store.nextSession()); });
    std::vector<MapEdit> edits = withOther([&, id = next_id, session = next_session] {
      return replacingEdits(theirs, other, id, session);
    });
    writer_.commit(
        std::move(edits), [&] { state_.whereabouts.forget(theirs.size() == 0); },
        "loaded " + std::to_string(theirs.size()) + " places of " + nameOf(path));
    return theirs.size();
  });
}

std::vector<MergeSighting> PlaceMemory::Impl::sightingsOf(const PlaceMap& theirs,
                                                          const PlaceStore& store) const {
  const Tuning tuned = tuning();
  std::vector<MergeSighting> sightings;
  for (const Place& place : theirs.places()) {
    const Scan scan = scanOf(place, store);
    std::optional<Recognition> found;
    while (!found) {
      const PlaceIndex snapshot = read([](const MemoryState& state) { return state.index; });
      found = tuned.recognizer->recognize(
          scan, snapshot,
          [this](const std::vector<PlaceId>& places) {
            return read([&](const MemoryState& state) { return framesOf(places, state.map); });
          },
          tuned.options.heading_window);
    }
    if (found->verdict != Verdict::kRecognized) continue;
    const PlaceMatch& match = found->matches.front();
    sightings.push_back({place.id, match.id, match.place_from_scan});
  }
  return sightings;
}

MergeReport PlaceMemory::Impl::merge(const std::string& path) {
  const PlaceStore other = openOther(path, cell_size_);
  const PlaceMap theirs = withOther([&] { return other.map(); });
  const auto sightings = withOther([&] { return sightingsOf(theirs, other); });
  return queue_.run([&] {
    const auto [next_id, next_session] = writer_.query(
        [](PlaceStore& store) { return std::make_pair(store.nextId(), store.nextSession()); });
    MergePlan plan = withOther([&, id = next_id, session = next_session] {
      return planMerge(state_.map, theirs, other, sightings, id, session);
    });
    writer_.commit(std::move(plan.edits), nullptr,
                   "merged " + std::to_string(plan.report.added) + " places of " + nameOf(path));
    return std::move(plan.report);
  });
}

std::vector<PastChange> PlaceMemory::Impl::history(std::size_t most) {
  return queue_.run(
      [&] { return writer_.query([&](PlaceStore& store) { return store.history(most); }); });
}

std::vector<PastChange> PlaceMemory::Impl::undo(std::size_t count) {
  return queue_.run([&] { return writer_.undo(count); });
}

void PlaceMemory::save(const std::string& path) const { impl_->save(path); }
std::size_t PlaceMemory::load(const std::string& path) { return impl_->load(path); }
MergeReport PlaceMemory::merge(const std::string& path) { return impl_->merge(path); }
std::vector<PastChange> PlaceMemory::history(std::size_t most) const {
  return impl_->history(most);
}
std::vector<PastChange> PlaceMemory::undo(std::size_t count) { return impl_->undo(count); }

}  // namespace place_memory::core
