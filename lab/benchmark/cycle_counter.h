#ifndef PLACE_MEMORY_BENCHMARK_CYCLE_COUNTER_H
#define PLACE_MEMORY_BENCHMARK_CYCLE_COUNTER_H

#include <benchmark/benchmark.h>

#include <ctime>

#include "clock_rate.h"

namespace place_memory::measure {

/// Gives a benchmark the counter `cycles`: those of an iteration, by the time that this thread had
/// the core. It goes around the timed loop.
class CycleCounter {
 public:
  explicit CycleCounter(::benchmark::State& state)
      : state_(state), rate_(cyclesPerSecond()), begin_(threadSeconds()) {}
  ~CycleCounter() {
    const double seconds = threadSeconds() - begin_;
    state_.counters["cycles"] = seconds * rate_ / static_cast<double>(state_.iterations());
  }
  CycleCounter(const CycleCounter&) = delete;
  CycleCounter& operator=(const CycleCounter&) = delete;

 private:
  static double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }

  ::benchmark::State& state_;
  double rate_;
  double begin_;
};

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_CYCLE_COUNTER_H
