#include "layers/table.h"

#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "layers/include_reader.h"

namespace place_memory::layers {
namespace {

namespace fs = std::filesystem;
using Parts = std::set<std::string>;

/// Public headers of the core lie in one folder: where each belongs. A new one needs a line here.
const std::map<std::string, std::string> kPublicHeaders{
    {"place_memory/core/pose2d.h", "core/geometry"},
    {"place_memory/core/adaptation_options.h", "core/grid"},
    {"place_memory/core/evidence_grid.h", "core/grid"},
    {"place_memory/core/grid_geometry.h", "core/grid"},
    {"place_memory/core/sonar_reading.h", "core/reading"},
    {"place_memory/core/scan.h", "core/sensing"},
    {"place_memory/core/sonar_model.h", "core/sensing"},
    {"place_memory/core/place_id.h", "core/place_id"},
    {"place_memory/core/link_learning.h", "core/map"},
    {"place_memory/core/map_change.h", "core/map"},
    {"place_memory/core/place.h", "core/map"},
    {"place_memory/core/place_map.h", "core/map"},
    {"place_memory/core/match_metric.h", "core/match"},
    {"place_memory/core/search_method.h", "core/match"},
    {"place_memory/core/calibration.h", "core/recognize"},
    {"place_memory/core/recognition.h", "core/recognize"},
    {"place_memory/core/recognizer_options.h", "core/recognize"},
    {"place_memory/core/rescoring_weights.h", "core/recognize"},
    {"place_memory/core/routes.h", "core/route"},
    {"place_memory/core/store_opening.h", "core/store"},
    {"place_memory/core/place_memory.h", "core/memory"},
    {"place_memory/core/whereabouts.h", "core/memory"},
    {"place_memory/config/match_preset.h", "config"},
    {"place_memory/config/parameter_error.h", "config"},
    {"place_memory/export.h", "support"},
};

/// What each part may include: these, and what these may. `place_id` and `reading` are single
/// headers, of a place's number and of one measurement, which say nothing of where they are kept.
const std::map<std::string, Parts> kMayUse{
    {"support", {"boost", "yaml-cpp"}},

    {"core", {"support", "eigen", "sqlite", "boost", "intrinsics"}},  // every group of it
    {"core/geometry", {"core"}},
    {"core/place_id", {"core"}},
    {"core/reading", {"core/geometry"}},
    {"core/grid", {"core/geometry"}},
    {"core/sensing", {"core/grid", "core/reading"}},
    {"core/kernels", {"core/grid"}},
    {"core/map", {"core/grid", "core/place_id", "core/reading"}},
    {"core/index", {"core/kernels", "core/place_id"}},
    {"core/match", {"core/index", "core/kernels"}},
    {"core/recognize", {"core/match", "core/sensing"}},
    {"core/mapping", {"core/recognize", "core/map"}},
    {"core/route", {"core/map"}},
    {"core/drive", {"core/route", "core/sensing"}},
    {"core/store", {"core/map", "core/grid"}},
    {"core/explore", {"core/mapping"}},
    {"core/views", {"core/recognize", "core/route"}},
    {"core/memory", {"core/drive", "core/explore", "core/store", "core/views"}},

    {"config", {"core/memory", "yaml-cpp"}},

    {"sim", {"core/memory", "yaml-cpp"}},  // every folder of it
    {"sim/world", {"sim"}},
    {"sim/scene", {"sim/world"}},
    {"sim/building", {"sim/scene"}},
    {"sim/senses", {"sim/scene"}},
    {"sim/robot", {"sim/building", "sim/senses"}},
    {"sim_node", {"sim/robot", "node"}},

    {"node/names", {}},  // of a robot and of whoever talks to it
    {"node/base", {"config", "node/names", "ros"}},
    {"node/input", {"node/base"}},
    {"node/scan", {"node/input"}},
    {"node/answer", {"node"}},
    {"node/map", {"node"}},
    {"node/drive", {"node/scan"}},
    {"node/go", {"node/drive"}},
    {"node",
     {"config", "ros", "node/input", "node/scan", "node/answer", "node/map", "node/drive",
      "node/go"}},

    {"picture", {"core/memory", "boost", "cairo"}},
    {"tools", {"config", "picture", "ros", "node/input", "node/scan", "node/drive"}},
    {"rviz", {"support", "node/names", "ros", "qt", "boost"}},

    {"lab", {"config", "picture", "sim/robot", "json"}},  // every folder of it
    {"lab/trials", {"lab"}},
    {"lab/training", {"lab/trials"}},
    {"lab/experiments", {"lab/trials"}},
    {"lab/benchmark", {"lab/trials", "google_benchmark"}},
    {"lab/mapping", {"lab/experiments"}},
    {"lab/reports", {"lab/mapping"}},
    {"lab/routes", {"lab/mapping"}},
};

/// Single files that may use more than their part, and why.
const std::map<std::string, Parts> kExceptions{
    {"lab/benchmark/live_client.cpp", {"ros"}},  // measures a live node over its service
};

struct Rule {
  std::regex pattern;
  std::string part;  ///< may refer to the pattern's groups
};

const std::vector<Rule>& headerRules() {
  static const std::vector<Rule> rules{
      {std::regex("(core|sim|node)/([a-z0-9_]+)/[a-z0-9_]+\\.h"), "$1/$2"},
      {std::regex("(config|picture|sim_node|node|support|tools)/[a-z0-9_]+\\.h"), "$1"},
      {std::regex("(trials|training|experiments|mapping|reports|routes)/[a-z0-9_]+\\.h"), "lab/$1"},
      {std::regex("benchmark/benchmark\\.h"), "google_benchmark"},
      {std::regex("benchmark/[a-z0-9_]+\\.h"), "lab/benchmark"},
      {std::regex("embedded_presets\\.h"), "config"},  // generated
      {std::regex("Eigen/.+"), "eigen"},
      {std::regex("boost/.+"), "boost"},
      {std::regex("yaml-cpp/.+"), "yaml-cpp"},
      {std::regex("nlohmann/.+"), "json"},
      {std::regex("sqlite3\\.h"), "sqlite"},
      {std::regex("cairo/cairo\\.h"), "cairo"},
      {std::regex("immintrin\\.h|arm_neon\\.h"), "intrinsics"},
      {std::regex("Q[A-Za-z]+"), "qt"},
      {std::regex("[a-z_]+|(fcntl|malloc|unistd|pthread|sched|signal|sys/[a-z]+)\\.h"), "std"},
  };
  return rules;
}

void addAll(const std::string& part, Parts& reached) {
  if (!reached.insert(part).second) return;
  const auto found = kMayUse.find(part);
  if (found == kMayUse.end()) return;
  for (const std::string& used : found->second) addAll(used, reached);
}

}  // namespace

std::optional<std::string> partOfFile(const std::string& file) {
  static const std::regex in_group("src/(core|sim|node)/([a-z0-9_]+)/.+");
  static const std::regex in_layer("src/(config|node|picture|rviz|sim_node|support|tools)/.+");
  static const std::regex in_lab("(lab/[a-z]+)/.+");
  std::smatch match;
  if (file.rfind("include/", 0) == 0)
    return partOfHeader(file.substr(std::string("include/").size()));
  if (std::regex_match(file, match, in_group)) return match[1].str() + "/" + match[2].str();
  if (std::regex_match(file, match, in_layer)) return match[1].str();
  if (std::regex_match(file, match, in_lab)) return match[1].str();
  return std::nullopt;
}

std::string partOfHeader(const std::string& header) {
  const auto found = kPublicHeaders.find(header);
  if (found != kPublicHeaders.end()) return found->second;
  for (const Rule& rule : headerRules()) {
    std::smatch match;
    if (std::regex_match(header, match, rule.pattern)) return match.format(rule.part);
  }
  return "ros";
}

bool mayInclude(const std::string& from, const std::string& to) {
  if (to == "std") return true;
  Parts reached;
  addAll(from, reached);
  return reached.count(to) == 1;
}

std::vector<std::string> violations(const std::string& file,
                                    const std::vector<std::string>& headers) {
  const auto part = partOfFile(file);
  if (!part || kMayUse.count(*part) == 0) return {file + " lies in no folder of the table"};
  std::vector<std::string> found;
  for (const std::string& header : headers) {
    if (fs::exists((kRoot / file).parent_path() / header)) continue;  // a private one beside it
    const std::string used = partOfHeader(header);
    const auto exception = kExceptions.find(file);
    const bool excepted = exception != kExceptions.end() && exception->second.count(used) == 1;
    if (excepted || mayInclude(*part, used)) continue;
    found.push_back(file + " (" + *part + ") includes " + header + " (" + used + ")");
  }
  return found;
}

}  // namespace place_memory::layers
