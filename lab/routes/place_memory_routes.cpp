// Drives simulated robots through buildings whose doors open and close, and says how well routes
// that learn do beside oracles.

#include <algorithm>
#include <boost/program_options.hpp>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <vector>

#include "routes/month.h"

namespace place_memory::routes {
namespace {

namespace po = boost::program_options;

double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

void months(std::uint64_t seeds, const core::LinkLearningOptions& options) {
  std::cout << "| seed | learned after [days] | errands | beside an oracle that knows the odds | "
               "beside one that sees every door | shortest ways beside the odds' oracle | blocked "
               "per errand | reached |\n|---|---|---|---|---|---|---|---|\n";
  double all = 0.0, worst = 0.0, all_odds = 0.0, all_doors = 0.0, all_times = 0.0;
  std::size_t reached = 0, errands = 0, blocked = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const MonthResult month = runMonth(seed, options);
    const Errands& ours = month.learning;
    const std::size_t count = ours.reached + ours.not_reached;
    std::cout << "| " << seed << " | " << month.learned_after << " | " << count << " | "
              << share(ours.time, month.odds.time) << " | " << share(ours.time, month.doors.time)
              << " | " << share(month.times.time, month.odds.time) << " | "
              << share(static_cast<double>(ours.blocked), static_cast<double>(count)) << " | "
              << ours.reached << " |\n";
    worst = std::max(worst, share(ours.time, month.odds.time));
    all += ours.time;
    all_odds += month.odds.time;
    all_doors += month.doors.time;
    all_times += month.times.time;
    reached += ours.reached;
    errands += count;
    blocked += ours.blocked;
  }
  std::cout << "| all | | " << errands << " | " << share(all, all_odds) << " (worst " << worst
            << ") | " << share(all, all_doors) << " | " << share(all_times, all_odds) << " | "
            << share(static_cast<double>(blocked), static_cast<double>(errands)) << " | " << reached
            << " |\n\n";
}

void spells(std::uint64_t seeds, const core::LinkLearningOptions& options) {
  std::vector<double> days;
  std::size_t never = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const std::optional<double> back = daysToReturn(seed, options);
    if (back) days.push_back(*back);
    if (!back) ++never;
  }
  std::sort(days.begin(), days.end());
  std::cout << "| a busy door, closed for ten days, is used again after [days] | |\n|---|---|\n";
  if (!days.empty()) {
    std::cout << "| median | " << days[days.size() / 2] << " |\n| longest | " << days.back()
              << " |\n";
  }
  std::cout << "| never | " << never << " of " << seeds << " |\n\n";
}

void quiet(std::uint64_t seeds, const core::LinkLearningOptions& options) {
  double worst = 0.0, mean = 0.0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Detours longer = detours(seed, options);
    worst = std::max(worst, longer.worst);
    mean += longer.mean / static_cast<double>(seeds);
  }
  std::cout << "| where nothing closes, longer than the shortest way | |\n|---|---|\n| worst | "
            << 100.0 * worst << " % |\n| mean | " << 100.0 * mean << " % |\n";
}

int run(const po::variables_map& given) {
  core::LinkLearningOptions options;
  options.half_life = given["half-life"].as<double>();
  const auto seeds = given["seeds"].as<std::uint64_t>();
  std::cout << std::setprecision(4);
  months(seeds, options);
  spells(seeds, options);
  quiet(seeds, options);
  return EXIT_SUCCESS;
}

}  // namespace
}  // namespace place_memory::routes

int main(int argc, char** argv) {
  namespace po = boost::program_options;
  try {
    po::options_description options("usage: place_memory_routes");
    options.add_options()("help", "show this")(
        "seeds", po::value<std::uint64_t>()->default_value(20), "buildings, at least 1")(
        "half-life", po::value<double>()->default_value(172800.0), "of evidence [s]");
    po::variables_map given;
    po::store(po::parse_command_line(argc, argv, options), given);
    if (given.count("help") > 0) {
      std::cout << options;
      return EXIT_SUCCESS;
    }
    return place_memory::routes::run(given);
  } catch (const std::exception& error) {
    std::cerr << "place_memory_routes: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
