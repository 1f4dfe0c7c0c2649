// Recorded drives, whole and in halves, with odometry that errs.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

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

double mean(const std::vector<MappingFigures>& runs, double MappingFigures::*of) {
  double sum = 0.0;
  for (const MappingFigures& run : runs) sum += run.*of;
  return sum / static_cast<double>(runs.size());
}

double most(const std::vector<MappingFigures>& runs, double MappingFigures::*of) {
  double most = 0.0;
  for (const MappingFigures& run : runs) most = std::max(most, run.*of);
  return most;
}

std::size_t sum(const std::vector<MappingFigures>& runs, std::size_t MappingFigures::*of) {
  std::size_t sum = 0;
  for (const MappingFigures& run : runs) sum += run.*of;
  return sum;
}

std::vector<std::string> row(const std::string& name, const std::vector<MappingFigures>& runs) {
  const auto count = static_cast<double>(runs.size());
  const auto share = [&](std::size_t part, std::size_t whole) {
    return whole == 0 ? std::string()
                      : fixed(static_cast<double>(part) / static_cast<double>(whole), 3);
  };
  std::vector<double> errors;
  for (const MappingFigures& run : runs) {
    errors.insert(errors.end(), run.errors.begin(), run.errors.end());
  }
  std::sort(errors.begin(), errors.end());
  const auto quantile = [&](std::size_t percent) {
    return errors.empty() ? std::string() : fixed(errors[errors.size() * percent / 100], 3);
  };
  return {name,
          fixed(mean(runs, &MappingFigures::way), 0),
          fixed(mean(runs, &MappingFigures::online), 2),
          fixed(mean(runs, &MappingFigures::final), 2),
          fixed(most(runs, &MappingFigures::final), 2),
          fixed(mean(runs, &MappingFigures::final_scale_free), 2),
          fixed(static_cast<double>(sum(runs, &MappingFigures::places)) / count, 0),
          std::to_string(sum(runs, &MappingFigures::doubled)),
          std::to_string(sum(runs, &MappingFigures::false_ties)),
          std::to_string(sum(runs, &MappingFigures::wrong)),
          std::to_string(sum(runs, &MappingFigures::answers)),
          quantile(50),
          quantile(99),
          share(sum(runs, &MappingFigures::known), sum(runs, &MappingFigures::again)),
          fixed(mean(runs, &MappingFigures::cpu), 1)};
}

DrivePart wholeOf(const SuiteOptions& options) {
  DrivePart part;
  part.compass = options.compass;
  return part;
}

}  // namespace

experiments::Table recordedSuite(const SuiteOptions& options) {
  experiments::Table table({"drive", "way", "online", "final", "largest", "scale free", "places",
                            "doubled", "false ties", "wrong", "of", "median", "99 %", "revisits",
                            "ms by m"});
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
    table.add(row(nameOf(options.drives[i]), runs));
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
                 std::to_string(sum(runs, &MappingFigures::wrong)),
                 std::to_string(sum(runs, &MappingFigures::answers))});
    }
  }
  return table;
}

}  // namespace place_memory::mapping
