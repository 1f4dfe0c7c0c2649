#ifndef PLACE_MEMORY_TOOLS_NODE_SOURCE_H
#define PLACE_MEMORY_TOOLS_NODE_SOURCE_H

#include <memory>
#include <string>
#include <vector>

#include "tools/map_source.h"

namespace ros {
class NodeHandle;
}

namespace place_memory::tools {

/// The map of a node that runs, by its services.
class NodeSource : public MapSource {
 public:
  /// Throws CommandError where there is no master, or no such node.
  explicit NodeSource(const std::string& name);
  ~NodeSource() override;

  core::MapSnapshot map() override;
  core::EvidenceGrid grid(core::PlaceId id) override;
  std::string learn(const std::string& label, const ScanChoice& scan) override;
  std::string exportTo(const std::string& folder) override;
  std::string merge(const std::string& path, std::vector<std::string>& collisions) override;
  PlannedRoute plan(const std::string& from, const std::string& to) override;
  Recognized recognize(const ScanChoice& scan) override;
  DrivenGoal go(const std::string& label, const Progress& progress) override;
  std::vector<core::PastChange> history(std::size_t count) override;
  std::vector<core::PastChange> undo(std::size_t count) override;

 private:
  /// Whatever the answer is.
  template <class Service>
  typename Service::Response ask(const char* service, const typename Service::Request& request);
  /// The answer says that it was done; otherwise its message is thrown.
  template <class Service>
  typename Service::Response call(const char* service, const typename Service::Request& request);
  void scan();
  std::vector<core::PastChange> undo(std::size_t count, bool look);

  std::string name_;
  std::unique_ptr<ros::NodeHandle> ros_;
};

}  // namespace place_memory::tools

#endif  // PLACE_MEMORY_TOOLS_NODE_SOURCE_H
