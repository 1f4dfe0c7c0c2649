#include "mapping/drive_table.h"

#include <algorithm>
#include <cstddef>

#include "experiments/table.h"

namespace place_memory::mapping {
namespace {

using experiments::fixed;

std::string share(std::size_t part, std::size_t whole) {
  return whole == 0 ? "" : fixed(static_cast<double>(part) / static_cast<double>(whole), 3);
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

}  // namespace

const std::vector<std::string>& driveHeader() {
  static const std::vector<std::string> kHeader{
      "world",      "sonars", "way", "online", "final", "scale free", "places", "doubled",
      "false ties", "wrong",  "of",  "median", "99 %",  "revisits",   "ms by m"};
  return kHeader;
}

std::vector<std::string> driveRow(const std::string& world, const std::string& sonars,
                                  const MappingFigures& found) {
  return {world,
          sonars,
          fixed(found.way, 0),
          fixed(found.online, 3),
          fixed(found.final, 3),
          fixed(found.final_scale_free, 3),
          std::to_string(found.places),
          std::to_string(found.doubled),
          std::to_string(found.false_ties),
          std::to_string(found.wrong),
          std::to_string(found.answers),
          fixed(found.median(), 3),
          fixed(found.p99(), 3),
          share(found.known, found.again),
          fixed(found.cpu, 1)};
}

std::size_t sumOf(const std::vector<MappingFigures>& runs, std::size_t MappingFigures::*of) {
  std::size_t sum = 0;
  for (const MappingFigures& run : runs) sum += run.*of;
  return sum;
}

const std::vector<std::string>& sumsHeader() {
  static const std::vector<std::string> kHeader{
      "drives",     "way",   "online", "final",  "largest", "scale free", "places", "doubled",
      "false ties", "wrong", "of",     "median", "99 %",    "revisits",   "ms by m"};
  return kHeader;
}

std::vector<std::string> sumsRow(const std::string& drives,
                                 const std::vector<MappingFigures>& runs) {
  const auto count = static_cast<double>(runs.size());
  std::vector<double> errors;
  for (const MappingFigures& run : runs) {
    errors.insert(errors.end(), run.errors.begin(), run.errors.end());
  }
  std::sort(errors.begin(), errors.end());
  const auto quantile = [&](std::size_t percent) {
    return errors.empty() ? std::string() : fixed(errors[errors.size() * percent / 100], 3);
  };
  return {drives,
          fixed(mean(runs, &MappingFigures::way), 0),
          fixed(mean(runs, &MappingFigures::online), 2),
          fixed(mean(runs, &MappingFigures::final), 2),
          fixed(most(runs, &MappingFigures::final), 2),
          fixed(mean(runs, &MappingFigures::final_scale_free), 2),
          fixed(static_cast<double>(sumOf(runs, &MappingFigures::places)) / count, 0),
          std::to_string(sumOf(runs, &MappingFigures::doubled)),
          std::to_string(sumOf(runs, &MappingFigures::false_ties)),
          std::to_string(sumOf(runs, &MappingFigures::wrong)),
          std::to_string(sumOf(runs, &MappingFigures::answers)),
          quantile(50),
          quantile(99),
          share(sumOf(runs, &MappingFigures::known), sumOf(runs, &MappingFigures::again)),
          fixed(mean(runs, &MappingFigures::cpu), 1)};
}

}  // namespace place_memory::mapping
