// What accuracy costs: misses of real types, predicted and seen, and what certificates and levels
// of detail take.
#include "ar3d/analysis/report/precision.h"

namespace ar3d::report {
namespace {

using enum CellType;

constexpr std::size_t kMostPoints = 3000;  // of one type in one figure
constexpr std::size_t kMostSizes = 4;      // of the comparison of types
constexpr double kDegrees = 57.29577951308232;

/// 10^x; missing where x is no number.
double power_of_ten(double x) { return std::isfinite(x) ? std::pow(10, x) : kMissing; }

/// log10 of 2^bits radians over degrees: added to a miss it gives roundings of the type.
double to_roundings(int bits) {
  return bits == 0 ? kMissing : bits * std::log10(2.0) - std::log10(kDegrees);
}

using GraphsByRow = std::map<std::size_t, std::pair<std::size_t, const DrawnGraph*>>;

/// The kept graphs, with their curves, by row.
GraphsByRow graphs_by_row(const StudyTally& tally) {
  GraphsByRow graphs;
  for (std::size_t curve = 0; curve < tally.curves.size(); ++curve) {
    for (const auto& [n, size] : tally.curves[curve].sizes) {
      for (const DrawnGraph& graph : size.graphs) graphs[graph.row] = {curve, &graph};
    }
  }
  return graphs;
}

void add_summary(TableMaker& make, const RealRows& real, const MissModel& model,
                 const std::vector<Onset>& all) {
  Table& types = make.start(
      "types", "a real type, or another algorithm that is measured",
      {{"type", "", "its name"}, {"bits", "", "of its significand; 0: not known", integer}});
  for (const RealSetting& setting : real.settings) types.add({setting.name, setting.bits});
  Table& table =
      make.start("precision", "the drawings in real types, all in all",
                 {{"drawings", "", "drawings that were judged without tolerance", integer},
                  {"broken", "", "of them with a crossing or a segment of length zero", integer},
                  {"left_out", "", "further rows", integer},
                  {"family", "", "the family with most graphs, which figures show"},
                  {"model", "", "the type whose drawings predict the others"},
                  {"predictors", "", "its drawings", integer},
                  {"kappa", "", "median of miss / (2^-bits condition), in radians", number, 3},
                  {"kappa_low", "", "its 10 % quantile", number, 3},
                  {"kappa_high", "", "its 90 % quantile", number, 3},
                  {"confirmed", "", "predictions", integer},
                  {"refuted", "", "predictions", integer},
                  {"open", "", "predictions", integer}});
  if (real.rows.empty()) return;
  const auto count = [&](OnsetVerdict verdict) {
    return std::ranges::count(all, verdict, &Onset::verdict);
  };
  const bool predicts = model.drawings > 0;
  table.add({real.rows.size(), std::ranges::count(real.rows, true, &RealRow::is_broken),
             real.left_out, sample_family(real),
             predicts ? TableCell(real.settings[model.setting].name) : TableCell(), model.drawings,
             predicts ? std::pow(10, model.log_kappa[1]) : kMissing,
             predicts ? std::pow(10, model.log_kappa[0]) : kMissing,
             predicts ? std::pow(10, model.log_kappa[2]) : kMissing, count(OnsetVerdict::confirmed),
             count(OnsetVerdict::refuted), count(OnsetVerdict::open)});
}

void add_misses(TableMaker& make, const RealRows& real, const MissModel& model) {
  const std::string family = sample_family(real);
  const GraphsByRow graphs = graphs_by_row(make.analysis.tally);
  Table misses{"misses",
               "a drawing of that family",
               {{"type", "", "its row in types", integer},
                {"n", "vertices", "vertices", integer},
                {"miss", "degrees", "largest miss of an angle; 0: none", number, 4},
                {"roundings", "roundings of the type", "the same", number, 4},
                {"broken", "", "a crossing or a segment of length zero", flag},
                {"row", "", "its row in /runs", integer}}};
  std::map<std::size_t, std::size_t> shown;  // by type
  for (const RealRow& row : real.rows) {
    if (row.family != family || (!make.all && ++shown[row.setting] > kMostPoints)) continue;
    if (const auto at = graphs.find(row.row); at != graphs.end()) {
      make.graphs.add(at->second.first, *at->second.second);
    }
    const double shift = to_roundings(real.settings[row.setting].bits);
    misses.add({row.setting, row.n, std::pow(10, row.log_miss), power_of_ten(row.log_miss + shift),
                row.is_broken, row.row});
  }
  Table medians{"miss_medians",
                "a type and n: medians over the drawings of that family",
                {{"type", "", "its row in types", integer},
                 {"n", "vertices", "n that was asked for", integer},
                 {"miss", "degrees", "median miss", number, 4},
                 {"roundings", "roundings of the type", "the same", number, 4}}};
  for (std::size_t type = 0; type < real.settings.size(); ++type) {
    for (const auto& [n, log_miss] : median_misses(real, type, family)) {
      medians.add({type, n, std::pow(10, log_miss),
                   power_of_ten(log_miss + to_roundings(real.settings[type].bits))});
    }
  }
  Table predicted{"predicted_misses",
                  "n: what the condition predicts, in roundings of a type",
                  {{"n", "vertices", "n that was asked for", integer},
                   {"low", "roundings", "from the 10 % quantile of kappa", number, 4},
                   {"median", "roundings", "from its median", number, 4},
                   {"high", "roundings", "from its 90 % quantile", number, 4}}};
  if (const auto at = model.log_condition.find(family);
      model.drawings > 0 && at != model.log_condition.end()) {
    for (const auto& [n, log_c] : at->second) {
      predicted.add({n, std::pow(10, model.log_kappa[0] + log_c),
                     std::pow(10, model.log_kappa[1] + log_c),
                     std::pow(10, model.log_kappa[2] + log_c)});
    }
  }
  for (Table* table : {&misses, &medians, &predicted}) make.tables.push_back(std::move(*table));
}

void add_onsets(TableMaker& make, const std::vector<Onset>& all) {
  Table& table = make.start(
      "onsets", "a family, a type and a limit: from which n on medians pass it",
      {{"family", "", "the family"},
       {"type", "", "its row in types", integer},
       {"limit", "degrees", "the limit", number},
       {"predicted", "vertices", "from the condition; missing: beyond the sizes", integer},
       {"seen", "vertices", "by interpolation; missing: beyond the sizes", integer},
       {"predicted_at", "", "inside, beyond the largest n, or at the least n"},
       {"seen_at", "", "inside, beyond the largest n, or at the least n"},
       {"first_n", "vertices", "least n that was drawn", integer},
       {"last_n", "vertices", "largest n that was drawn", integer},
       {"verdict", "", "confirmed: within a factor of 2; refuted; open"},
       {"kappa", "", "of the family, which predicts", number, 2},
       {"kappa_seen", "", "of the type where it passes, or at the last n", number, 2}});
  constexpr const char* kVerdicts[] = {"confirmed", "refuted", "open"};
  const auto place = [](double log_n) {
    return std::isfinite(log_n) ? TableCell(std::llround(std::pow(10, log_n))) : TableCell();
  };
  const auto side = [](double log_n) {
    return std::isfinite(log_n) ? "inside" : log_n > 0 ? "beyond" : "least";
  };
  for (const Onset& one : all) {
    table.add({one.family, one.setting, std::pow(10, one.log_limit), place(one.log_predicted),
               place(one.log_seen), side(one.log_predicted), side(one.log_seen),
               place(one.log_first), place(one.log_last), kVerdicts[static_cast<int>(one.verdict)],
               power_of_ten(one.log_kappa), power_of_ten(one.log_kappa_seen)});
  }
}

void add_miss_shares(TableMaker& make, const RealRows& real) {
  struct Shares {
    std::size_t drawings = 0, broken = 0;
    std::array<double, 4> sum{}, whole{};
  };
  std::map<std::pair<std::int64_t, std::size_t>, Shares> all;  // by n and setting
  for (const RealRow& row : real.rows) {
    Shares& shares = all[{row.requested_n, row.setting}];
    ++shares.drawings;
    shares.broken += row.is_broken;
    for (std::size_t i = 0; i < 4; ++i) {
      const double within =
          std::isnan(row.within[i]) ? 1 : row.within[i];  // no angles: none misses
      shares.sum[i] += within;
      shares.whole[i] += within == 1;
    }
  }
  std::vector<TableColumn> columns = {{"n", "vertices", "n that was asked for", integer},
                                      {"type", "", "its row in types", integer},
                                      {"drawings", "", "drawings", integer},
                                      {"broken", "", "of them broken", integer}};
  for (const char* name : {"within_1e_12", "within_1e_9", "within_1e_6", "within_1e_3"}) {
    columns.push_back({name, "", "arithmetic mean over drawings of the share of angles", number});
  }
  for (const char* name : {"all_1e_12", "all_1e_9", "all_1e_6", "all_1e_3"}) {
    columns.push_back({name, "", "share of drawings all of whose angles are within it", number});
  }
  Table& table =
      make.start("miss_shares", "n and a type: angles within so many degrees", std::move(columns));
  for (const auto& [key, shares] : all) {
    std::vector<TableCell> row = {key.first, key.second, shares.drawings, shares.broken};
    for (const auto& sums : {shares.sum, shares.whole}) {
      for (const double sum : sums) row.emplace_back(sum / static_cast<double>(shares.drawings));
    }
    table.add(std::move(row));
  }
}

void add_largest_misses(TableMaker& make, const RealRows& real, const MissModel& model) {
  struct Largest {
    std::int64_t n = -1;
    std::map<std::size_t, double> log_miss;  ///< by setting
    std::vector<double> conditions;
  };
  std::map<std::string, Largest> families;
  for (const RealRow& row : real.rows) {
    Largest& of = families[row.family];
    if (row.requested_n < of.n) continue;
    if (row.requested_n > of.n) of = {row.requested_n, {}, {}};
    double& largest = of.log_miss.try_emplace(row.setting, row.log_miss).first->second;
    largest = std::max(largest, row.log_miss);
    if (row.setting == model.setting) of.conditions.push_back(row.log_condition);
  }
  Table& table = make.start("largest_misses", "a family and a type: graphs of the largest n",
                            {{"family", "", "the family"},
                             {"n", "vertices", "its largest n", integer},
                             {"type", "", "its row in types", integer},
                             {"miss", "degrees", "largest miss of an angle", number, 2},
                             {"bits_lost", "", "log2 of the median condition", number, 3}});
  for (const auto& [family, of] : families) {
    const double bits = median(of.conditions) / std::log10(2.0);
    for (const auto& [setting, log_miss] : of.log_miss) {
      table.add({family, of.n, setting, std::pow(10, log_miss), bits});
    }
  }
}

void add_accuracies(TableMaker& make, const RealRows& real) {
  Table& table = make.start(
      "accuracies", "n and a type: medians over the drawings of that family",
      {{"n", "vertices", "n that was asked for", integer},
       {"type", "", "its row in types", integer},
       {"miss", "degrees", "largest miss of an angle, median", number, 4},
       {"cpu", "s", "CPU time a vertex in the metrics phase, beside other rows", number, 4},
       {"time", "s", "drawing time a vertex; of the timing phase only", number, 4},
       {"front", "", "no other type is faster and more accurate there", flag}});
  const std::string family = sample_family(real);
  const GraphsByRow graphs = graphs_by_row(make.analysis.tally);
  std::map<std::int64_t, std::map<std::size_t, std::array<std::vector<double>, 2>>> times;
  for (const RealRow& row : real.rows) {
    if (row.family != family) continue;
    auto& [cpu, timed] = times[row.requested_n][row.setting];
    const auto n = static_cast<double>(row.n);
    cpu.push_back(row.cpu_s / n);
    const auto at = graphs.find(row.row);
    if (at != graphs.end()) timed.push_back(std::exp(at->second.second->log_timed_s) / n);
  }
  std::vector<std::int64_t> sizes;
  for (const auto& [n, types] : times) sizes.push_back(n);
  for (const std::int64_t n : evenly(sizes, kMostSizes)) {
    std::map<std::size_t, std::pair<double, double>> points;  // by type: time and miss
    for (const auto& [type, both] : times[n]) {
      points[type] = {median(both[1]), std::pow(10, median_misses(real, type, family)[n])};
    }
    for (const auto& [type, point] : points) {
      const bool is_beaten = std::ranges::any_of(points, [&point = point](const auto& other) {
        return other.second != point && other.second.first <= point.first &&
               other.second.second <= point.second;
      });
      table.add({n, type, point.second, median(times[n][type][0]), point.first,
                 !std::isnan(point.first) && !is_beaten});
    }
  }
}

/// Those of many n are put together by bins of n; the key then has the largest n of its bin.
std::map<JudgementKey, Judgements> in_bins(const std::map<JudgementKey, Judgements>& all) {
  constexpr std::size_t kMostBins = 16;
  std::set<std::int64_t> sizes;
  for (const auto& [key, judged] : all) sizes.insert(std::max<std::int64_t>(1, key.n));
  const std::vector<SizeBin> bins = size_bins(sizes, kMostBins);
  std::map<JudgementKey, Judgements> merged;
  for (const auto& [key, judged] : all) {
    JudgementKey mine = key;
    const auto bin =
        std::ranges::find_if(bins, [&n = key.n](const SizeBin& b) { return n <= b.last; });
    if (sizes.size() > kMostBins && bin != bins.end()) mine.n = bin->last;
    Judgements& to = merged[mine];
    to.rows += judged.rows;
    to.violated += judged.violated;
    for (const auto part : {&Judgements::draw_s, &Judgements::store_s, &Judgements::certify_s,
                            &Judgements::peak_bytes}) {
      (to.*part).insert((to.*part).end(), (judged.*part).begin(), (judged.*part).end());
    }
  }
  return merged;
}

void add_judgements(TableMaker& make, const PrecisionRows& rows) {
  std::vector<TableColumn> columns = {
      {"algorithm", "", "with its options"},
      {"n", "vertices", "n that was asked for; of many the largest of a bin", integer},
      {"certificate", "", "how drawings were judged; only exact proves"},
      {"level", "", "what a row stores of its drawing"},
      {"rows", "", "rows", integer},
      {"violated", "", "of them violated", integer},
      {"has_levels", "", "the algorithm has several levels at this n", flag},
      {"bytes", "bytes a vertex", "peak beyond what was resident before, median", number}};
  for (const char* name : {"draw", "draw_low", "draw_high"}) {
    columns.push_back({name, "s a vertex", "CPU time of drawing: median, 10 and 90 %", number, 4});
  }
  for (const char* name : {"store", "store_low", "store_high"}) {
    columns.push_back({name, "s a vertex", "wall time of storing", number, 4});
  }
  for (const char* name : {"certify", "certify_low", "certify_high"}) {
    columns.push_back({name, "s a vertex", "wall time of judging and measuring", number, 4});
  }
  Table& table =
      make.start("judgements", "what a certificate and a level cost", std::move(columns));
  const std::map<JudgementKey, Judgements> judgements = in_bins(rows.judgements);
  std::map<std::pair<std::string, std::int64_t>, std::set<std::string>> levels;
  std::set<std::string> modes;
  bool has_levels = false;
  for (const auto& [key, judged] : judgements) {
    auto& known = levels[{key.algorithm, key.n}];
    known.insert(key.level);
    has_levels |= known.size() > 1;
    if (key.certificate != "measured") modes.insert(key.certificate);
  }
  const bool has_modes = modes.size() > 1 || (modes.size() == 1 && !modes.contains("exact"));
  if (!has_modes && !has_levels) return;
  for (const auto& [key, judged] : judgements) {
    std::vector<TableCell> row = {key.algorithm,
                                  key.n,
                                  key.certificate,
                                  key.level,
                                  judged.rows,
                                  judged.violated,
                                  levels[{key.algorithm, key.n}].size() > 1,
                                  median(judged.peak_bytes)};
    for (const auto* seconds : {&judged.draw_s, &judged.store_s, &judged.certify_s}) {
      for (const double share : {0.5, 0.1, 0.9}) row.emplace_back(quantile(*seconds, share));
    }
    table.add(std::move(row));
  }
}

}  // namespace

void add_precision(TableMaker& make) {
  const PrecisionRows rows = precision_rows(make.analysis);
  const MissModel model = miss_model(rows.real);
  const std::vector<Onset> all = onsets(rows.real, model);
  add_summary(make, rows.real, model, all);
  add_misses(make, rows.real, model);
  add_onsets(make, all);
  add_miss_shares(make, rows.real);
  add_largest_misses(make, rows.real, model);
  add_accuracies(make, rows.real);
  add_judgements(make, rows);
}

}  // namespace ar3d::report
