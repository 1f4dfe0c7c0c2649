#ifndef PLACE_MEMORY_TOOLS_STORE_SOURCE_H
#define PLACE_MEMORY_TOOLS_STORE_SOURCE_H

#include <memory>
#include <string>
#include <vector>

#include "config/parameters.h"
#include "core/store/place_store.h"
#include "tools/map_source.h"

namespace place_memory::tools {

/// The map in a file that no node has open.
class StoreSource : public MapSource {
 public:
  /// Throws CommandError where there is no such file, and core::StoreError.
  StoreSource(const std::string& path, const config::Parameters& parameters);

  /// What is damaged and was left out, a sentence each.
  std::vector<std::string> setAside() const { return memory_.storeHealth().set_aside; }

  core::MapSnapshot map() override { return memory_.map(); }
  core::EvidenceGrid grid(core::PlaceId id) override { return memory_.grid(id); }
  std::string learn(const std::string& label, const ScanChoice& scan) override;
  std::string exportTo(const std::string& folder) override;
  std::string merge(const std::string& path, std::vector<std::string>& collisions) override;
  PlannedRoute plan(const std::string& from, const std::string& to) override;
  Recognized recognize(const ScanChoice& scan) override;
  DrivenGoal go(const std::string& label, const Progress& progress) override;
  std::vector<core::PastChange> history(std::size_t count) override {
    return memory_.history(count);
  }
  std::vector<core::PastChange> undo(std::size_t count) override { return memory_.undo(count); }

 private:
  core::Scan scanOf(const ScanChoice& choice);

  std::string path_;
  config::Parameters parameters_;
  core::PlaceMemory memory_;
};

/// What is wrong with the file, a sentence each; none: every row is as it was written. Throws
/// CommandError where there is no such file, or one that has to be brought to this version first,
/// and core::StoreError where it cannot be used at all.
std::vector<std::string> checkStore(const std::string& path, const config::Parameters& parameters);

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_STORE_SOURCE_H
