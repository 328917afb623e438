// Where misses of two-bend-paper come from: computing in a type, or storing in it. Every graph of
// the study `precision` is drawn in each type, and in 237 bits with the coordinates rounded to that
// type once, at the end. If storing is all that counts, both miss by as much. Where an onset is not
// where a prediction has it, the same drawing times random factors shows how much of that is luck.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <set>
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

/// Onsets, predicted in two ways.
struct Predictions {
  std::map<Key, Onset> by_condition, by_rounding;

  explicit Predictions(const Rows& rows) {
    const report::MissModel model = report::miss_model(rows.computed);
    by_condition = by_key(report::onsets(rows.computed, model));
    by_rounding = by_key(report::onsets_as_in(rows.computed, rows.rounded, model.setting));
  }

  /// Those that one of the two refutes.
  std::set<Key> refuted() const {
    std::set<Key> keys;
    for (const auto* all : {&by_condition, &by_rounding}) {
      for (const auto& [key, onset] : *all) {
        if (onset.verdict == OnsetVerdict::refuted) keys.insert(key);
      }
    }
    return keys;
  }
};

void print_verdicts(const Predictions& predictions) {
  std::vector<std::vector<std::string>> counts;
  for (const auto& [name, all] :
       {std::pair{"C and the family's kappa", &predictions.by_condition},
        std::pair{"rounding the drawing in 237 bits", &predictions.by_rounding}}) {
    std::array<int, 3> count{};
    for (const auto& [key, onset] : *all) ++count.at(static_cast<std::size_t>(onset.verdict));
    counts.push_back({name, fmt::format("{}", all->size()), fmt::format("{}", count[0]),
                      fmt::format("{}", count[1]), fmt::format("{}", count[2])});
  }
  fmt::print("Onsets that are predicted from drawings in 237 bits, in two ways:\n\n");
  print_table({"predicted from", "onsets", "confirmed", "refuted", "open"}, counts);
}

constexpr std::uint64_t kFactors = 20;

/// The drawing times a random factor between 1 and 2, of 65 bits: the same angles and the same
/// condition, but every coordinate rounds otherwise.
RealPoints times_factor(RealPoints points, std::uint64_t seed) {
  constexpr int kFactorBits = 64;
  std::mt19937_64 random(seed);
  const BigInteger factor = BigInteger(random() | 1U) + (BigInteger(1) << kFactorBits);
  points.unit_exponent -= kFactorBits;
  for (std::vector<BigPoint>* list : {&points.vertices, &points.bends}) {
    for (BigPoint& p : *list) p = {p.x * factor, p.y * factor, p.z * factor};
  }
  return points;
}

/// Vertices rounded first, then each bend where it lies from the rounded vertex at its end of the
/// edge (of a single bend: the higher one), as the algorithm computes bends.
RealPoints in_bits_from_vertices(const Graph& graph, const RealPoints& exact, int bits) {
  RealPoints points = exact;
  points.vertices = in_bits(exact, bits).vertices;
  points.bends.clear();
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    const auto [u, v] = graph.edge(e);
    const auto bends = exact.bends_of(e);
    for (std::size_t i = 0; i < bends.size(); ++i) {
      const bool is_alone = bends.size() == 1;
      const bool is_of_u = is_alone ? exact.vertices[u].z > exact.vertices[v].z : i == 0;
      const BigPoint& from = exact.vertices[is_of_u ? u : v];
      const BigPoint& rounded = points.vertices[is_of_u ? u : v];
      points.bends.push_back({rounded.x + (bends[i].x - from.x), rounded.y + (bends[i].y - from.y),
                              rounded.z + (bends[i].z - from.z)});
    }
  }
  return in_bits(std::move(points), bits);
}

/// Of one onset, where the drawings times each factor have it, ascending: log10 n.
struct Spread {
  std::vector<double> all_points, from_vertices;
};

std::string range(std::vector<double> log_ns) {
  if (log_ns.empty()) return "-";
  std::sort(log_ns.begin(), log_ns.end());
  return log_ns.front() == log_ns.back()
             ? place(log_ns.front())
             : fmt::format("{} to {}", place(log_ns.front()), place(log_ns.back()));
}

