// A collection of graphs from files: who drew how many, how good the drawings are beside the best
// one of the same graph, medians by n and by group.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostCompared = 6;      // settings of the pairs
constexpr std::size_t kScatterPoints = 1000;  // of two settings
constexpr std::size_t kFewPoints = 100;       // by measures beyond the first two
constexpr double kEqual = 1e-9;               // decimal logarithms closer than that are ties
constexpr std::size_t kOutliers = 3;          // on either side
constexpr std::size_t kMostBins = 16;
constexpr double kProfileEnd = 4;  // decades behind the best
constexpr int kProfileSteps = 80;
constexpr std::size_t kMeasured = 2;  // measures of bins and of scatters with all points

/// A text that sorts as people do, C2 before C10: before a run of digits, without leading zeros,
/// stands how many there are.
std::string as_people_sort(const std::string& name) {
  constexpr std::string_view kDigits = "0123456789";
  std::string key;
  for (std::size_t at = 0; at < name.size();) {
    std::size_t end = std::min(name.find_first_not_of(kDigits, at), name.size());
    if (end > at) {
      at = std::min(name.find_first_not_of('0', at), end);
      key += '0';
      key += static_cast<char>(std::min<std::size_t>(end - at, 255));
    } else {
      ++end;
    }
    key.append(name, at, end - at);
    at = end;
  }
  return key;
}

/// Holds what graphs are compared by: a decimal logarithm, the less the better. Counts, which may
/// be 0, are compared by one more.
struct CollectionMeasure {
  const char* name;
  bool is_larger_better = false;
  bool is_count = false;

  double value(double log10) const { return std::pow(10, log10) - (is_count ? 1 : 0); }
};
constexpr std::array<CollectionMeasure, 8> kCompared = {{{"volume"},
                                                         {"drawing time"},
                                                         {"total edge length"},
                                                         {"smallest angle at a vertex", true},
                                                         {"smallest angle at a bend", true},
                                                         {"longest over mean edge"},
                                                         {"crossings", false, true},
                                                         {"bends", false, true}}};

/// A drawing of a graph, and its logarithms in the order of kCompared.
using CollectionDrawing = std::pair<const DrawnGraph*, std::array<double, kCompared.size()>>;

/// What the settings of a collection made of one graph, by setting.
using CollectionGraph = std::map<std::size_t, CollectionDrawing>;

const DrawnGraph& first_of(const CollectionGraph& drawn) { return *drawn.begin()->second.first; }
std::int64_t size_of(const CollectionGraph& drawn) {
  return std::max<std::int64_t>(1, first_of(drawn).n);
}

/// The graphs of one name with parameters, all that the tally keeps.
struct Collection {
  std::string family;
  std::vector<std::pair<std::size_t, const SectionCurve*>> settings;  // with their sections
  bool is_relative = false, is_timed = true;
  std::map<std::pair<std::uint64_t, std::int64_t>, CollectionGraph> graphs;  // by seed and index

  std::array<double, kCompared.size()> logs_of(const DrawnGraph& graph) const {
    const auto log = [&](const char* name) {
      return decimal(log_positive(metric_of(graph, name)));
    };
    return {(is_relative ? graph.log2_relative_volume : graph.log2_volume) * std::log10(2),
            is_timed ? decimal(graph.log_timed_s) : kMissing,
            log("total_edge_length") - log("smallest_vertex_distance"),
            log("smallest_vertex_angle"),
            log("smallest_bend_angle"),
            log("longest_edge_length") - log("total_edge_length") +
                decimal(log_positive(static_cast<double>(graph.m))),
            std::log10(1 + metric_of(graph, "crossings")),
            std::log10(1 + bends_of(graph))};
  }
};

/// The collections of the study, in the order of the file.
std::vector<Collection> collections_of(const std::vector<Section>& sections) {
  std::vector<Collection> all;
  std::map<std::string, std::size_t> index_of;
  for (std::size_t section = 0; section < sections.size(); ++section) {
    for (const SectionCurve& curve : sections[section].curves) {
      if (!curve.is_collection) continue;
      const auto [at, is_new] = index_of.try_emplace(curve.family, all.size());
      if (is_new) all.emplace_back().family = curve.family;
      Collection& collection = all[at->second];
      const std::size_t setting = collection.settings.size();
      collection.settings.emplace_back(section, &curve);
      collection.is_relative |= sections[section].has_own_unit;
      collection.is_timed &= curve.tally->has_timing_rows;
      for (const auto& [n, size] : curve.tally->sizes) {
        for (const DrawnGraph& graph : size.graphs) {
          collection.graphs[{graph.seed, graph.instance}][setting].first = &graph;
        }
      }
    }
  }
  for (Collection& collection : all) {
    for (auto& [key, drawn] : collection.graphs) {
      for (auto& [setting, drawing] : drawn) drawing.second = collection.logs_of(*drawing.first);
    }
  }
  return all;
}

