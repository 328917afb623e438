// What settings trade: which of them can be compared, on which families; volume and time at every
// n, where one algorithm begins to need less volume than another, and what effort buys.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostGroups = 4;
constexpr std::size_t kFewestGraphs = 8;  // on either side of a crossing

/// Decimal logarithms of volume and drawing time, medians; times are those of the timing phase.
struct Median {
  double volume = kMissing;           ///< lattice points of the box
  double relative_volume = kMissing;  ///< in cubes of the smallest distance of vertices
  double time = kMissing;
};

/// Names the graphs of a family with one n.
using FamilySize = std::pair<std::string, std::int64_t>;

/// Holds what one setting did on every family but collections, by the n of bins_of_study: medians
/// over graphs. Sizes with an unfinished graph are left out.
struct ComparedSetting {
  const Section* section = nullptr;
  std::size_t index = 0;  ///< in the sections
  std::size_t bends = 0;  ///< largest number of bends per edge
  std::map<std::int64_t, std::map<FamilySize, Median>> sizes;
};

/// Settings that can be compared, the families that all of them drew, and at one bin the graphs.
struct SettingGroup {
  std::vector<const ComparedSetting*> settings;
  std::set<std::string> families;
  std::set<FamilySize> common;
  /// Some setting has a unit of its own, so that all volumes are over the smallest distance of
  /// vertices.
  bool is_relative = false;

  /// The settings with this n, and the graphs of the families that all of these drew there.
  SettingGroup at(std::int64_t n) const {
    SettingGroup there{{}, families, {}, is_relative};
    for (const ComparedSetting* setting : settings) {
      const auto size = setting->sizes.find(n);
      if (size == setting->sizes.end()) continue;
      for (const auto& [graphs, medians] : size->second) {
        if (there.settings.empty() && families.contains(graphs.first)) there.common.insert(graphs);
      }
      there.settings.push_back(setting);
      std::erase_if(there.common,
                    [&](const FamilySize& graphs) { return !size->second.contains(graphs); });
    }
    return there;
  }

  std::set<std::int64_t> sizes() const {
    std::set<std::int64_t> all;
    for (const ComparedSetting* setting : settings) {
      for (const auto& [n, medians] : setting->sizes) all.insert(n);
    }
    return all;
  }

  /// The median of a setting's medians over the common graphs at an n that it has; `volume` is the
  /// relative one if the group's are.
  Median over(const ComparedSetting& setting, std::int64_t n) const {
    std::vector<double> volumes, times;
    for (const FamilySize& graphs : common) {
      const Median& medians = setting.sizes.at(n).at(graphs);
      volumes.push_back(is_relative ? medians.relative_volume : medians.volume);
      times.push_back(medians.time);
    }
    return {median(std::move(volumes)), kMissing, median(std::move(times))};
  }
};

double median_of(const SizeTally& size, Quantity quantity) {
  std::vector<double> logs;
  for (const DrawnGraph& graph : size.graphs) logs.push_back(log_value(graph, quantity, true));
  return decimal(median(std::move(logs)));
}

double log10_volume(const DrawnGraph& graph, bool is_relative) {
  return (is_relative ? graph.log2_relative_volume : graph.log2_volume) * std::log10(2);
}

double median_relative_volume(const SizeTally& size) {
  std::vector<double> logs;
  for (const DrawnGraph& graph : size.graphs) {
    if (std::isfinite(graph.log2_relative_volume)) logs.push_back(log10_volume(graph, true));
  }
  return median(std::move(logs));
}

std::vector<ComparedSetting> settings_of(const std::vector<Section>& sections,
                                         const std::vector<SizeBin>& bins) {
  std::vector<ComparedSetting> settings;
  for (const Section& section : sections) {
    ComparedSetting& setting = settings.emplace_back();
    setting.section = &section;
    setting.index = settings.size() - 1;
    for (const SectionCurve& curve : section.curves) {
      if (curve.is_collection) continue;  // compared graph by graph
      setting.bends = std::max(setting.bends, most_bends(curve.tally->bends));
      for (const auto& [n, size] : curve.tally->sizes) {
        if (size.drawn == 0 || size.censored || n < 1) continue;
        const double time =
            curve.tally->has_timing_rows ? median_of(size, Quantity::wall_s) : kMissing;
        const Median medians{median_of(size, Quantity::volume), median_relative_volume(size), time};
        if (std::isnan(medians.volume)) continue;
        setting.sizes[bin_of(bins, n).n][{curve.family, n}] = medians;
      }
    }
  }
  return settings;
}

