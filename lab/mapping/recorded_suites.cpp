// Recorded drives, whole and in halves, with odometry that errs.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "mapping/drive_table.h"
#include "mapping/join_offset.h"
#include "mapping/mapping_figures.h"
#include "mapping/suites.h"

namespace place_memory::mapping {
namespace {

using experiments::fixed;

constexpr double kLaterStart = 100000.0;  // of second sessions [s]

std::vector<trials::Drive> readDrives(const SuiteOptions& options) {
  if (options.drives.empty()) throw std::runtime_error("no --drive is given");
  std::vector<trials::Drive> drives;
  for (const std::string& path : options.drives) {
    drives.push_back(trials::readDriveFile(path));
    for (const trials::DriveMoment& moment : drives.back()) {
      if (!moment.truth) throw std::runtime_error(path + " does not know the truth of a moment");
    }
  }
  return drives;
}

/// Without folders and endings.
std::string nameOf(const std::string& path) {
  const std::string file = path.substr(path.find_last_of('/') + 1);
  return file.substr(0, file.find('.'));
}

DrivePart wholeOf(const SuiteOptions& options) {
  DrivePart part;
  part.compass = options.compass;
  return part;
}

}  // namespace

experiments::Table recordedSuite(const SuiteOptions& options) {
  experiments::Table table(sumsHeader());
  const std::vector<trials::Drive> drives = readDrives(options);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    std::vector<MappingFigures> runs;
    for (int k = 0; k < options.seeds; ++k) {
      const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(k);
      core::Mapper mapper(mapperOptions());
      Truth truth;
      const MappingRun run = drive(mapper, trials::withErrors(drives[i], recipeOf(options), seed),
                                   wholeOf(options), truth);
      runs.push_back(figures(mapper, run, truth));
    }
    table.add(sumsRow(nameOf(options.drives[i]), runs));
  }
  return table;
}

experiments::Table halvesSuite(const SuiteOptions& options) {
  experiments::Table table(
      {"first half of", "second half of", "sessions", "joined", "largest offset", "wrong", "of"});
  const std::vector<trials::Drive> drives = readDrives(options);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    for (const std::size_t later : {i, (i + 1) % drives.size()}) {
      std::size_t joined = 0;
      double offset = 0.0;
      std::vector<MappingFigures> runs;
      for (int k = 0; k < options.seeds; ++k) {
        const std::uint64_t seed = options.first_seed + static_cast<std::uint64_t>(k);
        core::Mapper mapper(mapperOptions());
        Truth truth;
        DrivePart part = wholeOf(options);
        part.last = drives[i].size() / 2;
        drive(mapper, trials::withErrors(drives[i], recipeOf(options), seed), part, truth);
        mapper.beginSession();
        part.first = drives[later].size() / 2;
        part.last = drives[later].size();
        part.start = kLaterStart;
        const MappingRun run = drive(
            mapper, trials::withErrors(drives[later], recipeOf(options), seed + 1000), part, truth);
        joined += mapper.mapFromOdom() ? 1 : 0;
        offset = std::max(offset, joinOffset(mapper, run, truth));
        runs.push_back(figures(mapper, run, truth));
      }
      table.add({nameOf(options.drives[i]), later == i ? "the same" : nameOf(options.drives[later]),
                 std::to_string(runs.size()), std::to_string(joined),
                 later == i && joined > 0 ? fixed(offset, 2) : "",
                 std::to_string(sumOf(runs, &MappingFigures::wrong)),
                 std::to_string(sumOf(runs, &MappingFigures::answers))});
    }
  }
  return table;
}

}  // namespace place_memory::mapping
