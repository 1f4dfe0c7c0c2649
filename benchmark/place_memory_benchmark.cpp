#include <benchmark/benchmark.h>

#include <boost/program_options.hpp>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <optional>

#include "setting.h"

namespace place_memory::measure {
namespace {

namespace po = boost::program_options;

std::optional<Options> readArguments(int argc, char** argv) {
  Options options;
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
      "folder",
      po::value(&options.folder)->default_value(std::filesystem::temp_directory_path().string()),
      "for stores, which are removed again")(
      "write-store", po::value(&options.store_to_write),
      "writes a store of max-places places to this file, and measures nothing");
  po::variables_map values;
  po::store(po::parse_command_line(argc, argv, known), values);
  if (values.count("help") > 0) {
    std::cout << known;
    return std::nullopt;
  }
  po::notify(values);
  if (options.max_places < 21 || options.queries < 1) {
    throw std::invalid_argument("max-places must be at least 21, queries at least 1");
  }
  return options;
}

}  // namespace
}  // namespace place_memory::measure

int main(int argc, char** argv) {
  using namespace place_memory::measure;
  try {
    ::benchmark::Initialize(&argc, argv);  // takes its own arguments out
    const auto options = readArguments(argc, argv);
    if (!options) return EXIT_SUCCESS;
    Setting setting(*options);
    if (!options->store_to_write.empty()) {
      writeStore(options->store_to_write, setting.memory(options->max_places));
      return EXIT_SUCCESS;
    }
    registerKernels(setting);
    registerParts(setting);
    registerRecognition(setting);
    registerStrangers(setting);
    registerStore(setting);
    ::benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::cerr << "place_memory_benchmark: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
