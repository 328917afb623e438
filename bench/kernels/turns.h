#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/bench/measure/instruments.h"

namespace ar3d::kernels {

double median(std::vector<double> values);

enum class Clock { cpu, wall };  ///< CPU time of the calling thread, or wall time

/// The work as a function that tells how many seconds it took.
template <class Work>
std::function<double()> timed(Clock clock, Work work) {
  return [clock, work] {
    const Stopwatch wall;
    const CpuStopwatch cpu;
    work();
    return clock == Clock::cpu ? cpu.cpu_s() : wall.wall_s();
  };
}

/// Half the wall time of two calls of the work at the same time, each on a thread of its own: what
/// a second thread can give at most where the two share nothing but the machine. @pre the work uses
/// one thread.
std::function<double()> side_by_side(std::function<void()> work);

/// Repeats of slow works end after so many seconds, three at least.
inline constexpr double kSlowSeconds = 12;
inline constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Times works in rounds of one call each, so that whatever disturbs the machine for a while
/// disturbs all alike.
class Turns {
 public:
  explicit Turns(std::vector<std::function<double()>> works)
      : works_(std::move(works)), times_(works_.size()) {}

  /// @param most_seconds  rounds end once the slowest work has taken that long, after `least`.
  void run(int rounds, double most_seconds = kNoLimit,
           const std::function<void()>& before_round = {}, int least = 3);

  /// One call of each work.
  void add_round();
  /// Seconds of the last call of work i.
  double last_of(std::size_t i) const { return times_[i].back(); }
  /// Median of the seconds of work i.
  double median_of(std::size_t i) const { return median(times_[i]); }
  /// Mean of the seconds of work i, and the standard error of that mean (NaN for one round): for
  /// works whose time is chance, where a median leaves out what is rare and long.
  double mean_of(std::size_t i) const;
  double standard_error_of(std::size_t i) const;
  std::size_t rounds() const { return times_[0].size(); }
  /// "" or ", 3 rounds" if they were fewer than that.
  std::string rounds_remark(int asked) const;

 private:
  std::vector<std::function<double()>> works_;
  std::vector<std::vector<double>> times_;
};

}  // namespace ar3d::kernels
