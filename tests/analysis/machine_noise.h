#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "ar3d/base/random.h"
#include "synthetic.h"

namespace ar3d::testing {

/// The stated noise model of a machine, for simulated comparisons: a time is its true value times
/// log-normal noise of 3 % a repetition; one repetition in ten is hit by a burst that multiplies it
/// by 1 + a Pareto number (index 1, from 0.1: in the mean infinite); a process is faster or slower
/// as a whole by log-normal 0.5 % (its memory layout); the machine drifts by a sine of +-10 % over
/// fifteen rounds and a random walk of 1 % a process, half of which an A meets before its B.
class MachineNoise {
 public:
  /// @param burst_percent  of the repetitions: 10 on a quiet machine, more on a loaded one.
  MachineNoise(std::uint64_t seed, std::uint64_t trial, std::uint32_t burst_percent = 10)
      : random_(seed, trial), burst_percent_(burst_percent) {}

  /// log(B / A) of every cell and round, the sides in turns, the smallest of `repetitions` each.
  /// @param slowdown  of B, by cell: log(true B / true A).
  std::vector<std::vector<double>> rounds(const std::vector<double>& slowdown, std::size_t rounds,
                                          int repetitions) {
    std::vector<std::vector<double>> ratios(slowdown.size());
    for (std::size_t round = 0; round < rounds; ++round) {
      const bool b_first = round % 2 == 1;
      const std::vector<double> first = process(slowdown.size(), repetitions, clock_);
      const std::vector<double> second = process(slowdown.size(), repetitions, clock_);
      for (std::size_t cell = 0; cell < slowdown.size(); ++cell) {
        const double gain = second[cell] - first[cell];
        ratios[cell].push_back(slowdown[cell] + (b_first ? -gain : gain));
      }
    }
    return ratios;
  }

 private:
  /// Log of the smallest time of every cell in one process.
  std::vector<double> process(std::size_t cells, int repetitions, double& clock) {
    clock += 1;
    walk_ += 0.01 * normal(random_);
    const double drift = 0.1 * std::sin(2 * std::numbers::pi * clock / 30);
    const double layout = 0.005 * normal(random_);
    std::vector<double> smallest;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      double best = repetition();
      for (int i = 1; i < repetitions; ++i) best = std::min(best, repetition());
      smallest.push_back(best + drift + walk_ + layout + 0.005 * normal(random_));
    }
    return smallest;
  }

  double repetition() {
    const double noise = 0.03 * normal(random_);
    if (!random_.chance(burst_percent_, 100)) return noise;
    return noise + std::log1p(0.1 / (1 - random_.unit()));
  }

  RandomStream random_;
  std::uint32_t burst_percent_;
  double clock_ = 0;
  double walk_ = 0;
};

}  // namespace ar3d::testing
