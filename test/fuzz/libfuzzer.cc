// What libFuzzer calls: the target that is named when this is compiled.
#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  place_memory::fuzz::PLACE_MEMORY_FUZZ_TARGET(bytes, size);
  return 0;
}
