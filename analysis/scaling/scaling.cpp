// Decides what may be said of a growth: a power law, one with a logarithm, or only an apparent
// exponent. The rules are those of docs/analysis.md, Growth; where none holds, the entry says which
// sizes would decide.
#include "ar3d/analysis/scaling/scaling.h"

#include <fmt/format.h>

#include "ar3d/base/parallel.h"

namespace ar3d {
namespace {

constexpr std::size_t kFewestSizes = 8;
/// The largest size over the smallest that is used.
constexpr double kLeastSpan = 4;
/// A power law: the drift of the local exponent lies within this on either side.
constexpr double kSteadyDrift = 0.1;
/// A power law needs a largest size so many times the smallest: then the drift bounds what is left
/// of a lower-order term of relative order n^(-1/2).
constexpr double kLawSpan = 16;
/// A logarithm needs more: over 100-fold sizes a factor log n bends the line visibly.
constexpr double kLogSpan = 100;
/// A model is adequate if the test of fit does not reject it at this level, or if the sizes are off
/// it by less than one per cent.
constexpr double kFitLevel = 0.1;
constexpr double kNegligibleResidual = 0.01;
/// A logarithm's exponent is a whole number, no larger than this, and known this well.
constexpr int kLargestLogExponent = 3;
constexpr double kLogExponentWidth = 2;
constexpr double kDecisiveWeight = 0.95;
/// log log n needs n > 1, and is steep just above it.
constexpr std::int64_t kSmallestNForLogs = 3;
constexpr std::size_t kUsualSeeds = 8;
/// Proposed where nothing was measured.
constexpr std::int64_t kFirstSize = 16;
constexpr std::int64_t kLargestProposal = std::int64_t{1} << 30;

/// "sizes 2000 and 4000", "sizes 10, 20 and 40"
std::string sizes_text(const std::vector<std::int64_t>& sizes) {
  std::string text = sizes.size() == 1 ? "size " : "sizes ";
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "" : i + 1 == sizes.size() ? " and " : ", ", sizes[i]);
  }
  return text;
}

/// `count` sizes, each twice the one before, above everything that was measured.
std::vector<std::int64_t> doubled_sizes(const ScalingEntry& entry, std::size_t count) {
  std::vector<std::int64_t> sizes;
  std::int64_t n = entry.all.empty() ? kFirstSize / 2 : entry.all.back().n;
  while (sizes.size() < count && n <= kLargestProposal / 2) sizes.push_back(n *= 2);
  return sizes;
}

void propose(std::vector<std::int64_t> sizes, ScalingEntry& entry) {
  if (sizes.empty()) return;
  entry.next = sizes_text(sizes) + fmt::format(" with {} seeds each", kUsualSeeds);
  entry.next_sizes = std::move(sizes);
}

double span_of(const std::vector<SizeSample>& sizes) {
  return static_cast<double>(sizes.back().n) / static_cast<double>(sizes.front().n);
}

/// True if there are enough sizes; else says what is missing.
bool has_enough_sizes(ScalingEntry& entry) {
  const auto& used = entry.used;
  const auto refuse = [&](std::string reason, std::size_t more) {
    entry.reason = std::move(reason);
    propose(doubled_sizes(entry, more), entry);
    return false;
  };
  if (used.size() < kFewestSizes) {
    return refuse(fmt::format("{} sizes; at least {} are needed", used.size(), kFewestSizes),
                  kFewestSizes - used.size());
  }
  if (span_of(used) < kLeastSpan) {
    return refuse(fmt::format("the largest size is only {:.2g} times the smallest; at least {:.2g} "
                              "is needed",
                              span_of(used), kLeastSpan),
                  2);
  }
  if (used.front().n < kSmallestNForLogs) {
    return refuse(fmt::format("sizes below {} cannot tell logarithms", kSmallestNForLogs), 1);
  }
  return true;
}

bool is_adequate(const CurveFit& fit, double p_value, std::size_t sizes) {
  const double typical_residual = std::sqrt(fit.square_sum / static_cast<double>(sizes));
  return p_value >= kFitLevel || typical_residual <= kNegligibleResidual;
}

/// Point 5 of docs/analysis.md: the local exponent is the same over the sizes.
bool is_power_law(const ScalingEntry& entry) {
  const Interval drift = entry.drift;
  return span_of(entry.used) >= kLawSpan && drift.low > -kSteadyDrift &&
         drift.high < kSteadyDrift && is_adequate(entry.power, entry.line_p, entry.used.size());
}

bool holds_whole_number(const Interval& b) {
  for (int whole = 1; whole <= kLargestLogExponent; ++whole) {
    if (b.contains(whole)) return true;
  }
  return false;
}

/// Point 6 of docs/analysis.md: the local exponent falls as a plausible logarithm makes it fall,
/// and as nothing else.
bool is_power_and_log(const ScalingEntry& entry) {
  const Interval b = entry.with_log.log_exponent_interval;
  return span_of(entry.used) >= kLogSpan && entry.drift.high < 0 && b.low > 0 &&
         b.width() <= kLogExponentWidth && holds_whole_number(b) &&
         entry.log_weight >= kDecisiveWeight &&
         is_adequate(entry.with_log, entry.with_log_p, entry.used.size());
}