/// At most kMostGroups groups of at least two settings, none of which could have another setting
/// without losing families; most algorithms first, then most settings.
std::vector<SettingGroup> groups_of(const std::vector<ComparedSetting>& settings) {
  using SettingSet = std::set<const ComparedSetting*>;
  std::map<std::string, SettingSet> drawn_by;  // by family
  for (const ComparedSetting& setting : settings) {
    for (const auto& [n, graphs] : setting.sizes) {
      for (const auto& [of, medians] : graphs) drawn_by[of.first].insert(&setting);
    }
  }
  std::map<SettingSet, std::set<std::string>> families_of;
  for (const auto& [family, by] : drawn_by) families_of[by].insert(family);
  std::vector<SettingGroup> groups;
  for (const auto& [one, own] : families_of) {
    const bool is_largest = std::ranges::none_of(families_of, [&one = one](const auto& other) {
      return other.first != one && std::ranges::includes(other.first, one);
    });
    if (!is_largest || one.size() < 2) continue;
    const bool is_relative = std::ranges::any_of(
        one, [](const ComparedSetting* setting) { return setting->section->has_own_unit; });
    groups.push_back({{one.begin(), one.end()}, own, {}, is_relative});
  }
  std::ranges::stable_sort(groups, std::greater(), [](const SettingGroup& group) {
    std::set<std::string> algorithms;
    for (const ComparedSetting* setting : group.settings) {
      algorithms.insert(setting->section->algorithm);
    }
    return std::tuple(algorithms.size(), group.settings.size(), group.families.size());
  });
  if (groups.size() > kMostGroups) groups.resize(kMostGroups);
  return groups;
}

/// Volumes by family, n, seed and index, which make two rows rows of one graph.
using GraphVolumes =
    std::map<std::tuple<std::string, std::int64_t, std::uint64_t, std::int64_t>, double>;

GraphVolumes volumes_of(const ComparedSetting& setting, const SettingGroup& group) {
  GraphVolumes volumes;
  for (const SectionCurve& curve : setting.section->curves) {
    if (!group.families.contains(curve.family)) continue;
    for (const auto& [n, size] : curve.tally->sizes) {
      for (const DrawnGraph& graph : size.graphs) {
        volumes.try_emplace({curve.family, n, graph.seed, graph.instance},
                            log10_volume(graph, group.is_relative));
      }
    }
  }
  return volumes;
}

/// One setting of a group, by n.
using TradeLine = std::map<std::int64_t, Median>;

/// At each n over the graphs that all settings with this n drew there, by setting.
std::vector<TradeLine> trade_lines(const SettingGroup& group) {
  std::vector<TradeLine> lines(group.settings.size());
  for (const std::int64_t n : group.sizes()) {
    const SettingGroup there = group.at(n);
    if (there.common.empty()) continue;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!group.settings[i]->sizes.contains(n)) continue;
      const Median medians = there.over(*group.settings[i], n);
      if (!std::isnan(medians.volume)) lines[i][n] = medians;
    }
  }
  return lines;
}

/// Holds where one setting falls below another one for good within their common sizes.
struct Crossing {
  std::size_t below = 0, above = 0;  // in the group
  double log_n = 0, volume = 0;
  std::size_t graphs = 0, smaller = 0;  // beyond it, that both drew; of them with less volume
};

/// Counts the graphs on either side. True if they bear the crossing out: enough of them, most of
/// those beyond it with less volume, and most of the others without.
bool is_borne_out(const SettingGroup& group, Crossing& crossing) {
  std::size_t before = 0, smaller_before = 0;
  const GraphVolumes above = volumes_of(*group.settings[crossing.above], group);
  for (const auto& [graph, volume] : volumes_of(*group.settings[crossing.below], group)) {
    const auto other = above.find(graph);
    if (other == above.end() || std::isnan(volume - other->second)) continue;
    const bool is_beyond = log10_of(std::get<1>(graph)) > crossing.log_n;
    ++(is_beyond ? crossing.graphs : before);
    (is_beyond ? crossing.smaller : smaller_before) += volume < other->second;
  }
  return std::min(before, crossing.graphs) >= kFewestGraphs &&
         10 * crossing.smaller >= 9 * crossing.graphs && 2 * smaller_before < before;
}

std::optional<Crossing> last_crossing(const std::vector<TradeLine>& lines, std::size_t a,
                                      std::size_t b) {
  double last_n = kMissing, last_gap = kMissing, last_volume = kMissing;
  std::optional<Crossing> found;
  for (const auto& [n, point] : lines[a]) {
    const auto at = lines[b].find(n);
    if (at == lines[b].end()) continue;
    const double log_n = log10_of(n), gap = point.volume - at->second.volume;
    if (!std::isnan(last_gap) && (gap < 0) != (last_gap < 0) && gap != last_gap) {
      const double part = last_gap / (last_gap - gap);
      found = {gap < 0 ? a : b, gap < 0 ? b : a, last_n + part * (log_n - last_n),
               last_volume + part * (point.volume - last_volume)};
    }
    last_n = log_n, last_gap = gap, last_volume = point.volume;
  }
  return found;
}

