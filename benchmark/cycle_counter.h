#ifndef PLACE_MEMORY_BENCHMARK_CYCLE_COUNTER_H
#define PLACE_MEMORY_BENCHMARK_CYCLE_COUNTER_H

#include <benchmark/benchmark.h>

#include "clock_rate.h"

namespace place_memory::measure {

/// Gives a benchmark the counter `cycles`: those of an iteration.
class CycleCounter {
 public:
  explicit CycleCounter(::benchmark::State& state) : state_(state) {}
  ~CycleCounter() {
    using ::benchmark::Counter;
    state_.counters["cycles"] =
        Counter(1.0 / rate_, Counter::kIsIterationInvariantRate | Counter::kInvert);
  }
  CycleCounter(const CycleCounter&) = delete;
  CycleCounter& operator=(const CycleCounter&) = delete;

 private:
  ::benchmark::State& state_;
  double rate_ = cyclesPerSecond();
};

}  // namespace place_memory::measure

#endif  // PLACE_MEMORY_BENCHMARK_CYCLE_COUNTER_H
