// What predicts the misses of real types, and where misses pass limits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "ar3d/analysis/report/frame.h"
#include "ar3d/analysis/report/precision.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 5> kLogLimits = {-12, -9, -6, -3, 0};  // log10 degrees

/// log10 of the degrees in 2^-bits radians.
double log_rounding(int bits) {
  return std::log10(180 / std::numbers::pi) - bits * std::numbers::ln2 / std::numbers::ln10;
}

/// log10 of the first n at which the values pass the limit, by interpolation in logarithms;
/// -infinity if the first one does, +infinity if none does.
double first_beyond(const std::map<std::int64_t, double>& values, double limit) {
  double last_n = 0, last = kMissing;
  for (const auto& [n, value] : values) {
    const double log_n = log10_of(n);
    if (value > limit) {
      if (std::isnan(last)) return -kInfinity;
      const double part = std::isfinite(last) ? (limit - last) / (value - last) : 1;
      return last_n + part * (log_n - last_n);
    }
    last_n = log_n, last = value;
  }
  return kInfinity;
}

std::map<std::int64_t, double> predicted_misses(const MissModel& model, const std::string& family,
                                                int bits) {
  std::map<std::int64_t, double> misses;
  const auto kappa = model.family_kappa.find(family);
  if (kappa == model.family_kappa.end()) return misses;
  for (const auto& [n, log_c] : model.log_condition.at(family)) {
    misses[n] = MissModel::log_miss(kappa->second, log_c, bits);
  }
  return misses;
}

/// Of misses by n, for every limit that one of the two passes inside of the sizes.
std::vector<Onset> onsets_between(const std::map<std::int64_t, double>& predicted,
                                  const std::map<std::int64_t, double>& seen) {
  std::vector<Onset> all;
  if (seen.size() < 2) return all;
  for (const double limit : kLogLimits) {
    Onset onset;
    onset.log_limit = limit;
    onset.log_predicted = first_beyond(predicted, limit);
    onset.log_seen = first_beyond(seen, limit);
    onset.log_first = log10_of(seen.begin()->first);
    onset.log_last = log10_of(seen.rbegin()->first);
    if (onset.log_predicted == onset.log_seen && std::isinf(onset.log_seen)) continue;
    onset.verdict = judge_onset(onset);
    all.push_back(std::move(onset));
  }
  return all;
}

/// Where the type's own misses pass the limit, or at the last n: what its kappa is there.
double kappa_seen(const Onset& onset, const std::map<std::int64_t, double>& seen,
                  const std::map<std::int64_t, double>& predicted) {
  double kappa = kMissing;
  for (const auto& [n, log_miss] : seen) {
    const auto at = predicted.find(n);
    if (at == predicted.end()) continue;
    kappa = onset.log_kappa + log_miss - at->second;
    if (log_miss > onset.log_limit) break;
  }
  return kappa;
}

}  // namespace

double MissModel::log_miss(double log_kappa, double log_c, int bits) {
  return log_kappa + log_c + log_rounding(bits);
}

MissModel miss_model(const RealRows& real) {
  MissModel model;
  for (std::size_t i = 0; i < real.settings.size(); ++i) {
    if (real.settings[i].bits > 0) model.setting = i;
  }
  if (real.settings.empty() || real.settings[model.setting].bits == 0) return model;
  std::vector<double> kappas;
  std::map<std::string, std::vector<double>> kappas_of;
  std::map<std::string, std::map<std::int64_t, std::vector<double>>> conditions;
  for (const RealRow& row : real.rows) {
    if (row.setting != model.setting || !std::isfinite(row.log_condition)) continue;
    conditions[row.family][row.requested_n].push_back(row.log_condition);
    const double kappa =
        row.log_miss - row.log_condition - log_rounding(real.settings[model.setting].bits);
    if (!std::isfinite(kappa)) continue;
    kappas.push_back(kappa);
    kappas_of[row.family].push_back(kappa);
  }
  model.drawings = kappas.size();
  model.log_kappa = {quantile(kappas, 0.1), quantile(kappas, 0.5), quantile(kappas, 0.9)};
  for (auto& [family, logs] : kappas_of) model.family_kappa[family] = median(std::move(logs));
  for (auto& [family, sizes] : conditions) {
    for (auto& [n, logs] : sizes) model.log_condition[family][n] = median(std::move(logs));
  }
  return model;
}

OnsetVerdict judge_onset(const Onset& onset) {
  const double factor = std::log10(2.0) + 1e-9;
  const auto inside = [](double log_n) { return std::isfinite(log_n); };
  if (inside(onset.log_predicted) && inside(onset.log_seen)) {
    return std::abs(onset.log_predicted - onset.log_seen) <= factor ? OnsetVerdict::confirmed
                                                                    : OnsetVerdict::refuted;
  }
  // One of them lies beyond an end of the sizes: by how much is not known, only by how much at
  // least.
  const auto at_least = [&](double known, double beyond) {
    return beyond > 0 ? onset.log_last - known : known - onset.log_first;
  };
  double apart = 0;
  if (inside(onset.log_predicted)) apart = at_least(onset.log_predicted, onset.log_seen);
  if (inside(onset.log_seen)) apart = at_least(onset.log_seen, onset.log_predicted);
  if (!inside(onset.log_predicted) && !inside(onset.log_seen) &&
      onset.log_predicted != onset.log_seen) {
    apart = onset.log_last - onset.log_first;
  }
  return apart > factor ? OnsetVerdict::refuted : OnsetVerdict::open;
}

std::vector<Onset> onsets(const RealRows& real, const MissModel& model) {
  std::vector<Onset> all;
  if (model.drawings == 0) return all;
  for (const auto& [family, log_kappa] : model.family_kappa) {
    for (std::size_t setting = 0; setting < real.settings.size(); ++setting) {
      const int bits = real.settings[setting].bits;
      if (setting == model.setting || bits == 0) continue;
      const auto seen = median_misses(real, setting, family);
      const auto predicted = predicted_misses(model, family, bits);
      for (Onset& onset : onsets_between(predicted, seen)) {
        onset.family = family;
        onset.setting = setting;
        onset.log_kappa = log_kappa;
        onset.log_kappa_seen = kappa_seen(onset, seen, predicted);
        all.push_back(std::move(onset));
      }
    }
  }
  return all;
}

std::vector<Onset> onsets_as_in(const RealRows& real, const RealRows& predicting,
                                std::size_t left_out) {
  std::vector<Onset> all;
  std::set<std::string> families;
  for (const RealRow& row : real.rows) families.insert(row.family);
  for (const std::string& family : families) {
    for (std::size_t setting = 0; setting < real.settings.size(); ++setting) {
      if (setting == left_out) continue;
      const auto seen = median_misses(real, setting, family);
      for (Onset& onset : onsets_between(median_misses(predicting, setting, family), seen)) {
        onset.family = family;
        onset.setting = setting;
        all.push_back(std::move(onset));
      }
    }
  }
  return all;
}

}  // namespace ar3d::report