/// What two settings made of one graph.
using GraphPair = std::array<const CollectionDrawing*, 2>;

/// The second value over the first, as a logarithm.
double ratio_of(const GraphPair& pair, std::size_t measure) {
  return pair[1]->second[measure] - pair[0]->second[measure];
}

/// In increasing order of the second value over the first.
std::vector<GraphPair> pairs_of(const Collection& collection, std::size_t measure, std::size_t a,
                                std::size_t b) {
  std::vector<GraphPair> pairs;
  const auto ratio = [&](const GraphPair& pair) { return ratio_of(pair, measure); };
  for (const auto& [key, drawn] : collection.graphs) {
    const auto one = drawn.find(a), other = drawn.find(b);
    if (one == drawn.end() || other == drawn.end()) continue;
    const GraphPair pair{&one->second, &other->second};
    if (!std::isnan(ratio(pair))) pairs.push_back(pair);
  }
  std::ranges::stable_sort(pairs, {}, ratio);
  return pairs;
}

/// Returns those with the least and the largest ratios.
std::vector<GraphPair> outliers(const std::vector<GraphPair>& pairs) {
  if (pairs.size() <= 2 * kOutliers) return pairs;
  std::vector<GraphPair> ends(pairs.begin(), pairs.begin() + kOutliers);
  ends.insert(ends.end(), pairs.end() - kOutliers, pairs.end());
  return ends;
}

/// Calls use(a, b) for every two settings that pairs are made of.
template <class Use>
void for_each_pair(const Collection& collection, const Use& use) {
  const std::size_t settings = std::min(kMostCompared, collection.settings.size());
  for (std::size_t a = 0; a < settings; ++a) {
    for (std::size_t b = a + 1; b < settings; ++b) use(a, b);
  }
}

void add_drawn(const Collection& of, Table& table) {
  for (const auto& [setting, curve] : of.settings) {
    const CurveTally& tally = *curve->tally;
    std::size_t drawn = 0;
    for (const auto& [n, size] : tally.sizes) drawn += size.drawn;
    const std::size_t unfinished = tally.count(RunStatus::timeout) +
                                   tally.count(RunStatus::out_of_memory) +
                                   tally.count(RunStatus::crashed);
    table.add({of.family, setting,
               of.is_relative ? "cubes of the smallest vertex distance" : "lattice points",
               tally.instances, drawn,
               static_cast<double>(drawn) / static_cast<double>(tally.instances),
               tally.count(RunStatus::refused), tally.violations, unfinished});
  }
}

/// The share of graphs that each setting draws within a factor of the best (Dolan and Moré,
/// Benchmarking optimization software with performance profiles, Mathematical Programming 91,
/// 2002).
void add_profile(const Collection& of, std::size_t measure, bool is_common, Table& table) {
  std::vector<std::vector<double>> behind(of.settings.size());
  std::size_t graphs = 0;
  for (const auto& [key, drawn] : of.graphs) {
    if (is_common && drawn.size() < of.settings.size()) continue;
    double best = kMissing;
    std::vector<std::pair<std::size_t, double>> costs;
    for (const auto& [setting, drawing] : drawn) {
      const double value = drawing.second[measure];
      if (std::isnan(value)) continue;
      costs.emplace_back(setting, kCompared[measure].is_larger_better ? -value : value);
      best = std::fmin(best, costs.back().second);
    }
    graphs += !costs.empty();
    for (const auto& [setting, cost] : costs) behind[setting].push_back(cost - best);
  }
  double end = 0.1;
  for (std::vector<double>& decades : behind) {
    std::ranges::sort(decades);
    if (!decades.empty()) end = std::max(end, std::min(kProfileEnd, decades.back()));
  }
  for (std::size_t s = 0; s < behind.size(); ++s) {
    for (int step = 0; step <= kProfileSteps && !behind[s].empty(); ++step) {
      const double x = end * step / kProfileSteps;
      const auto within = std::ranges::upper_bound(behind[s], x + 1e-9) - behind[s].begin();
      table.add({of.family, kCompared[measure].name, of.settings[s].first, std::pow(10, x),
                 static_cast<double>(within) / static_cast<double>(graphs), graphs});
    }
  }
}

