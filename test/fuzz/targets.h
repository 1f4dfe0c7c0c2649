#ifndef PLACE_MEMORY_TEST_FUZZ_TARGETS_H
#define PLACE_MEMORY_TEST_FUZZ_TARGETS_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace place_memory::fuzz {

/// Gives any bytes to a part of the package that reads what others wrote. A target ends the process
/// where that part does what it never may: crash, throw what it does not say it throws, or take for
/// good what is not.
struct Target {
  const char* name;
  void (*run)(const std::uint8_t* bytes, std::size_t size);
};

/// Every one of them.
const std::vector<Target>& targets();

void runMessages(const std::uint8_t* bytes, std::size_t size);
void runParameters(const std::uint8_t* bytes, std::size_t size);
void runPreset(const std::uint8_t* bytes, std::size_t size);
void runEvents(const std::uint8_t* bytes, std::size_t size);
void runWorld(const std::uint8_t* bytes, std::size_t size);
void runEpisodes(const std::uint8_t* bytes, std::size_t size);
void runDrive(const std::uint8_t* bytes, std::size_t size);
void runStore(const std::uint8_t* bytes, std::size_t size);
void runMapper(const std::uint8_t* bytes, std::size_t size);
void runMemory(const std::uint8_t* bytes, std::size_t size);
void runEdits(const std::uint8_t* bytes, std::size_t size);
void runPaths(const std::uint8_t* bytes, std::size_t size);
void runGoals(const std::uint8_t* bytes, std::size_t size);
void runText(const std::uint8_t* bytes, std::size_t size);

inline std::string asText(const std::uint8_t* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size};
}

/// Ends the process with a sentence where it does not hold.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "must not be: %s\n", what);
  std::abort();
}

/// A file with these bytes for the parts that want one; there is one of each ending in a process.
std::string fileOf(const std::uint8_t* bytes, std::size_t size, const std::string& ending);

}  // namespace place_memory::fuzz

#endif  // PLACE_MEMORY_TEST_FUZZ_TARGETS_H
