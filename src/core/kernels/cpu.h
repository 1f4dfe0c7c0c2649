#ifndef PLACE_MEMORY_CORE_KERNELS_CPU_H
#define PLACE_MEMORY_CORE_KERNELS_CPU_H

#include <string>
#include <vector>

namespace place_memory::core {

/// What kernels are written for. On one architecture a later one includes those before it.
enum class InstructionSet {
  kPortable,  ///< what every processor of the architecture has
  kPopcnt,    ///< x86: counts the bits of a word
  kAvx2,      ///< x86: and looks up 32 bytes at a time
  kAvx512,    ///< x86: and counts bits in vectors: AVX-512 F, BW, VL, VPOPCNTDQ and BITALG
  kNeon,      ///< ARM: counts bits in vectors
};

/// "portable", "popcnt", "avx2", "avx512" or "neon".
const char* nameOf(InstructionSet set);

/// Those that this processor has, slowest first; kPortable is one of them.
const std::vector<InstructionSet>& instructionSets();

/// The one of instructionSets() with this name; of "" the last. Throws std::invalid_argument with a
/// sentence that names the possible ones.
InstructionSet instructionSetNamed(const std::string& name);

/// The one that all kernels use: the one that the environment variable PLACE_MEMORY_ISA names, else
/// the fastest. Decided once, by the first call that does not throw; throws as
/// instructionSetNamed().
InstructionSet chosenInstructionSet();

/// One of several kernels that give the same integers.
template <typename Kernel>
struct KernelVariant {
  InstructionSet set;
  Kernel kernel;
};

/// The last of these, slowest first, that chosenInstructionSet() allows. The first is for
/// kPortable.
template <typename Kernel>
Kernel chosenKernel(const std::vector<KernelVariant<Kernel>>& variants) {
  Kernel chosen = variants.front().kernel;
  for (const KernelVariant<Kernel>& variant : variants) {
    if (variant.set <= chosenInstructionSet()) chosen = variant.kernel;
  }
  return chosen;
}

}  // namespace place_memory::core

#endif  // PLACE_MEMORY_CORE_KERNELS_CPU_H
