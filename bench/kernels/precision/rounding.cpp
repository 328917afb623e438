// Where misses of two-bend-paper come from: computing in a type, or storing in it. Every graph of
// the study `precision` is drawn in each type, and in 237 bits with the coordinates rounded to that
// type once, at the end. If storing is all that counts, both miss by as much.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"
#include "ar3d/analysis/report/precision.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/verify/assessment/real_assessment.h"
#include "real_types.h"
#include "rounded_points.h"
#include "tables.h"

namespace ar3d::precision {
namespace {

using report::Onset;
using report::OnsetVerdict;
using report::RealRow;
using report::RealRows;
using two_bend_paper::RealType;

constexpr int kReferenceBits = 237;

/// Rows as the report has them, of what was computed in each type and of what was rounded to it;
/// the last setting is the drawing in 237 bits.
struct Rows {
  RealRows computed, rounded;
};

std::vector<report::RealSetting> settings() {
  std::vector<report::RealSetting> all;
  for (const MeasuredType& type : kMeasuredTypes) all.push_back({type.name, type.bits});
  all.push_back({"237 bits", kReferenceBits});
  return all;
}

RealRow row_of(const PlannedInstance& instance, std::size_t setting, const RealAssessment& found) {
  RealRow row;
  row.setting = setting;
  row.family = instance.choice.family->name;
  if (!instance.parameters.empty()) row.family += " (" + instance.parameters + ")";
  row.requested_n = static_cast<std::int64_t>(instance.requested_n);
  row.n = static_cast<std::int64_t>(instance.n);
  row.log_miss = std::log10(found.largest_miss);
  row.log_condition = std::log10(found.condition);
  return row;
}

bool has_real_types(const PlannedInstance& instance) {
  return std::any_of(instance.runs.begin(), instance.runs.end(), [](const PlannedRun& run) {
    return run.choice.algorithm->name == "two-bend-paper";
  });
}

void add_rows(const PlannedInstance& instance, Rows& rows) {
  const Graph graph = graph_of(instance);
  const RealPoints reference = two_bend_paper::draw_real(graph, RealType::reference);
  const RealAssessment assessed = assess(graph, reference);
  for (RealRows* part : {&rows.computed, &rows.rounded}) {
    part->rows.push_back(row_of(instance, kMeasuredTypes.size(), assessed));
  }
  for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
    rows.computed.rows.push_back(row_of(
        instance, t, assess(graph, two_bend_paper::draw_real(graph, static_cast<RealType>(t)))));
    rows.rounded.rows.push_back(
        row_of(instance, t, assess(graph, in_bits(reference, kMeasuredTypes[t].bits))));
  }
}

/// The decimal logarithms of what computing misses over what rounding alone does, by type.
std::array<std::vector<double>, kMeasuredTypes.size()> ratios(const Rows& rows) {
  std::array<std::vector<double>, kMeasuredTypes.size()> all;
  for (std::size_t i = 0; i < rows.computed.rows.size(); ++i) {
    const RealRow& computed = rows.computed.rows[i];
    if (computed.setting == kMeasuredTypes.size()) continue;
    const double ratio = computed.log_miss - rows.rounded.rows[i].log_miss;
    if (std::isfinite(ratio)) all.at(computed.setting).push_back(ratio);
  }
  return all;
}

void print_ratios(const Rows& rows) {
  std::vector<std::vector<std::string>> lines;
  const auto all = ratios(rows);
  for (std::size_t t = 0; t < kMeasuredTypes.size(); ++t) {
    const auto at = [&](double part) { return std::pow(10, quantile(all[t], part)); };
    const auto within = std::count_if(all[t].begin(), all[t].end(), [](double ratio) {
      return std::abs(ratio) <= std::log10(2.0) + 1e-9;
    });
    lines.push_back({kMeasuredTypes[t].name, fmt::format("{}", all[t].size()),
                     fmt::format("{:.2g}", at(0.05)), fmt::format("{:.2g}", at(0.5)),
                     fmt::format("{:.2g}", at(0.95)),
                     rate(static_cast<std::uint64_t>(within), all[t].size())});
  }
  fmt::print(
      "The largest miss of a drawing computed in a type over that of the drawing in 237 bits whose "
      "coordinates are rounded to it, quantiles, and how many lie within a factor of 2:\n\n");
  print_table({"type", "drawings", "5 %", "median", "95 %", "within a factor of 2"}, lines);
}

const char* word(OnsetVerdict verdict) {
  switch (verdict) {
    case OnsetVerdict::confirmed:
      return "confirmed";
    case OnsetVerdict::refuted:
      return "refuted";
    case OnsetVerdict::open:
      break;
  }
  return "open";
}

std::string place(double log_n) {
  if (std::isfinite(log_n)) return fmt::format("{:.0f}", std::pow(10, log_n));
  return log_n > 0 ? "beyond" : "least n";
}

using Key = std::tuple<std::string, std::size_t, double>;
std::map<Key, Onset> by_key(const std::vector<Onset>& all) {
  std::map<Key, Onset> onsets;
  for (const Onset& onset : all) {
    onsets[{onset.family, onset.setting, onset.log_limit}] = onset;
  }
  return onsets;
}

void print_onsets(const Rows& rows) {
  const report::MissModel model = report::miss_model(rows.computed);
  const auto by_condition = by_key(report::onsets(rows.computed, model));
  const auto by_rounding = by_key(report::onsets_as_in(rows.computed, rows.rounded, model.setting));
  std::vector<std::vector<std::string>> counts, refuted;
  for (const auto& [name, all] : {std::pair{"C and the family's kappa", &by_condition},
                                  std::pair{"rounding the drawing in 237 bits", &by_rounding}}) {
    std::array<int, 3> count{};
    for (const auto& [key, onset] : *all) ++count.at(static_cast<std::size_t>(onset.verdict));
    counts.push_back({name, fmt::format("{}", all->size()), fmt::format("{}", count[0]),
                      fmt::format("{}", count[1]), fmt::format("{}", count[2])});
  }
  for (const auto& [key, onset] : by_condition) {
    const auto other = by_rounding.find(key);
    const bool is_other_refuted =
        other != by_rounding.end() && other->second.verdict == OnsetVerdict::refuted;
    if (onset.verdict != OnsetVerdict::refuted && !is_other_refuted) continue;
    const bool has_other = other != by_rounding.end();
    refuted.push_back({fmt::format("`{}`", onset.family), kMeasuredTypes.at(onset.setting).name,
                       fmt::format("10^{:.0f}", onset.log_limit), place(onset.log_seen),
                       place(onset.log_predicted), word(onset.verdict),
                       has_other ? place(other->second.log_predicted) : "-",
                       has_other ? word(other->second.verdict) : "-"});
  }
  fmt::print("Onsets that are predicted from drawings in 237 bits, in two ways:\n\n");
  print_table({"predicted from", "onsets", "confirmed", "refuted", "open"}, counts);
  fmt::print("Those that one of the two refutes:\n\n");
  print_table(
      {"family", "type", "degrees", "seen at n", "from C and kappa", "", "from rounding", ""},
      refuted);
}

}  // namespace

void rounding_tables(std::uint64_t most) {
  Rows rows;
  rows.computed.settings = rows.rounded.settings = settings();
  for (const PlannedInstance& instance : plan_study(load_study("precision")).instances) {
    if (instance.requested_n <= most && has_real_types(instance)) add_rows(instance, rows);
  }
  print_ratios(rows);
  print_onsets(rows);
}

}  // namespace ar3d::precision