/// Returns what the local exponent does over the sizes, one clause.
std::string drift_text(const ScalingEntry& entry) {
  const char* verb = entry.drift.low > 0 ? "rises" : entry.drift.high < 0 ? "falls" : "changes";
  return fmt::format("local exponent {} from {:.2f} to {:.2f}, by [{:+.2f}, {:+.2f}]", verb,
                     entry.first_exponent, entry.last_exponent, entry.drift.low, entry.drift.high);
}

void decide_growth(ScalingEntry& entry) {
  entry.reason = drift_text(entry);
  if (is_power_law(entry)) {
    entry.growth = Growth::power;
    const double left = std::max(std::abs(entry.drift.low), std::abs(entry.drift.high));
    const Interval a = entry.power.exponent_interval;
    entry.law_interval = {a.low - left, a.high + left};
    return;
  }
  if (is_power_and_log(entry)) {
    const Interval b = entry.with_log.log_exponent_interval;
    entry.growth = Growth::power_and_log;
    entry.reason = fmt::format("log exponent {:.2f} [{:.2f}, {:.2f}], Akaike weight {:.3f}",
                               entry.with_log.log_exponent, b.low, b.high, entry.log_weight);
    return;
  }
  entry.growth = Growth::apparent;
  const bool is_steady = entry.drift.low > -kSteadyDrift && entry.drift.high < kSteadyDrift;
  if (is_steady && span_of(entry.used) >= kLawSpan) {
    entry.reason += fmt::format("; the sizes are off the line (p {:.2g})", entry.line_p);
  } else if (entry.drift.contains(0)) {
    propose(doubled_sizes(entry, 2), entry);
  }
}

/// Times of rows that others ran beside are no measurements of the program alone.
void refuse_untimed(ScalingEntry& entry) {
  ScalingEntry untimed;
  untimed.all = std::move(entry.all);
  untimed.reason = kUntimed;
  entry = std::move(untimed);
}

}  // namespace

const char* to_string(Growth growth) {
  static constexpr std::array<const char*, 4> kNames = {"power law", "power law with logarithm",
                                                        "apparent exponent", "undecided"};
  return kNames.at(static_cast<std::size_t>(growth));
}

ScalingEntry fit_scaling(std::vector<SizeSample> all) {
  ScalingEntry entry;
  entry.all = std::move(all);
  entry.used = choose_sizes(entry.all, kFewestSizes);
  const auto& used = entry.used;
  entry.decided = has_enough_sizes(entry);
  entry.power = fit_curve(used, false, entry.decided);
  if (!entry.decided) return entry;
  entry.with_log = fit_curve(used, true, true);
  measure_curvature(entry);
  entry.log_weight = log_weight(used);
  decide_growth(entry);
  return entry;
}

std::vector<ScalingEntry> scaling(const StudyTally& tally) {
  std::vector<ScalingEntry> entries(tally.curves.size() * kQuantities.size());
  for_each_in_threads(available_threads(), entries.size(), [&](std::uint32_t, std::size_t index) {
    const CurveTally& curve = tally.curves[index / kQuantities.size()];
    const Quantity quantity = kQuantities[index % kQuantities.size()];
    ScalingEntry& entry = entries[index];
    entry = fit_scaling(samples(curve, quantity));
    if (quantity == Quantity::wall_s && !curve.has_timing_rows) refuse_untimed(entry);
    entry.key = curve.key;
    entry.quantity = quantity;
    entry.censored = curve.censored.size();
  });
  std::erase_if(entries, [](const ScalingEntry& entry) { return entry.all.empty(); });
  return entries;
}

std::optional<double> theorem_order(const SizeBound& theorem, Quantity quantity) {
  std::array<double, 3> orders{};
  for (std::size_t axis = 0; axis < orders.size(); ++axis) {
    const AxisBound& bound = theorem.axes[axis];
    orders[axis] = bound.numerator == 0 ? 0 : bound.half_power / 2.0;
  }
  if (!theorem.promises_box()) return std::nullopt;
  const auto axis =
      static_cast<std::size_t>(quantity) - static_cast<std::size_t>(Quantity::extent_x);
  if (axis < orders.size()) return orders[axis];
  if (quantity == Quantity::longest_side) return std::ranges::max(orders);
  if (quantity == Quantity::volume) return orders[0] + orders[1] + orders[2];
  return std::nullopt;
}

void refuse_law_above(double order, ScalingEntry& entry) {
  if (entry.growth != Growth::power || entry.law_interval.low <= order) return;
  entry.growth = Growth::apparent;
  entry.reason +=
      fmt::format("; above the order n^{:.3g} of the theorem's bound, it cannot last", order);
  entry.law_interval = {kMissing, kMissing};
}

}  // namespace ar3d
