#include "ar3d/analysis/scaling/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>

#include "ar3d/analysis/statistics.h"

namespace ar3d {
namespace {

double log_positive(double value) {
  return value > 0 && std::isfinite(value) ? std::log(value) : kMissing;
}

std::size_t axis_of(Quantity quantity) {
  return quantity == Quantity::extent_x ? 0 : quantity == Quantity::extent_y ? 1 : 2;
}

bool is_censored(RunStatus status) {
  return status == RunStatus::timeout || status == RunStatus::out_of_memory ||
         status == RunStatus::crashed;
}

/// Median of the repetitions' logarithms and the first row with a value; false if there is none.
bool instance_value(const Results& results, const InstanceRows& instance, Quantity quantity,
                    RunPhase times, InstanceValue& value) {
  std::vector<double> logs;
  for (const std::size_t row : instance.rows) {
    if (results.runs[row].status != RunStatus::ok) continue;
    if (quantity == Quantity::wall_s && results.runs[row].phase != times) continue;
    const double log = log_value(results.runs[row], quantity);
    if (std::isnan(log)) continue;
    if (logs.empty()) value.row = row;
    logs.push_back(log);
  }
  if (logs.empty()) return false;
  value.log_value = median(std::move(logs));
  return true;
}

}  // namespace

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = {Quantity::longest_side, Quantity::extent_x,
                                            Quantity::extent_y,     Quantity::extent_z,
                                            Quantity::volume,       Quantity::wall_s};
  return all;
}

const char* name_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::longest_side:
      return "longest side";
    case Quantity::extent_x:
      return "x extent";
    case Quantity::extent_y:
      return "y extent";
    case Quantity::extent_z:
      return "z extent";
    case Quantity::volume:
      return "volume";
    case Quantity::wall_s:
      return "drawing time";
  }
  return "unknown";
}

const char* unit_of(Quantity quantity) {
  if (quantity == Quantity::wall_s) return "s";
  return quantity == Quantity::volume ? "lattice points" : "lattice units";
}

double log_value(const RunRecord& run, Quantity quantity) {
  switch (quantity) {
    case Quantity::wall_s:
      return log_positive(run.wall_s);
    case Quantity::volume: {
      const double log = run.log2_volume * std::numbers::ln2;
      return std::isfinite(log) ? log : kMissing;
    }
    case Quantity::longest_side:
      return log_positive(
          static_cast<double>(*std::max_element(run.extents.begin(), run.extents.end())));
    default:
      return log_positive(static_cast<double>(run.extents[axis_of(quantity)]));
  }
}

double log_bound(const RunRecord& run, Quantity quantity) {
  const auto& bound = run.theorem_bound;
  switch (quantity) {
    case Quantity::wall_s:
      return kMissing;
    case Quantity::volume:
      return log_positive(bound[0] + 1) + log_positive(bound[1] + 1) + log_positive(bound[2] + 1);
    case Quantity::longest_side:
      if (std::any_of(bound.begin(), bound.end(), [](double b) { return std::isnan(b); })) {
        return kMissing;
      }
      return log_positive(*std::max_element(bound.begin(), bound.end()));
    default:
      return log_positive(bound[axis_of(quantity)]);
  }
}

std::vector<double> SizeSample::log_values() const {
  std::vector<double> values;
  for (const InstanceValue& instance : instances) values.push_back(instance.log_value);
  return values;
}

std::vector<CensoredRow> censored_rows(const Results& results, const Cell& cell) {
  std::vector<CensoredRow> rows;
  for (const InstanceRows& instance : cell.instances) {
    for (const std::size_t row : instance.rows) {
      if (instance.n >= 1 && is_censored(results.runs[row].status))
        rows.push_back({instance.n, row});
    }
  }
  return rows;
}

bool has_timing_rows(const Results& results, const Cell& cell) {
  return std::any_of(cell.rows.begin(), cell.rows.end(), [&](std::size_t row) {
    const RunRecord& run = results.runs[row];
    return run.phase == RunPhase::timing && run.status == RunStatus::ok;
  });
}

std::vector<SizeSample> samples(const Results& results, const Cell& cell, Quantity quantity) {
  const RunPhase times = has_timing_rows(results, cell) ? RunPhase::timing : RunPhase::metrics;
  std::map<std::int64_t, SizeSample> by_size;
  for (const InstanceRows& instance : cell.instances) {
    if (instance.n < 1) continue;
    SizeSample& size = by_size[instance.n];
    size.n = instance.n;
    size.censored |= std::any_of(instance.rows.begin(), instance.rows.end(), [&](std::size_t row) {
      return is_censored(results.runs[row].status);
    });
    InstanceValue value;
    if (!instance_value(results, instance, quantity, times, value)) continue;
    if (size.instances.empty()) size.log_bound = log_bound(results.runs[value.row], quantity);
    size.instances.push_back(value);
  }
  std::vector<SizeSample> sizes;
  for (auto& [n, size] : by_size) {
    if (!size.instances.empty()) sizes.push_back(std::move(size));
  }
  return sizes;
}

FitSizes choose_sizes(const std::vector<SizeSample>& all, std::size_t minimum_sizes) {
  FitSizes chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen.used),
               [](const SizeSample& size) { return !size.censored; });
  if (chosen.used.size() < all.size()) {
    chosen.left_out.push_back(
        fmt::format("{} with unfinished instances (the finished ones are the fast ones)",
                    all.size() - chosen.used.size()));
  }
  const std::size_t whole = chosen.used.size();
  std::size_t small = 0;
  while (whole - small > minimum_sizes &&
         static_cast<double>(chosen.used[small].n) <
             std::sqrt(static_cast<double>(chosen.used.back().n))) {
    ++small;
  }
  if (small > 0) {
    chosen.left_out.push_back(fmt::format(
        "{} below n = {} (less than the square root of the largest)", small, chosen.used[small].n));
    chosen.used.erase(chosen.used.begin(),
                      chosen.used.begin() + static_cast<std::ptrdiff_t>(small));
  }
  return chosen;
}

}  // namespace ar3d
