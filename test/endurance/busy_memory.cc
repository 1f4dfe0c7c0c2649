#include "endurance/busy_memory.h"

#include <unistd.h>

#include <map>
#include <thread>
#include <variant>
#include <vector>

#include "endurance/busy_client.h"
#include "endurance/change_log.h"
#include "place_memory/core/place_memory.h"

namespace place_memory {
namespace {

using core::PlaceMemory;
using What = Said::What;

core::PlaceMemoryOptions optionsFor(const std::string& store) {
  core::PlaceMemoryOptions options;
  options.store_path = store;
  // Whatever fits best is recognized: the map is to change.
  options.recognizer.calibration.right = {20.0};
  options.recognizer.threads = 1;
  options.adaptation.enabled = true;
  return options;
}

MapRecord recordOf(const PlaceMemory& memory) {
  const core::MapSnapshot map = memory.map();
  MapRecord record;
  record.version = map.version;
  record.places = map.places;
  record.links = map.links;
  return record;
}

/// Says every change of the map.
class Teller {
 public:
  Teller(PlaceMemory& memory, ChangeLog& log) : memory_(memory), log_(log) {
    Said opened;
    opened.what = What::kOpened;
    opened.map = recordOf(memory);
    for (const core::Place& place : opened.map.places) {
      grids_[place.id] = hashOf(memory.grid(place.id));
    }
    opened.map.grids = grids_;
    log.say(opened);
    memory.listen([this](const core::MapChange& change) { tell(change); });
  }

 private:
  void tell(const core::MapChange& change) {
    for (const core::MapEdit& edit : change.edits) {
      if (const auto* added = std::get_if<core::PlaceAdded>(&edit)) {
        grids_[added->place.id] = hashOf(*added->grid);
      } else if (const auto* adapted = std::get_if<core::GridAdapted>(&edit)) {
        grids_[adapted->id] = hashOf(*adapted->grid);
      } else if (const auto* removed = std::get_if<core::PlaceRemoved>(&edit)) {
        grids_.erase(removed->id);
      } else if (std::holds_alternative<core::MapCleared>(edit)) {
        grids_.clear();
      }
    }
    Said changed;
    changed.what = What::kChanged;
    changed.map = recordOf(memory_);
    changed.map.grids = grids_;
    log_.say(changed);
  }

  PlaceMemory& memory_;
  ChangeLog& log_;
  std::map<core::PlaceId, std::uint64_t> grids_;
};

[[noreturn]] void failWith(ChangeLog& log, const std::string& reason) {
  Said failed;
  failed.what = What::kFailed;
  failed.text = reason;
  log.say(failed);
  _exit(1);
}

}  // namespace

void keepBusy(const BusyMemory& busy) {
  ChangeLog log(busy.log);
  try {
    PlaceMemory memory(optionsFor(busy.store));
    const core::StoreHealth health = memory.storeHealth();
    if (!health.ok) failWith(log, health.problem);
    if (!health.set_aside.empty()) failWith(log, health.set_aside.front());
    const Teller teller(memory, log);
    std::vector<std::thread> threads;
    for (unsigned client = 0; client < busy.clients; ++client) {
      threads.emplace_back([&, client] { BusyClient(memory, log, client, busy).work(); });
    }
    for (std::thread& thread : threads) thread.join();
  } catch (const std::exception& error) {
    failWith(log, error.what());
  }
  failWith(log, "the clients have come to an end");
}

}  // namespace place_memory
