#include "core/kernels/cpu.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>

namespace place_memory::core {
namespace {

constexpr const char* kVariable = "PLACE_MEMORY_ISA";

std::vector<InstructionSet> detected() {
  std::vector<InstructionSet> sets{InstructionSet::kPortable};
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("popcnt") == 0) return sets;
  sets.push_back(InstructionSet::kPopcnt);
  if (__builtin_cpu_supports("avx2") == 0) return sets;
  sets.push_back(InstructionSet::kAvx2);
  if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
      __builtin_cpu_supports("avx512vl") != 0 && __builtin_cpu_supports("avx512vpopcntdq") != 0 &&
      __builtin_cpu_supports("avx512bitalg") != 0) {
    sets.push_back(InstructionSet::kAvx512);
  }
#elif defined(__aarch64__)
  sets.push_back(InstructionSet::kNeon);
#endif
  return sets;
}

}  // namespace

const char* nameOf(InstructionSet set) {
  constexpr std::array<const char*, 5> kNames{"portable", "popcnt", "avx2", "avx512", "neon"};
  return kNames[static_cast<std::size_t>(set)];
}

const std::vector<InstructionSet>& instructionSets() {
  static const std::vector<InstructionSet> sets = detected();
  return sets;
}

InstructionSet instructionSetNamed(const std::string& name) {
  if (name.empty()) return instructionSets().back();
  std::string names;
  for (const InstructionSet set : instructionSets()) {
    if (name == nameOf(set)) return set;
    names += (names.empty() ? "" : ", ") + std::string(nameOf(set));
  }
  throw std::invalid_argument(std::string(kVariable) + " is '" + name +
                              "': this processor can be used with " + names +
                              "; leave the variable unset for the fastest");
}

InstructionSet chosenInstructionSet() {
  static const InstructionSet chosen = [] {
    const char* const name = std::getenv(kVariable);
    return instructionSetNamed(name == nullptr ? "" : name);
  }();
  return chosen;
}

}  // namespace place_memory::core
