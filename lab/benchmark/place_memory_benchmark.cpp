#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "setting.h"

namespace place_memory::measure {
namespace {

namespace po = boost::program_options;

po::options_description knownOptions(Options& options) {
  po::options_description known(
      "Options beside those of Google Benchmark (--benchmark_filter, ...)");
  known.add_options()("help", "says this")(
      "max-places", po::value(&options.max_places)->default_value(options.max_places),
      "of the largest memory, at least 21")(
      "max-full", po::value(&options.max_full)->default_value(options.max_full),
      "of the largest memory that is searched in full")(
      "max-stored", po::value(&options.max_stored)->default_value(options.max_stored),
      "of the largest store, 6 KB a place")(
      "queries", po::value(&options.queries)->default_value(options.queries),
      "put to each memory at the most, at least 1")(
      "patience", po::value(&options.patience)->default_value(options.patience),
      "about so many seconds for the queries put to one memory by one method: the more, the more "
      "queries to the largest memories")(
      "times", po::value(&options.times)->default_value(options.times),
      "that recognition among up to 1000 places is repeated, at least 1")(
      "folder",
      po::value(&options.folder)->default_value(std::filesystem::temp_directory_path().string()),
      "for stores, which are removed again")(
      "write-store", po::value(&options.store_to_write),
      "writes a store of max-places places to this file, and measures nothing");
  return known;
}

/// Google Benchmark's own arguments are out already.
Options readArguments(int argc, char** argv) {
  Options options;
  const po::options_description known = knownOptions(options);
  po::variables_map values;
  po::store(po::parse_command_line(argc, argv, known), values);
  po::notify(values);
  if (options.max_places < 21 || options.queries < 1 || !(options.patience > 0.0) ||
      options.times < 1) {
    throw std::invalid_argument(
        "max-places must be at least 21, queries and times at least 1, patience above 0");
  }
  return options;
}

}  // namespace
}  // namespace place_memory::measure

int main(int argc, char** argv) {
  using namespace place_memory::measure;
  try {
    // Google Benchmark would speak of its own options alone.
    if (std::find(argv, argv + argc, std::string("--help")) != argv + argc) {
      Options defaults;
      std::cout << knownOptions(defaults);
      return EXIT_SUCCESS;
    }
    ::benchmark::Initialize(&argc, argv);
    const Options options = readArguments(argc, argv);
    Setting setting(options);
    if (!options.store_to_write.empty()) {
      writeStore(options.store_to_write, setting.memory(options.max_places));
      return EXIT_SUCCESS;
    }
    registerMemory(setting);
    registerKernels(setting);
    registerParts(setting);
    registerRecognition(setting);
    registerStrangers(setting);
    registerStore(setting);
    registerFusedMap(setting);
    registerDriving(setting);
    ::benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << "place_memory_benchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
