#include "clock_rate.h"

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace place_memory::measure {
namespace {

constexpr double kCyclesPerMultiplication = 3.0;

double rateOnce() {
  constexpr int kRounds = 100000;
  constexpr int kUnrolled = 10;
  std::uint64_t product = 3;
  std::uint64_t factor = 5;
  asm volatile("" : "+r"(factor));
  const auto begin = std::chrono::steady_clock::now();
  for (int round = 0; round < kRounds; ++round) {
    for (int i = 0; i < kUnrolled; ++i) {
      product *= factor;
      asm volatile("" : "+r"(product));
    }
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
  return kRounds * kUnrolled * kCyclesPerMultiplication / spent.count();
}

}  // namespace

double cyclesPerSecond() {
  // The fastest of several, because a round that was interrupted says too little.
  double rate = 0.0;
  for (int i = 0; i < 20; ++i) rate = std::max(rate, rateOnce());
  return rate;
}

}  // namespace place_memory::measure
