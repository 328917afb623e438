#include "ar3d/analysis/scaling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ar3d {
namespace {

/// A factor log^b n with |b| below this is called no logarithm.
constexpr double kNegligibleLogExponent = 0.5;
constexpr double kDecisiveWeight = 0.98;  // wrong in about 0.2 % of pure power laws
/// log log n needs n > 1, and is steep just above it.
constexpr std::int64_t kSmallestNForLogs = 3;
/// More seeds than this are not proposed; larger sizes tell more.
constexpr double kManySeeds = 200;
constexpr std::size_t kUsualSeeds = 8;
/// Proposed where nothing was measured.
constexpr std::int64_t kFirstSize = 16;
constexpr std::int64_t kLargestProposal = std::int64_t{1} << 30;

/// exp(-aicc/2) of the second model over the sum of both.
double akaike_weight(double aicc_first, double aicc_second) {
  if (std::isinf(aicc_first)) return std::isinf(aicc_second) ? 0.5 : 0;
  return 1 / (1 + std::exp((aicc_second - aicc_first) / 2));
}

double fewest_instances(const std::vector<SizeSample>& sizes) {
  std::size_t fewest = sizes.front().instances.size();
  for (const SizeSample& size : sizes) fewest = std::min(fewest, size.instances.size());
  return static_cast<double>(fewest);
}

/// "sizes 2000 and 4000", "sizes 10, 20 and 40"
std::string sizes_text(const std::vector<std::int64_t>& sizes) {
  std::string text = sizes.size() == 1 ? "size " : "sizes ";
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == sizes.size() ? " and " : ", ", sizes[i]);
  }
  return text;
}

std::int64_t largest_n(const std::vector<SizeSample>& sizes) {
  return sizes.empty() ? kFirstSize / 2 : sizes.back().n;
}

/// `count` sizes, each twice the one before, above everything that was measured.
std::vector<std::int64_t> doubled_sizes(const ScalingEntry& entry, std::size_t count) {
  std::vector<std::int64_t> sizes;
  std::int64_t n = largest_n(entry.all);
  while (sizes.size() < count && n <= kLargestProposal / 2) sizes.push_back(n *= 2);
  return sizes;
}

void propose(std::vector<std::int64_t> sizes, std::size_t seeds, ScalingEntry& entry) {
  entry.next = sizes_text(sizes) + fmt::format(" with {} seeds each", seeds);
  entry.next_study = {std::move(sizes), seeds};
}

/// An interval's width falls with the square root of the seeds a size; half the threshold on either
/// side decides. Where the sizes scatter by themselves, more seeds do not help: larger sizes do.
void propose_what_decides(ScalingEntry& entry) {
  const std::vector<std::int64_t> larger = doubled_sizes(entry, 2);
  const auto present = static_cast<std::size_t>(fewest_instances(entry.sizes.used));
  if (entry.with_log.spread == Spread::sizes) {
    propose(larger, std::max(kUsualSeeds, present), entry);
    return;
  }
  const double ratio = entry.with_log.log_exponent_interval.width() / kNegligibleLogExponent;
  const double seeds = std::ceil(static_cast<double>(present) * ratio * ratio);
  if (!(seeds <= kManySeeds)) {
    propose(larger, std::max(kUsualSeeds, present), entry);
    entry.next += fmt::format(" (more than {:.0f} seeds at the present sizes)", kManySeeds);
    return;
  }
  entry.next = fmt::format("about {:.0f} seeds a size at the present sizes, or {}", seeds,
                           sizes_text(larger));
  entry.next_study = {{}, static_cast<std::size_t>(seeds)};
}

/// True if there are enough sizes; else says what is missing.
bool has_enough_sizes(const FitOptions& options, ScalingEntry& entry) {
  const auto& used = entry.sizes.used;
  if (used.size() < options.minimum_sizes) {
    entry.reason =
        fmt::format("{} sizes; at least {} are needed", used.size(), options.minimum_sizes);
    propose(doubled_sizes(entry, options.minimum_sizes - used.size()), kUsualSeeds, entry);
    return false;
  }
  const double span = static_cast<double>(used.back().n) / static_cast<double>(used.front().n);
  if (span < options.minimum_span) {
    entry.reason =
        fmt::format("the largest size is only {:.2g} times the smallest; at least {:.2g} is needed",
                    span, options.minimum_span);
    propose(doubled_sizes(entry, 2), kUsualSeeds, entry);
    return false;
  }
  return true;
}

/// An interval of b inside ±1/2 rules a logarithm out; one that excludes 0, with a decisive weight,
/// shows one.
void decide_growth(ScalingEntry& entry) {
  const Interval b = entry.with_log.log_exponent_interval;
  const std::string interval = fmt::format("log exponent {:.2f} [{:.2f}, {:.2f}]",
                                           entry.with_log.log_exponent, b.low, b.high);
  if (b.low > -kNegligibleLogExponent && b.high < kNegligibleLogExponent) {
    entry.growth = Growth::power;
    entry.reason = interval;
  } else if (!b.contains(0) && entry.log_weight >= kDecisiveWeight) {
    entry.growth = Growth::power_and_log;
    entry.reason = interval + fmt::format(", Akaike weight {:.3f}", entry.log_weight);
  } else {
    entry.reason = interval;
    propose_what_decides(entry);
  }
}

}  // namespace

const char* to_string(Growth growth) {
  switch (growth) {
    case Growth::power:
      return "power law";
    case Growth::power_and_log:
      return "power law with logarithm";
    case Growth::undecided:
      return "undecided";
  }
  return "unknown";
}

ScalingEntry fit_scaling(std::vector<SizeSample> all, const FitOptions& options) {
  ScalingEntry entry;
  entry.all = std::move(all);
  entry.sizes = choose_sizes(entry.all, options.minimum_sizes);
  const auto& used = entry.sizes.used;
  entry.decided = has_enough_sizes(options, entry);
  entry.power = fit_curve(used, false, entry.decided, options.bootstrap);
  if (!entry.decided) return entry;
  if (used.front().n < kSmallestNForLogs) {
    entry.reason = fmt::format("sizes below {} cannot tell logarithms", kSmallestNForLogs);
    propose(doubled_sizes(entry, 1), kUsualSeeds, entry);
    return entry;
  }
  entry.with_log = fit_curve(used, true, true, options.bootstrap);
  entry.log_weight = akaike_weight(entry.power.aicc, entry.with_log.aicc);
  decide_growth(entry);
  return entry;
}

std::vector<ScalingEntry> scaling(const Results& results, const FitOptions& options) {
  const std::vector<Cell> all_cells = cells(results);
  const auto count = static_cast<std::ptrdiff_t>(all_cells.size() * quantities().size());
  std::vector<ScalingEntry> entries(static_cast<std::size_t>(count));
#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const Cell& cell = all_cells[index / quantities().size()];
    const Quantity quantity = quantities()[index % quantities().size()];
    entries[index] = fit_scaling(samples(results, cell, quantity), options);
    entries[index].key = cell.key;
    entries[index].quantity = quantity;
    entries[index].censored = censored_rows(results, cell);
  }
  std::erase_if(entries, [](const ScalingEntry& entry) { return entry.all.empty(); });
  return entries;
}

}  // namespace ar3d
