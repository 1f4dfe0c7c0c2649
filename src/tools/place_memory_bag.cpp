// Learns and recognizes places from a rosbag, through the very pipeline of the node.
#include <boost/program_options.hpp>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <optional>

#include "config/load_parameters.h"
#include "place_memory/core/place_memory.h"
#include "support/progress_bar.h"
#include "tools/bag_scanner.h"
#include "tools/event_table.h"
#include "tools/result_table.h"

namespace place_memory::tools {
namespace {

struct Arguments {
  std::string bag;
  std::string events;
  std::string out;
  std::vector<std::string> params;
  std::string store;
};

// Nothing where help was asked for, which is then printed.
std::optional<Arguments> readArguments(int argc, char** argv) {
  namespace po = boost::program_options;
  Arguments arguments;
  po::options_description options("Options");
  options.add_options()("help,h", "show this text")("bag", po::value(&arguments.bag)->required(),
                                                    "rosbag with sonar, heading and tf")(
      "events", po::value(&arguments.events)->required(),
      "table of what to do: start,end,action,label,heading_window [s, s, learn|recognize, text, "
      "rad]")("out", po::value(&arguments.out)->required(),
              "table of results to write, a row for each event")(
      "params", po::value(&arguments.params)->composing(),
      "parameters, laid out as config/place_memory.yaml; where several files give one, the last "
      "holds")("store", po::value(&arguments.store),
               "file of places, instead of the parameter store");
  po::variables_map given;
  po::store(po::command_line_parser(argc, argv).options(options).run(), given);
  if (given.count("help") > 0) {
    std::cout
        << "usage: place_memory_bag --bag F --events F --out F [--params F]... [--store F]\n\n"
        << options;
    return std::nullopt;
  }
  po::notify(given);
  return arguments;
}

std::vector<Event> loadEvents(const std::string& path, double heading_window) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read the events " + path);
  return readEvents(file, path, heading_window, {});
}

core::PlaceMemoryOptions memoryOptions(const config::Parameters& parameters,
                                       const std::string& store) {
  core::PlaceMemoryOptions options;
  options.store_path = store.empty() ? parameters.store : store;
  options.cell_size = parameters.grid.cell_size;
  options.recognizer = parameters.match.recognizer;
  options.adaptation = parameters.places;
  options.sonar = parameters.sonar;
  return options;
}

void process(const Arguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  const config::Parameters parameters = config::loadParameters(arguments.params);
  const std::vector<Event> events = loadEvents(arguments.events, parameters.match.heading_window);
  const BagScanner scanner(arguments.bag, parameters);
  core::PlaceMemory memory(memoryOptions(parameters, arguments.store));
  std::ofstream table(arguments.out);
  writeHeader(table);
  table.flush();
  if (!table) throw std::runtime_error("cannot write the results " + arguments.out);

  std::size_t failed = 0;
  support::ProgressBar bar(events.size(), "events", std::cerr);
  for (std::size_t i = 0; i < events.size() && table; ++i) {
    bar.show(i);
    const node::ScanOutcome outcome = scanner.scan(events[i].start, events[i].end);
    Result result;
    if (outcome.scan) {
      result = run(events[i], *outcome.scan, memory);
    } else {
      result.status = node::toString(outcome.status);
      result.message = outcome.message;
    }
    if (result.status != "ok") {
      ++failed;
      bar.note("event " + std::to_string(i + 1) + ": " + result.status + ": " + result.message);
    } else if (!result.message.empty()) {
      bar.note("event " + std::to_string(i + 1) + ": " + result.message);
    }
    writeRow(events[i], result, table);
  }
  bar.show(events.size());
  bar.finish();
  table.close();
  if (!table) throw std::runtime_error("cannot write the results " + arguments.out);

  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::cerr << events.size() << " events, " << failed << " failed, in " << std::fixed
            << std::setprecision(1) << took.count() << " s\n";
}

}  // namespace
}  // namespace place_memory::tools

int main(int argc, char** argv) {
  try {
    if (const auto arguments = place_memory::tools::readArguments(argc, argv)) {
      place_memory::tools::process(*arguments);
    }
  } catch (const std::exception& error) {
    std::cerr << "place_memory_bag: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