/// The last crossing of every two lines of different algorithms that the graphs bear out.
std::vector<Crossing> crossings_of(const SettingGroup& group, const std::vector<TradeLine>& lines) {
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto& algorithm = group.settings[i]->section->algorithm;
      if (algorithm == group.settings[j]->section->algorithm) continue;
      if (const auto found = last_crossing(lines, i, j)) crossings.push_back(*found);
    }
  }
  std::erase_if(crossings, [&](Crossing& crossing) { return !is_borne_out(group, crossing); });
  std::ranges::sort(crossings, {}, &Crossing::log_n);
  return crossings;
}

/// The least order of a theorem's volume: figures divide by n to it.
double least_order(const std::vector<Section>& sections) {
  double least = 3;
  for (const Section& section : sections) {
    if (section.theorem) least = std::min(least, order_of(section, Quantity::volume));
  }
  return least;
}

/// True if no other setting there is both smaller and faster.
bool is_on_front(const std::vector<TradeLine>& lines, std::int64_t n, const Median& point) {
  if (std::isnan(point.time)) return false;
  for (const TradeLine& line : lines) {
    const auto other = line.find(n);
    if (other == line.end() || std::isnan(other->second.time)) continue;
    const auto& [volume, relative_volume, time] = other->second;
    const bool is_no_worse = time <= point.time && volume <= point.volume;
    if (is_no_worse && (time < point.time || volume < point.volume)) return false;
  }
  return true;
}

void add_group(const SettingGroup& group, double order, TableMaker& make) {
  const std::vector<TradeLine> lines = trade_lines(group);
  if (std::ranges::count_if(lines, [](const TradeLine& line) { return !line.empty(); }) < 2) {
    return;
  }
  Table& groups = make.table("groups");
  const std::size_t index = groups.size();
  const std::size_t families = count_families(group.families);
  groups.add({group.settings.size(), families,
              families == 1 ? TableCell(*group.families.begin()) : TableCell(),
              group.is_relative ? "cubes of the smallest vertex distance" : "lattice points",
              order});
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const auto& [n, point] : lines[i]) {
      const SizeBin& bin = bin_of(make.bins, n);
      make.table("trade").add({index, n, group.settings[i]->index, std::pow(10, point.volume),
                               std::pow(10, point.volume - order * log10_of(n)),
                               std::pow(10, point.time), group.settings[i]->bends,
                               is_on_front(lines, n, point), bin.first, bin.last});
    }
  }
  for (const Crossing& crossing : crossings_of(group, lines)) {
    make.table("crossings")
        .add({index, group.settings[crossing.below]->index, group.settings[crossing.above]->index,
              std::llround(std::pow(10, crossing.log_n)),
              std::pow(10, crossing.volume - order * crossing.log_n), crossing.graphs,
              crossing.smaller});
  }
}

/// Efforts of one algorithm at the largest n that two of them drew, over what the first one needs.
void add_efforts(const std::vector<ComparedSetting>& settings, Table& table) {
  std::map<std::string, SettingGroup> efforts;
  for (const ComparedSetting& setting : settings) {
    const std::string& label = setting.section->label;
    const bool is_level = label.find("level=") != std::string::npos;
    if (is_level || label.find("effort=") == std::string::npos) continue;
    SettingGroup& group = efforts[setting.section->algorithm];
    group.settings.push_back(&setting);
    for (const auto& [n, graphs] : setting.sizes) {
      for (const auto& [of, medians] : graphs) group.families.insert(of.first);
    }
  }
  for (const auto& [algorithm, group] : efforts) {
    const std::set<std::int64_t> sizes = group.sizes();
    for (auto n = sizes.rbegin(); n != sizes.rend(); ++n) {
      const SettingGroup there = group.at(*n);
      if (there.settings.size() < 2 || there.common.empty()) continue;
      const std::int64_t largest = std::ranges::max(there.common, {}, &FamilySize::second).second;
      const Median first = there.over(*there.settings.front(), *n);
      for (const ComparedSetting* setting : there.settings) {
        const Median own = there.over(*setting, *n);
        table.add({setting->index, algorithm, largest, std::pow(10, own.time - first.time),
                   std::pow(10, own.volume - first.volume)});
      }
      break;
    }
  }
}

}  // namespace

void add_trade(TableMaker& make) {
  const std::vector<ComparedSetting> settings = settings_of(make.sections, make.bins);
  for (const SettingGroup& group : groups_of(settings)) {
    add_group(group, least_order(make.sections), make);
  }
  add_efforts(settings, make.table("efforts"));
}

}  // namespace ar3d::report
