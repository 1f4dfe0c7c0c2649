#include <cmath>
#include <filesystem>
#include <sstream>

#include "config/load_parameters.h"
#include "config/store_directory.h"
#include "config/yaml_file.h"
#include "core/map/place_label.h"
#include "core/store/packed_readings.h"
#include "core/temporary_folder.h"
#include "fuzz/targets.h"
#include "place_memory/config/match_preset.h"
#include "support/csv.h"
#include "support/text.h"
#include "tools/event_table.h"

namespace place_memory::fuzz {

void runParameters(const std::uint8_t* bytes, std::size_t size) {
  try {
    const config::Parameters parameters =
        config::parseParameters(config::loadYamlText(asText(bytes, size), "input"), "input");
    require(!parameters.sonar_topics.empty(), "no topic of sonars");
    require(parameters.grid.cell_size >= 0.001 && parameters.grid.cell_size <= 100.0, "the cells");
    require(!support::hasControls(parameters.base_frame + parameters.map_frame), "a frame's name");
  } catch (const config::ParameterError& error) {
    require(!error.problems().empty(), "refused without a reason");
  }
}

void runPreset(const std::uint8_t* bytes, std::size_t size) {
  try {
    const config::MatchPreset preset = config::loadPreset(fileOf(bytes, size, ".yaml"));
    require(preset.calibration.scale > 0.0 && std::isfinite(preset.calibration.scale), "a scale");
  } catch (const config::ParameterError& error) {
    require(!error.problems().empty(), "refused without a reason");
  }
}

void runEvents(const std::uint8_t* bytes, std::size_t size) {
  std::istringstream table(asText(bytes, size));
  try {
    for (const tools::Event& event : tools::readEvents(table, "input", 0.5, ros::Time(1000))) {
      require(event.end >= event.start, "an event ends before it begins");
      require(event.heading_window >= 0.0 && event.heading_window <= core::kPi, "a window");
      require(event.label.empty() || core::isValidLabel(event.label), "a label that is none");
    }
  } catch (const std::runtime_error& error) {
    // Of what is no text at all there is no line.
    const std::string what = error.what();
    require(what.find("input, line ") == 0 || what.find("text") != std::string::npos,
            "refused without a line");
  }
}

// A folder with a link out of it.
void runPaths(const std::uint8_t* bytes, std::size_t size) {
  static const TemporaryFolder folder;
  static const std::string inside = std::filesystem::canonical(folder.path()).string() + "/maps";
  if (std::filesystem::create_directories(inside)) {
    std::filesystem::create_symlink("/etc", inside + "/out");
  }
  try {
    const std::string path = config::pathInside(inside, asText(bytes, size));
    require(path.rfind(inside + "/", 0) == 0, "a path outside of the folder");
    require(path.find("/../") == std::string::npos, "a path that leads upwards");
  } catch (const std::invalid_argument& error) {
    require(std::string(error.what()).size() < 4000, "an answer that has no end");
  }
}

void runText(const std::uint8_t* bytes, std::size_t size) {
  const std::string text = asText(bytes, size);
  if (core::isValidLabel(text)) {
    require(!support::firstNotUtf8(text) && !support::hasControls(text), "a label of other bytes");
    require(!support::trimmed(text).empty(), "a blank label");
  }
  const std::string shown = support::printable(text);
  require(!support::firstNotUtf8(shown) && !support::hasControls(shown), "what cannot be printed");
  try {
    require(!support::firstNotUtf8(support::decodedText(text)), "a text of other bytes");
  } catch (const std::runtime_error&) {
  }
  support::parseDecimal(text);
  support::withoutLeadingSlashes(text);
  std::istringstream input(text);
  int line = 0;
  try {
    while (const auto record = support::readRecord(input, line)) {
      for (const std::string& field : *record) support::csvField(field);
    }
  } catch (const std::runtime_error&) {
  }
  if (const auto readings = core::unpackReadings(bytes, size)) {
    for (const core::SonarReading& reading : *readings) {
      require(reading.sensor_pose.isFinite() && reading.range >= 0.0, "a reading of no sense");
    }
  }
}

}  // namespace place_memory::fuzz
