// What the section on precision reads of a study's rows, what predicts the misses of real types,
// and where misses pass limits.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "ar3d/analysis/report/precision.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/store/columns/asked_certificate.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d::report {

namespace {

constexpr std::size_t kMostRealRows = 200000, kMostLookedAt = 200000, kMostJudgements = 2000;

/// The option `type` of two-bend-paper (docs/theorem2-paper.md).
constexpr std::array<std::pair<const char*, int>, 5> kRealTypes = {
    {{"float", 24}, {"double", 53}, {"binary80", 64}, {"binary128", 113}, {"237 bits", 237}}};

/// The median, infinities among the values; of two middle ones that are not both finite the larger.
double middle_of(std::vector<double> values) {
  if (values.empty()) return kMissing;
  std::sort(values.begin(), values.end());
  const double low = values[(values.size() - 1) / 2], high = values[values.size() / 2];
  return std::isfinite(low) ? (low + high) / 2 : high;
}

void add_judgement(const RunRecord& run, PrecisionRows& rows) {
  const CurveKey curve{run.algorithm, run.options, {}, {}, {}};
  const JudgementKey key{algorithm_label(curve), run.requested_n, asked_certificate(run),
                         run.level.empty() ? "extents" : run.level};
  if (!rows.judgements.contains(key) && rows.judgements.size() == kMostJudgements) return;
  Judgements& judged = rows.judgements[key];
  const auto n = static_cast<double>(run.n);
  ++judged.rows;
  judged.violated += run.status == RunStatus::violated;
  judged.draw_s.push_back(run.cpu_s / n);
  judged.store_s.push_back(run.store_s / n);
  judged.certify_s.push_back(run.certify_s / n);
  const bool is_own = run.peak_scope == "row" || run.peak_scope == "worker";
  if (is_own && run.base_bytes >= 0 && run.peak_bytes > run.base_bytes) {
    judged.peak_bytes.push_back(static_cast<double>(run.peak_bytes - run.base_bytes) / n);
  }
}

std::size_t setting_of(const CurveKey& key, std::vector<RealSetting>& settings) {
  const RealSetting setting = real_setting(key);
  const auto at = std::ranges::find(settings, setting.name, &RealSetting::name);
  const auto place = static_cast<std::size_t>(at - settings.begin());
  if (at == settings.end()) settings.push_back(setting);
  return place;
}

void add_real(const RunRecord& run, std::size_t row, double miss, RealRows& rows) {
  static const std::array<Column, 4> within = {run_column("within_1e_12"),
                                               run_column("within_1e_9"), run_column("within_1e_6"),
                                               run_column("within_1e_3")};
  static const Column condition = run_column("condition");
  static const Column collapsed = run_column("collapsed_segments");
  static const Column crossings = run_column("crossings");
  const CurveKey key = curve_of(run);
  RealRow real{
      row,  setting_of(key, rows.settings), run.graph_hash, family_label(key), run.requested_n,
      run.n};
  real.log_miss = std::log10(miss);
  real.log_condition = std::log10(column_number(condition, run));
  for (std::size_t i = 0; i < within.size(); ++i) real.within[i] = column_number(within[i], run);
  real.is_broken = column_number(collapsed, run) > 0 || column_number(crossings, run) > 0;
  real.cpu_s = run.cpu_s;
  rows.rows.push_back(std::move(real));
}

void add_row(const RunRecord& run, std::size_t row, PrecisionRows& rows) {
  static const Column column = run_column("angle_miss");
  if (run.status != RunStatus::ok && run.status != RunStatus::violated) return;
  if (run.n < 1 || run.phase != RunPhase::metrics) return;
  add_judgement(run, rows);
  const double miss = column_number(column, run);
  if (run.repetition > 0 || !(miss >= 0)) return;
  if (rows.real.rows.size() == kMostRealRows) {
    ++rows.real.left_out;
  } else {
    add_real(run, row, miss, rows.real);
  }
}

void sort_settings(RealRows& real) {
  std::vector<RealSetting> sorted = real.settings;
  std::ranges::stable_sort(sorted, {}, [](const RealSetting& setting) {
    return setting.bits == 0 ? std::numeric_limits<int>::max() : setting.bits;
  });
  for (RealRow& row : real.rows) {
    const std::string& name = real.settings[row.setting].name;
    const auto at = std::ranges::find(sorted, name, &RealSetting::name);
    row.setting = static_cast<std::size_t>(at - sorted.begin());
  }
  real.settings = std::move(sorted);
}

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

RealSetting real_setting(const CurveKey& key) {
  constexpr std::string_view kOption = "type=";
  if (key.algorithm == "two-bend-paper" && key.options.starts_with(kOption)) {
    for (std::size_t type = 0; type < kRealTypes.size(); ++type) {
      if (key.options.substr(kOption.size()) == std::to_string(type)) {
        return {kRealTypes[type].first, kRealTypes[type].second};
      }
    }
  }
  return {algorithm_label({key.algorithm, key.options, {}, {}, {}}), 0};
}

PrecisionRows precision_rows(const StudyAnalysis& analysis) {
  PrecisionRows rows;
  const bool is_all_proved = analysis.verdict.unproved == 0;  // then only levels are looked for
  const std::size_t count =
      is_all_proved ? std::min(analysis.rows.count, kMostLookedAt) : analysis.rows.count;
  for (std::size_t row = 0; row < count; ++row) add_row(analysis.rows.read(row), row, rows);
  sort_settings(rows.real);
  return rows;
}

std::string sample_family(const RealRows& real) {
  std::map<std::string, std::size_t> rows_of;
  for (const RealRow& row : real.rows) ++rows_of[row.family];
  const auto most = std::max_element(rows_of.begin(), rows_of.end(),
                                     [](auto& a, auto& b) { return a.second < b.second; });
  return most == rows_of.end() ? "" : most->first;
}

std::map<std::int64_t, double> median_misses(const RealRows& real, std::size_t setting,
                                             const std::string& family) {
  std::map<std::int64_t, std::vector<double>> misses;
  for (const RealRow& row : real.rows) {
    if (row.setting != setting || (!family.empty() && row.family != family)) continue;
    misses[row.requested_n].push_back(row.log_miss);
  }
  std::map<std::int64_t, double> medians;
  for (auto& [n, logs] : misses) medians[n] = middle_of(std::move(logs));
  return medians;
}

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

}  // namespace ar3d::report