using Settings = std::map<std::string, std::set<std::size_t>>;  // of each family that is looked at

/// Rows of the drawing times each factor, rounded in the two ways.
class ScaledRows {
 public:
  void add(const PlannedInstance& instance, const Settings& wanted) {
    const auto settings_of = wanted.find(row_of(instance, 0, {}).family);
    if (settings_of == wanted.end()) return;
    const Graph graph = graph_of(instance);
    const RealPoints reference = two_bend_paper::draw_real(graph, RealType::reference);
    for (std::uint64_t f = 0; f < kFactors; ++f) {
      const RealPoints scaled = times_factor(reference, f);
      for (const std::size_t t : settings_of->second) {
        const int bits = kMeasuredTypes.at(t).bits;
        all_points_.at(f).rows.push_back(row_of(instance, t, assess(graph, in_bits(scaled, bits))));
        from_vertices_.at(f).rows.push_back(
            row_of(instance, t, assess(graph, in_bits_from_vertices(graph, scaled, bits))));
      }
    }
  }

  std::map<Key, Spread> spreads(const RealRows& seen) {
    std::map<Key, Spread> all;
    const auto add_onsets = [&](RealRows& rows, std::vector<double> Spread::*part) {
      rows.settings = seen.settings;
      for (const Onset& onset : report::onsets_as_in(seen, rows, kMeasuredTypes.size())) {
        (all[{onset.family, onset.setting, onset.log_limit}].*part).push_back(onset.log_predicted);
      }
    };
    for (RealRows& rows : all_points_) add_onsets(rows, &Spread::all_points);
    for (RealRows& rows : from_vertices_) add_onsets(rows, &Spread::from_vertices);
    return all;
  }

 private:
  std::array<RealRows, kFactors> all_points_, from_vertices_;  // by factor
};

void print_refuted(const Predictions& predictions, const std::map<Key, Spread>& spreads) {
  std::vector<std::vector<std::string>> lines;
  for (const Key& key : predictions.refuted()) {
    const auto cells = [&](const std::map<Key, Onset>& all) -> std::array<std::string, 2> {
      const auto found = all.find(key);
      if (found == all.end()) return {"-", "-"};
      return {place(found->second.log_predicted), word(found->second.verdict)};
    };
    const auto condition = cells(predictions.by_condition);
    const auto rounding = cells(predictions.by_rounding);
    const auto& seen = predictions.by_condition.contains(key) ? predictions.by_condition.at(key)
                                                              : predictions.by_rounding.at(key);
    const Spread& spread = spreads.at(key);
    lines.push_back({fmt::format("`{}`", seen.family), kMeasuredTypes.at(seen.setting).name,
                     fmt::format("10^{:.0f}", seen.log_limit), place(seen.log_seen), condition[0],
                     condition[1], rounding[0], rounding[1], range(spread.all_points),
                     range(spread.from_vertices)});
  }
  fmt::print(
      "Those that one of the two refutes, and where {} drawings have them that are the drawing in "
      "237 bits times a random factor, rounded: all points, or vertices first and bends from "
      "these:\n\n",
      kFactors);
  print_table({"family", "type", "degrees", "seen at n", "from C and kappa", "", "from rounding",
               "", "all points, any factor", "bends from vertices, any factor"},
              lines);
}

}  // namespace

void rounding_tables(std::uint64_t most) {
  Rows rows;
  rows.computed.settings = rows.rounded.settings = settings();
  const PlannedInstances planned = plan_study(load_study("precision")).instances;
  const auto is_wanted = [&](const PlannedInstance& instance) {
    return instance.requested_n <= most && has_real_types(instance);
  };
  for (const PlannedInstance& instance : planned) {
    if (is_wanted(instance)) add_rows(instance, rows);
  }
  print_ratios(rows);
  const Predictions predictions(rows);
  print_verdicts(predictions);
  Settings wanted;
  for (const auto& [family, setting, limit] : predictions.refuted()) {
    wanted[family].insert(setting);
  }
  ScaledRows scaled;
  for (const PlannedInstance& instance : planned) {
    if (is_wanted(instance)) scaled.add(instance, wanted);
  }
  print_refuted(predictions, scaled.spreads(rows.computed));
}

}  // namespace ar3d::precision
