#include <algorithm>
#include <filesystem>
#include <string>

#include "core/store/place_store.h"
#include "fuzz/targets.h"

namespace place_memory::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr char kJournal[] = "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7";

void readAll(const core::PlaceStore& store) {
  const core::PlaceMap map = store.map();
  for (const core::Place& place : map.places()) {
    require(place.map_from_place.isFinite() && !place.label.empty(), "a place of no sense");
    require(place.id < store.nextId(), "an id that will be given again");
    try {
      store.grid(place.id);
      store.readings(place.id);
    } catch (const core::StoreError&) {
    }
  }
  std::size_t planes = 0;
  store.forEachPlanes([&](core::PlaceId id, const core::CellPlanes& /*planes*/) {
    require(map.find(id) != nullptr, "planes of no place");
    ++planes;
  });
  require(planes <= map.size(), "planes of no place");
  for (const core::ScanNode& node : store.scans().nodes) {
    require(node.pose.isFinite(), "a scan's pose that is not finite");
  }
}

void change(core::PlaceStore& store) {
  core::MapChange change;
  change.version = store.map().version() + 1;
  core::PlaceAdded added;
  added.place.id = store.nextId();
  added.place.label = "new";
  added.grid = std::make_shared<core::EvidenceGrid>(core::GridGeometry{});
  change.edits = {added};
  store.commit(change);
}

}  // namespace

// A file, and after it its journal if there is one.
void runStore(const std::uint8_t* bytes, std::size_t size) {
  const std::uint8_t* const end = bytes + size;
  const std::uint8_t* const journal = std::search(bytes, end, kJournal, kJournal + 8);
  const std::string path = fileOf(bytes, static_cast<std::size_t>(journal - bytes), ".db");
  const std::string journal_path = path + "-journal";
  fs::remove(journal_path);
  if (journal != end) {
    const auto length = static_cast<std::size_t>(end - journal);
    fs::rename(fileOf(journal, length, ".journal"), journal_path);
  }
  try {
    core::PlaceStore store(path, core::kDefaultCellSize);
    readAll(store);
    change(store);
  } catch (const core::StoreError& error) {
    require(std::string(error.what()).find(path) != std::string::npos, "refused without the file");
  }
  // What a migration keeps.
  for (const char* const kept : {".format-1", ".format-2", ".format-3"}) fs::remove(path + kept);
}

}  // namespace place_memory::fuzz
