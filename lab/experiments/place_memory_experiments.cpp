// Runs the paper's experiments and the studies beside them on simulated worlds.
#include <algorithm>
#include <boost/program_options.hpp>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>

#include "experiments/answer_table.h"
#include "experiments/belief_drive.h"
#include "experiments/figures.h"
#include "experiments/rearrangements.h"
#include "experiments/runner.h"
#include "experiments/summary_table.h"
#include "support/progress_bar.h"
#include "trials/episode_file.h"

namespace place_memory::experiments {
namespace {

struct Arguments {
  std::string out;
  std::string worlds;
  std::vector<std::string> experiments;
  std::vector<std::string> sweeps;
  std::vector<std::string> methods;
  std::vector<std::string> params;
  std::string preset;
  std::vector<std::string> recorded;
  std::size_t rearrangements = 0;
  bool figures = false;
  bool sparse = false;
  RunOptions run;
};

/// Words between commas; `all` stands for `everything`, `none` for nothing.
std::vector<std::string> words(const std::string& text,
                               const std::vector<std::string>& everything) {
  if (text == "all") return everything;
  std::vector<std::string> found;
  if (text == "none") return found;
  std::istringstream input(text);
  for (std::string word; std::getline(input, word, ',');) {
    if (!everything.empty() &&
        std::find(everything.begin(), everything.end(), word) == everything.end()) {
      throw std::runtime_error("'" + word + "' is not one of those to choose from");
    }
    found.push_back(word);
  }
  return found;
}

void requireWithin(const std::string& name, std::size_t value, std::size_t least,
                   std::size_t most) {
  if (value >= least && value <= most) return;
  throw std::runtime_error("--" + name + " must lie in " + std::to_string(least) + " to " +
                           std::to_string(most));
}

// Nothing where help was asked for, which is then printed.
std::optional<Arguments> readArguments(int argc, char** argv) {
  namespace po = boost::program_options;
  const std::vector<std::string> all_experiments = {"1", "2",        "3",        "4",
                                                    "5", "put_back", "buildings"};
  Arguments arguments;
  RunOptions& run = arguments.run;
  std::string experiments;
  std::string sweeps;
  std::string methods;
  po::options_description options("Options");
  auto add = options.add_options();
  add("help,h", "show this text");
  add("out", po::value(&arguments.out)->required(),
      "folder to write to; made where it is not there");
  add("worlds", po::value(&arguments.worlds)->default_value("config/worlds"),
      "folder of rooms.yaml, office.yaml and hallway.yaml");
  add("experiments", po::value(&experiments)->default_value("all"),
      "all, none, or of 1,2,3,4,5,put_back,buildings");
  add("sweeps", po::value(&sweeps)->default_value("none"),
      "all, none, or of chairs,shift,heading_error,cell_size,places,sonars,readings_lost");
  add("methods", po::value(&methods)->default_value("all"),
      "of --experiments and --recorded: all, or of "
      "nearest_neighbour,hill_climbing,hill_climbing_restarts,default,"
      "default_single_climb,default_exhaustive,hill_climbing_laser,default_laser");
  add("recorded", po::value(&arguments.recorded)->composing(),
      "recorded scans, JSON lines, .gz or not: one more row each. Of several, each is of another "
      "building: what one learns are strangers to the one before");
  add("rearrangements", po::value(&arguments.rearrangements)->default_value(0),
      "rearrange the office so many times over, with places that adapt and without");
  add("sparse", po::bool_switch(&arguments.sparse),
      "put scans with little to go by to the default method: open spaces, halls, dead rings, wrong "
      "units, few sensors");
  add("figures", po::bool_switch(&arguments.figures), "write the grids and maps of the figures");
  add("seeds", po::value(&run.seeds)->default_value(run.seeds), "simulated worlds of each row");
  add("first-seed", po::value(&run.first_seed)->default_value(run.first_seed),
      "fitting uses those below 1000");
  add("slow-seeds", po::value(&run.slow_seeds)->default_value(run.slow_seeds),
      "how many of them exhaustive search is run on");
  add("threads", po::value(&run.threads)->default_value(run.threads),
      "results do not depend on it");
  add("params", po::value(&arguments.params)->composing(),
      "parameters of every method, laid out as config/place_memory.yaml; the paper's keep their "
      "preset and search. Cell size and heading window are those of the trials. Where several "
      "files give a parameter, the last holds");
  add("preset", po::value(&arguments.preset),
      "match/preset of the default method: evidence, paper or a file");
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(options).run(), given);
  if (given.count("help") > 0) {
    std::cout << "usage: place_memory_experiments --out DIR [OPTION]...\n\n" << options;
    return std::nullopt;
  }
  po::notify(given);
  // Boost takes -1 for the largest number there is.
  requireWithin("seeds", run.seeds, 1, 100000);
  requireWithin("slow-seeds", run.slow_seeds, 0, 100000);
  requireWithin("threads", run.threads, 1, 256);
  requireWithin("rearrangements", arguments.rearrangements, 0, 1000);
  arguments.experiments = words(experiments, all_experiments);
  arguments.sweeps = words(sweeps, sweepNames());
  if (methods != "all") arguments.methods = words(methods, {});
  return arguments;
}

std::vector<Experiment> chosenExperiments(const Arguments& arguments, const ShippedWorlds& worlds) {
  std::vector<Experiment> available = paperExperiments(worlds);
  const std::vector<Experiment> put_back = putBackExperiments(worlds);
  available.insert(available.end(), put_back.begin(), put_back.end());
  available.push_back(buildingsExperiment());
  std::vector<Experiment> chosen;
  for (const Experiment& experiment : available) {
    const auto& names = arguments.experiments;
    if (std::find(names.begin(), names.end(), experiment.group) != names.end()) {
      chosen.push_back(experiment);
    }
  }
  for (Experiment& experiment : recordedExperiments(arguments.recorded)) {
    chosen.push_back(std::move(experiment));
  }
  return chosen;
}

void write(const std::string& path, const std::function<void(std::ostream&)>& content) {
  std::ofstream file(path);
  content(file);
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

void writeCsv(const Arguments& arguments, const std::string& name, const Table& table) {
  write(arguments.out + "/" + name + ".csv", [&](std::ostream& file) { table.writeCsv(file); });
}

void showAndWrite(const Arguments& arguments, const std::string& name, const Table& table) {
  write(arguments.out + "/" + name + ".md", [&](std::ostream& file) { table.writeMarkdown(file); });
  std::cout << '\n';
  table.writeMarkdown(std::cout);
}

std::vector<Outcome> runWithBar(const std::string& what, const std::vector<Experiment>& experiments,
                                const std::vector<Method>& methods, const RunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  std::optional<support::ProgressBar> bar;
  const auto progress = [&](std::size_t done, std::size_t total) {
    if (!bar) bar.emplace(total, what, std::cerr);
    bar->show(done);
  };
  std::vector<Outcome> outcomes = runExperiments(experiments, methods, options, progress);
  if (bar) bar->finish();
  std::map<std::string, double> seconds;
  for (const Outcome& outcome : outcomes) seconds[outcome.method->name] += outcome.seconds;
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::cerr << what << ": " << fixed(took.count(), 1) << " s; of recognition";
  for (const auto& [method, spent] : seconds) {
    std::cerr << ", " << method << ' ' << fixed(spent, 1) << " s";
  }
  std::cerr << '\n';
  return outcomes;
}

void describeRun(const RunOptions& run, std::ostream& output) {
  output << "Each row below is over the seeds " << run.first_seed << " to "
         << run.first_seed + run.seeds - 1 << "; exhaustive search ran on the first "
         << std::min(run.slow_seeds, run.seeds) << " of them.\n";
}

void compare(const Arguments& arguments, const ShippedWorlds& worlds,
             const std::vector<Method>& methods) {
  const std::vector<Experiment> experiments = chosenExperiments(arguments, worlds);
  if (experiments.empty()) return;
  const std::vector<Outcome> outcomes =
      runWithBar("experiments", experiments, methods, arguments.run);
  write(arguments.out + "/run.md", [&](std::ostream& file) { describeRun(arguments.run, file); });
  writeCsv(arguments, "answers", answerTable(outcomes));
  writeCsv(arguments, "summary", summaryTable(outcomes));
  writeCsv(arguments, "reliability", reliabilityTable(outcomes));
  showAndWrite(arguments, "accuracy", accuracyTable(outcomes));
  showAndWrite(arguments, "methods", methodTable(outcomes));
  for (const Method& method : methods) {
    if (method.name != "default") continue;
    showAndWrite(arguments, "default", verdictTable(outcomes, method.name));
    showAndWrite(arguments, "verdicts", verdictShareTable(outcomes, method.name));
    showAndWrite(arguments, "calibration", calibrationTable(outcomes, method.name));
  }
}

void sweepAll(const Arguments& arguments, const ShippedWorlds& worlds,
              const std::vector<Method>& methods) {
  std::vector<Experiment> points;
  for (const std::string& name : arguments.sweeps) {
    const std::vector<Experiment> curve = sweep(name, worlds);
    points.insert(points.end(), curve.begin(), curve.end());
  }
  if (points.empty()) return;
  const std::vector<Outcome> outcomes = runWithBar("sweeps", points, methods, arguments.run);
  writeCsv(arguments, "sweeps", summaryTable(outcomes));
}

void rearrange(const Arguments& arguments, const ShippedWorlds& worlds,
               const std::vector<Method>& all) {
  const std::vector<Experiment> experiments = {
      rearrangementsExperiment(worlds, static_cast<int>(arguments.rearrangements))};
  const std::vector<Method> methods = rearrangementMethods(all);
  const std::vector<Outcome> outcomes =
      runWithBar("rearrangements", experiments, methods, arguments.run);
  writeCsv(arguments, "rearrangements", roundTable(outcomes));
  showAndWrite(arguments, "rearrangements", roundAccuracyTable(outcomes));
  showAndWrite(arguments, "folds", foldTable(outcomes));
}

void runSparse(const Arguments& arguments, const std::vector<Method>& all) {
  const std::vector<Experiment> experiments = sparseExperiments();
  const std::vector<Method> methods = selectMethods(all, {"default"});
  const std::vector<Outcome> outcomes =
      runWithBar("little to go by", experiments, methods, arguments.run);
  writeCsv(arguments, "sparse", summaryTable(outcomes));
  showAndWrite(arguments, "sparse", verdictTable(outcomes, methods.front().name));
}

/// Of the recordings that tell the way from scan to scan.
void believe(const Arguments& arguments, const std::vector<Method>& all) {
  constexpr std::size_t kOdometries = 20;
  const std::vector<Method> methods = selectMethods(all, {"default"});
  std::vector<MatchedDrive> drives;
  for (const std::string& path : arguments.recorded) {
    const trials::TrialSet set = trials::readEpisodeFile(path);
    const bool has_way = std::none_of(set.trials.begin(), set.trials.end(),
                                      [](const auto& trial) { return trial.way.empty(); });
    if (has_way) drives.push_back(matchDrive(set, methods.front()));
  }
  if (drives.empty()) return;
  showAndWrite(arguments, "belief", beliefTable(drives, {}, {}, kOdometries));
}

void drawAll(const Arguments& arguments, const ShippedWorlds& worlds,
             const std::vector<Method>& all) {
  const std::string folder = arguments.out + "/figures";
  std::filesystem::create_directories(folder);
  const std::vector<Method> methods =
      selectMethods(all, {"nearest_neighbour", "hill_climbing", "default"});
  for (const GridFigure& figure :
       gridFigures(worlds, methods[0], methods[1], methods[2], arguments.run.first_seed)) {
    writeFigure(figure, folder);
  }
  for (const MapFigure& figure : mapFigures(worlds)) writeFigure(figure, folder);
}

void process(const Arguments& arguments) {
  const std::vector<Method> all = allMethods(arguments.params, arguments.preset);
  const std::vector<Method> methods = selectMethods(all, arguments.methods);
  const ShippedWorlds worlds = loadShippedWorlds(arguments.worlds);
  std::filesystem::create_directories(arguments.out);
  compare(arguments, worlds, methods);
  sweepAll(arguments, worlds,
           selectMethods(all, {"nearest_neighbour", "hill_climbing", "default"}));
  believe(arguments, all);
  if (arguments.rearrangements > 0) rearrange(arguments, worlds, all);
  if (arguments.sparse) runSparse(arguments, all);
  if (arguments.figures) drawAll(arguments, worlds, all);
}

}  // namespace
}  // namespace place_memory::experiments

int main(int argc, char** argv) {
  try {
    if (const auto arguments = place_memory::experiments::readArguments(argc, argv)) {
      place_memory::experiments::process(*arguments);
    }
  } catch (const std::exception& error) {
    std::cerr << "place_memory_experiments: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
