#include <stdexcept>

#include "fuzz/targets.h"
#include "sim/scene/world_loader.h"
#include "trials/drive_file.h"
#include "trials/episode_file.h"

namespace place_memory::fuzz {

void runWorld(const std::uint8_t* bytes, std::size_t size) {
  try {
    const sim::World world = sim::parseWorld(asText(bytes, size), "input");
    sim::validateWorld(world, sim::kPlaceClearance);
  } catch (const sim::WorldError& error) {
    require(std::string(error.what()).find("input") == 0, "refused without the file");
  }
}

void runEpisodes(const std::uint8_t* bytes, std::size_t size) {
  try {
    const trials::TrialSet set = trials::readEpisodeFile(fileOf(bytes, size, ".jsonl"));
    require(!set.learned.empty() && !set.trials.empty(), "a set without trials");
    for (const trials::LearnedScan& scan : set.learned) {
      require(!scan.label.empty() && !scan.readings.empty(), "a place without a scan");
      for (const core::SonarReading& reading : scan.readings) {
        require(reading.sensor_pose.isFinite() && reading.range >= 0.0, "a reading of no sense");
      }
    }
  } catch (const std::runtime_error& error) {
    require(std::string(error.what()).find(".jsonl:") != std::string::npos,
            "refused without a line");
  }
}

void runDrive(const std::uint8_t* bytes, std::size_t size) {
  try {
    for (const trials::DriveMoment& moment : trials::readDriveFile(fileOf(bytes, size, ".drive"))) {
      require(moment.odom.isFinite(), "odometry that is not finite");
      for (const core::SonarReading& reading : moment.readings) {
        require(reading.sensor_pose.isFinite() && reading.range >= 0.0, "a reading of no sense");
      }
    }
  } catch (const std::runtime_error& error) {
    require(std::string(error.what()).find(".drive") != std::string::npos,
            "refused without a line");
  }
}

}  // namespace place_memory::fuzz
