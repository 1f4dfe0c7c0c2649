#ifndef PLACE_MEMORY_BENCHMARK_RESIDENT_H
#define PLACE_MEMORY_BENCHMARK_RESIDENT_H

#include <malloc.h>
#include <unistd.h>

#include <fstream>

namespace place_memory::measure {

/// Memory of this process that is in RAM, after giving back what is free [bytes]. Linux.
inline double residentBytes() {
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  double all = 0.0, resident = 0.0;
  statm >> all >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_RESIDENT_H
