#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "ar3d/base/random.h"
#include "synthetic.h"

namespace ar3d::testing {

/// The stated noise model of a history (docs/history.md): the logarithm of a cell's time at a
/// commit is its level, plus normal noise of `spread`, plus, for two commits in a hundred, a burst:
/// log(1 + a Pareto number of index 1 from 0.05; in the mean infinite).
struct HistoryNoise {
  double spread = 0.01;
  double of_the_last = 0;  ///< share of the last commit's normal noise that stays (AR(1))
  std::uint32_t burst_percent = 2;

  /// @param level  of commit i of `commits`.
  template <class Level>
  std::vector<double> series(std::uint64_t seed, std::uint64_t trial, std::size_t commits,
                             Level level) const {
    RandomStream random(seed, trial);
    std::vector<double> values;
    double noise = normal(random);
    for (std::size_t i = 0; i < commits; ++i) {
      values.push_back(level(i) + spread * noise);
      if (random.chance(burst_percent, 100)) {
        values.back() += std::log1p(0.05 / (1 - random.unit()));
      }
      noise = of_the_last * noise + std::sqrt(1 - of_the_last * of_the_last) * normal(random);
    }
    return values;
  }
};

}  // namespace ar3d::testing
