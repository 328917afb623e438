#include "turns.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ar3d/base/parallel.h"

namespace ar3d::kernels {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::function<double()> side_by_side(std::function<void()> work) {
  const auto both = [work = std::move(work)] {
    const auto one = [&work] {
      omp_set_num_threads(1);  // of the calling thread's regions
      work();
    };
    in_threads(2, [&](std::uint32_t) { one(); });
  };
  return [seconds = timed(Clock::wall, both)] { return seconds() / 2; };
}

void Turns::run(int rounds, double most_seconds, const std::function<void()>& before_round,
                int least) {
  std::vector<double> taken(works_.size(), 0);
  for (int round = 0; round < rounds; ++round) {
    if (round >= least && *std::max_element(taken.begin(), taken.end()) >= most_seconds) return;
    if (before_round) before_round();
    add_round();
    for (std::size_t i = 0; i < works_.size(); ++i) taken[i] += last_of(i);
  }
}

void Turns::add_round() {
  for (std::size_t i = 0; i < works_.size(); ++i) times_[i].push_back(works_[i]());
}

double Turns::mean_of(std::size_t i) const {
  const std::vector<double>& times = times_[i];
  return std::accumulate(times.begin(), times.end(), 0.0) / static_cast<double>(times.size());
}

double Turns::standard_error_of(std::size_t i) const {
  const double mean = mean_of(i);
  double squares = 0;
  for (const double time : times_[i]) squares += (time - mean) * (time - mean);
  const auto count = static_cast<double>(rounds());
  return count < 2 ? std::nan("") : std::sqrt(squares / (count * (count - 1)));
}

std::string Turns::rounds_remark(int asked) const {
  return rounds() == static_cast<std::size_t>(asked) ? "" : fmt::format(", {} rounds", rounds());
}

}  // namespace ar3d::kernels
