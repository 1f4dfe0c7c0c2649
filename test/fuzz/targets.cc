#include "fuzz/targets.h"

#include "core/temporary_folder.h"

namespace place_memory::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> targets{
      {"messages", runMessages}, {"parameters", runParameters}, {"preset", runPreset},
      {"events", runEvents},     {"world", runWorld},           {"episodes", runEpisodes},
      {"drive", runDrive},       {"store", runStore},           {"text", runText},
      {"mapper", runMapper},     {"memory", runMemory},         {"edits", runEdits},
      {"paths", runPaths},       {"goals", runGoals},
  };
  return targets;
}

std::string fileOf(const std::uint8_t* bytes, std::size_t size, const std::string& ending) {
  static const TemporaryFolder folder;
  const std::string path = folder.file("input" + ending);
  writeFile(path, asText(bytes, size));
  return path;
}

}  // namespace place_memory::fuzz