void add_pairs(TableMaker& make, const Collection& of, std::size_t measure,
               std::size_t most_points) {
  Table &pairs = make.table("pairs"), &pair_counts = make.table("pair_counts");
  for_each_pair(of, [&](std::size_t a, std::size_t b) {
    const std::vector<GraphPair> all = pairs_of(of, measure, a, b);
    if (all.empty()) return;
    const std::size_t one = of.settings[a].first, other = of.settings[b].first;
    std::vector<double> ratios;
    std::size_t below = 0, above = 0;
    for (const GraphPair& pair : all) {
      const double ratio = ratio_of(pair, measure);
      ratios.push_back(std::pow(10, ratio));
      below += ratio < -kEqual;
      above += ratio > kEqual;
    }
    const Interval interval = median_interval(ratios);
    pair_counts.add({of.family, kCompared[measure].name, one, other, all.size(),
                     static_cast<double>(above) / static_cast<double>(all.size()),
                     all.size() - above - below, median(ratios), interval.low, interval.high,
                     sign_test(below, above)});
    const auto add = [&](const GraphPair& pair, bool is_outlier) {
      pairs.add({of.family, kCompared[measure].name, one, other,
                 kCompared[measure].value(pair[0]->second[measure]),
                 kCompared[measure].value(pair[1]->second[measure]),
                 std::pow(10, ratio_of(pair, measure)),
                 make.add_graph(of.settings[a].second->index, *pair[0]->first),
                 make.add_graph(of.settings[b].second->index, *pair[1]->first), is_outlier});
    };
    for (const GraphPair& pair : outliers(all)) add(pair, true);
    for (const GraphPair& pair : evenly(all, most_points)) add(pair, false);
  });
}

void add_bins(const Collection& of, std::size_t measure, Table& table) {
  std::set<std::int64_t> all_n;
  for (const auto& [key, drawn] : of.graphs) all_n.insert(size_of(drawn));
  for (const auto& [first, last, n] : size_bins(all_n, kMostBins)) {
    std::map<std::size_t, std::vector<double>> values;
    for (const auto& [key, drawn] : of.graphs) {
      if (size_of(drawn) < first || size_of(drawn) > last) continue;
      for (const auto& [setting, drawing] : drawn) {
        const double value = drawing.second[measure];
        if (!std::isnan(value)) values[setting].push_back(value);
      }
    }
    for (auto& [setting, logs] : values) {
      table.add({of.family, kCompared[measure].name, of.settings[setting].first, n,
                 kCompared[measure].value(median(std::move(logs)))});
    }
  }
}

void add_groups(const Collection& of, std::size_t measure, Table& table) {
  std::map<std::pair<std::string, std::string>, std::vector<const CollectionGraph*>> groups;
  for (const auto& [key, drawn] : of.graphs) {
    const std::string& group = first_of(drawn).group;
    const std::string name = group.empty() ? "(no group)" : group;
    groups[{as_people_sort(name), name}].push_back(&drawn);
  }
  if (groups.size() == 1 && first_of(*groups.begin()->second.front()).group.empty()) return;
  for (const auto& [name, graphs] : groups) {
    std::map<std::size_t, std::vector<double>> values_of;  // by setting
    for (const CollectionGraph* drawn : graphs) {
      for (const auto& [setting, drawing] : *drawn) {
        const double value = drawing.second[measure];
        if (!std::isnan(value)) values_of[setting].push_back(kCompared[measure].value(value));
      }
    }
    for (const auto& [setting, values] : values_of) {
      table.add({of.family, kCompared[measure].name, name.second, graphs.size(),
                 of.settings[setting].first, median(values), quantile(values, 0.1),
                 quantile(values, 0.9)});
    }
  }
}

}  // namespace

void add_collections(TableMaker& make) {
  for (const Collection& collection : collections_of(make.sections)) {
    add_drawn(collection, make.table("collections"));
    for (std::size_t m = 0; m < kCompared.size(); ++m) {
      const bool is_first = m < kMeasured;
      add_profile(collection, m, false, make.table("profile"));
      add_profile(collection, m, true, make.table("common_profile"));
      add_groups(collection, m, make.table("group_medians"));
      add_pairs(make, collection, m, is_first ? kScatterPoints : kFewPoints);
      if (is_first) add_bins(collection, m, make.table("bins"));
    }
  }
}

std::vector<std::size_t> collection_outliers(const std::vector<Section>& sections) {
  std::vector<std::size_t> rows;
  for (const Collection& collection : collections_of(sections)) {
    for_each_pair(collection, [&](std::size_t a, std::size_t b) {
      for (const GraphPair& pair : outliers(pairs_of(collection, 0, a, b))) {
        for (const CollectionDrawing* drawing : pair) rows.push_back(drawing->first->row);
      }
    });
  }
  return rows;
}

}  // namespace ar3d::report
