#ifndef PLACE_MEMORY_BENCHMARK_CLOCK_RATE_H
#define PLACE_MEMORY_BENCHMARK_CLOCK_RATE_H

namespace place_memory::measure {

/// Cycles a second of the core right now, measured by a chain of multiplications of which each has
/// to wait for the one before it: three cycles each on x86-64 of the last fifteen years and on most
/// 64-bit ARM cores. Virtual machines seldom have cycle counters, and the time stamp counter ticks
/// at a rate of its own.
double cyclesPerSecond();

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_CLOCK_RATE_H
