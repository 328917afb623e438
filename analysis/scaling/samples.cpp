// Groups the graphs of a curve by size and chooses the sizes that a fit may use. A size with rows
// that ended early is left out, because only its fast graphs are there.
#include "ar3d/analysis/scaling/samples.h"

#include <fmt/format.h>

#include <iterator>

#include "ar3d/analysis/statistics.h"

namespace ar3d {
const char* name_of(Quantity quantity) {
  constexpr std::array kNames = {"longest side",    "x extent",        "y extent",
                                 "z extent",        "volume",          "skewed x extent",
                                 "skewed y extent", "skewed z extent", "drawing time"};
  return kNames[static_cast<std::size_t>(quantity)];
}

const char* unit_of(Quantity quantity) {
  if (quantity == Quantity::wall_s) return "s";
  return quantity == Quantity::volume ? "lattice points" : "lattice units";
}

double log_bound(const DrawnGraph& graph, Quantity quantity) {
  const auto& bound = graph.theorem_bound;
  switch (quantity) {
    case Quantity::volume:
      return log_positive(bound[0] + 1) + log_positive(bound[1] + 1) + log_positive(bound[2] + 1);
    case Quantity::longest_side:
      if (std::any_of(bound.begin(), bound.end(), [](double b) { return std::isnan(b); })) {
        return kMissing;
      }
      return log_positive(*std::max_element(bound.begin(), bound.end()));
    case Quantity::extent_x:
      return log_positive(bound[0]);
    case Quantity::extent_y:
      return log_positive(bound[1]);
    case Quantity::extent_z:
      return log_positive(bound[2]);
    default:
      return kMissing;
  }
}

std::vector<double> SizeSample::log_values() const {
  std::vector<double> values;
  for (const InstanceValue& instance : instances) values.push_back(instance.log_value);
  return values;
}

double SizeSample::mean_log() const {
  return std::isnan(mean_of_all) ? mean(log_values()) : mean_of_all;
}

std::vector<SizeSample> samples(const CurveTally& curve, Quantity quantity) {
  std::vector<SizeSample> sizes;
  for (const auto& [n, tally] : curve.sizes) {
    if (n < 1) continue;
    SizeSample size;
    size.n = n;
    size.requested_n = tally.requested_n;
    size.censored = tally.censored;
    for (const DrawnGraph& graph : tally.graphs) {
      const double log = log_value(graph, quantity, curve.has_timing_rows);
      if (std::isnan(log)) continue;
      if (size.instances.empty()) size.log_bound = log_bound(graph, quantity);
      size.instances.push_back({log, graph.row});
    }
    if (size.instances.empty()) continue;
    if (tally.graphs.size() < tally.drawn) {
      size.mean_of_all = tally.mean_log(quantity, curve.has_timing_rows);
    }
    sizes.push_back(std::move(size));
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
