#ifndef PLACE_MEMORY_BENCHMARK_SETTING_H
#define PLACE_MEMORY_BENCHMARK_SETTING_H

#include <memory>
#include <string>

#include "config/parameters.h"
#include "synthetic_memory.h"

namespace place_memory::measure {

struct Options {
  std::size_t max_places = 1000;  ///< of the largest memory
  std::size_t max_full = 1000;    ///< of the largest that is searched in full
  std::size_t max_stored = 1000;  ///< of the largest store
  std::size_t queries = 400;      ///< put to each memory at the most
  double patience = 60.0;         ///< about so long for each memory and method [s]
  int times = 9;       ///< that recognition in small memories is repeated; of the times, medians
  std::string folder;  ///< for stores
  std::string store_to_write;  ///< "": none
};

/// What all benchmarks of one run share. Everything is made when it is first asked for.
class Setting {
 public:
  explicit Setting(const Options& options);

  const Options& options() const { return options_; }
  const config::Parameters& parameters() const { return parameters_; }

  const SimulatedPlaces& simulated();
  /// The newest one is kept, so benchmarks of one size should follow each other.
  const KnownMap& map(std::size_t size);
  const core::PlaceIndex& index(std::size_t size) { return map(size).index; }
  void dropMap();
  SyntheticMemory memory(std::size_t size) { return {simulated(), size}; }

  /// Queries that the patience allows where one takes `seconds_per_place` for each place.
  std::size_t affordableQueries(std::size_t size, double seconds_per_place) const;

 private:
  Options options_;
  config::Parameters parameters_;
  std::unique_ptr<SimulatedPlaces> simulated_;
  std::size_t map_size_ = 0;
  KnownMap map_;
};

/// "1000" as it stands in the names of benchmarks, behind "local" or "any".
std::string benchmarkName(const std::string& what, bool any_heading, std::size_t places);

/// Makes a store of every place of the memory, linked one after the other.
void writeStore(const std::string& path, const SyntheticMemory& memory);

// Each registers the benchmarks of one file; the setting has to outlive them.
void registerMemory(Setting& setting);  ///< wants a fresh process
void registerKernels(Setting& setting);
void registerParts(Setting& setting);
void registerRecognition(Setting& setting);
void registerStrangers(Setting& setting);
void registerStore(Setting& setting);
void registerFusedMap(Setting& setting);
void registerDriving(Setting& setting);

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_SETTING_H
