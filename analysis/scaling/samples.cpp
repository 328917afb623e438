// Groups the graphs of a curve by size and chooses the sizes that a fit may use. A size with rows
// that ended early is left out, because only its fast graphs are there.
#include <algorithm>
#include <iterator>

#include "ar3d/analysis/scaling/scaling.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d {
const char* name_of(Quantity quantity) {
  constexpr std::array kNames = {"longest side",    "x extent",        "y extent",
                                 "z extent",        "volume",          "skewed x extent",
                                 "skewed y extent", "skewed z extent", "drawing time"};
  return kNames[static_cast<std::size_t>(quantity)];
}

double log_bound(const DrawnGraph& graph, Quantity quantity) {
  const auto& bound = graph.theorem_bound;
  const auto axis =
      static_cast<std::size_t>(quantity) - static_cast<std::size_t>(Quantity::extent_x);
  if (axis < bound.size()) return log_positive(bound[axis]);
  if (quantity == Quantity::volume) {
    return log_positive(bound[0] + 1) + log_positive(bound[1] + 1) + log_positive(bound[2] + 1);
  }
  if (quantity != Quantity::longest_side) return kMissing;
  const bool is_whole = std::ranges::none_of(bound, [](double b) { return std::isnan(b); });
  return is_whole ? log_positive(std::ranges::max(bound)) : kMissing;
}

std::vector<double> SizeSample::log_values() const {
  std::vector<double> values;
  for (const auto& [log_value, row] : instances) values.push_back(log_value);
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
      size.instances.emplace_back(log, graph.row);
    }
    if (size.instances.empty()) continue;
    if (tally.graphs.size() < tally.drawn) {
      size.mean_of_all = tally.mean_log(quantity, curve.has_timing_rows);
    }
    sizes.push_back(std::move(size));
  }
  return sizes;
}

std::vector<SizeSample> choose_sizes(const std::vector<SizeSample>& all,
                                     std::size_t minimum_sizes) {
  std::vector<SizeSample> used;
  std::ranges::copy_if(all, std::back_inserter(used), std::logical_not(), &SizeSample::censored);
  auto first = used.begin();
  while (used.end() - first > static_cast<std::ptrdiff_t>(minimum_sizes) &&
         static_cast<double>(first->n) < std::sqrt(static_cast<double>(used.back().n))) {
    ++first;
  }
  used.erase(used.begin(), first);
  return used;
}

}  // namespace ar3d
