// What settings trade: volume and time at every n, where one algorithm begins to need less volume
// than another, and what effort buys.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {
namespace {

using enum CellType;

constexpr std::size_t kFewestGraphs = 8;  // on either side of a crossing

/// One setting at one n of a group.
struct TradePoint {
  double log_n = 0, volume = kMissing, time = kMissing;  // decimal logarithms
};
using TradeLine = std::vector<TradePoint>;

/// At each n over the families that all settings with this n drew there, by setting.
std::vector<TradeLine> trade_lines(const SettingGroup& group) {
  std::vector<TradeLine> lines(group.settings.size());
  for (const std::int64_t n : group.sizes()) {
    const SettingGroup there = group.at(n);
    if (there.families.empty()) continue;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!group.settings[i]->sizes.contains(n)) continue;
      const Median medians = over(*group.settings[i], n, there);
      if (!std::isnan(medians.volume)) {
        lines[i].push_back({log10_of(n), medians.volume, medians.time});
      }
    }
  }
  return lines;
}

/// Where one setting falls below another one for good within their common sizes.
struct Crossing {
  std::size_t below = 0, above = 0;  // in the group
  double log_n = 0, volume = 0;
  std::size_t graphs = 0, smaller = 0;  // beyond it, that both drew; of them with less volume
};

/// Counts the graphs on either side. True if they bear the crossing out: enough of them, most of
/// those beyond it with less volume, and most of the others without.
bool is_borne_out(const SettingGroup& group, Crossing& crossing) {
  std::size_t before = 0, smaller_before = 0;
  for (const PairedGraph& graph :
       paired_graphs(*group.settings[crossing.below], *group.settings[crossing.above], group)) {
    const bool is_beyond = graph.log_n > crossing.log_n;
    ++(is_beyond ? crossing.graphs : before);
    (is_beyond ? crossing.smaller : smaller_before) += graph.log_ratio < 0;
  }
  return std::min(before, crossing.graphs) >= kFewestGraphs &&
         10 * crossing.smaller >= 9 * crossing.graphs && 2 * smaller_before < before;
}

void add_crossing(const std::vector<TradeLine>& lines, std::size_t a, std::size_t b,
                  std::vector<Crossing>& crossings) {
  std::map<double, double> other;
  for (const TradePoint& point : lines[b]) other[point.log_n] = point.volume;
  double last_n = kMissing, last_gap = kMissing, last_volume = kMissing;
  Crossing found;
  bool has_any = false;
  for (const TradePoint& point : lines[a]) {
    const auto at = other.find(point.log_n);
    if (at == other.end()) continue;
    const double gap = point.volume - at->second;
    if (!std::isnan(last_gap) && (gap < 0) != (last_gap < 0) && gap != last_gap) {
      const double part = last_gap / (last_gap - gap);
      found = {gap < 0 ? a : b, gap < 0 ? b : a, last_n + part * (point.log_n - last_n),
               last_volume + part * (point.volume - last_volume)};
      has_any = true;
    }
    last_n = point.log_n, last_gap = gap, last_volume = point.volume;
  }
  if (has_any) crossings.push_back(found);
}

/// The last crossing of every two lines of different algorithms that the graphs bear out.
std::vector<Crossing> crossings_of(const SettingGroup& group, const std::vector<TradeLine>& lines) {
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (group.settings[i]->algorithm == group.settings[j]->algorithm) continue;
      add_crossing(lines, i, j, crossings);
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
    if (!section.theorem) continue;
    double order = 0;
    for (const AxisBound& axis : section.theorem->axes) {
      order += axis.numerator == 0 ? 0 : axis.half_power / 2.0;
    }
    least = std::min(least, order);
  }
  return least;
}

/// True if no other setting there is both smaller and faster.
bool is_on_front(const std::vector<TradeLine>& lines, const TradePoint& point) {
  if (std::isnan(point.time)) return false;
  for (const TradeLine& line : lines) {
    for (const TradePoint& other : line) {
      if (other.log_n != point.log_n || std::isnan(other.time)) continue;
      const bool is_no_worse = other.time <= point.time && other.volume <= point.volume;
      if (is_no_worse && (other.time < point.time || other.volume < point.volume)) return false;
    }
  }
  return true;
}

struct TradeTables {
  Table groups{"groups",
               "settings that can be compared, with the families that all of them drew",
               {{"settings", "", "settings", integer},
                {"families", "", "families", integer},
                {"family", "", "the family, if it is one"},
                {"unit", "", "of volumes"},
                {"order", "", "figures divide volumes by n to this", number}}};
  Table trade{"trade",
              "a group, n and a setting: medians over graphs, then over families",
              {{"group", "", "its row in groups", integer},
               {"n", "vertices", "n that was asked for", integer},
               {"setting", "", "its row in settings", integer},
               {"volume", "", "in the group's unit", number},
               {"over", "", "the same over n to the group's order", number},
               {"time", "s", "drawing time; of the timing phase only", number, 4},
               {"bends", "", "largest number of bends of an edge", integer},
               {"front", "", "no other setting is smaller and faster", flag}}};
  Table crossings{"crossings",
                  "two settings: from which n on one needs less volume",
                  {{"group", "", "its row in groups", integer},
                   {"below", "", "the one that needs less, its row in settings", integer},
                   {"above", "", "the other one", integer},
                   {"n", "vertices", "from about here on", integer},
                   {"over", "", "the volume there over n to the group's order", number},
                   {"graphs", "", "graphs beyond it that both drew", integer},
                   {"smaller", "", "of them with less volume", integer}}};

  void add(const SettingGroup& group, double order) {
    const std::vector<TradeLine> lines = trade_lines(group);
    if (std::ranges::count_if(lines, [](const TradeLine& line) { return !line.empty(); }) < 2) {
      return;
    }
    const std::size_t place = groups.size();
    const std::size_t families = count_families(group.families);
    groups.add({group.settings.size(), families,
                families == 1 ? TableCell(*group.families.begin()) : TableCell(),
                group.is_relative ? "cubes of the smallest vertex distance" : "lattice points",
                order});
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const TradePoint& point : lines[i]) {
        trade.add({place, std::llround(std::pow(10, point.log_n)), group.settings[i]->place,
                   std::pow(10, point.volume), std::pow(10, point.volume - order * point.log_n),
                   std::pow(10, point.time), group.settings[i]->bends, is_on_front(lines, point)});
      }
    }
    for (const Crossing& crossing : crossings_of(group, lines)) {
      crossings.add({place, group.settings[crossing.below]->place,
                     group.settings[crossing.above]->place,
                     std::llround(std::pow(10, crossing.log_n)),
                     std::pow(10, crossing.volume - order * crossing.log_n), crossing.graphs,
                     crossing.smaller});
    }
  }
};

/// Efforts of one algorithm at the largest n that two of them drew, over what the first one needs.
void add_efforts(const std::vector<ComparedSetting>& settings, Table& table) {
  std::map<std::string, SettingGroup> efforts;
  for (const ComparedSetting& setting : settings) {
    const bool is_level = setting.label.find("level=") != std::string::npos;
    if (is_level || setting.label.find("effort=") == std::string::npos) continue;
    SettingGroup& group = efforts[setting.algorithm];
    group.settings.push_back(&setting);
    for (const auto& [n, families] : setting.sizes) {
      for (const auto& [family, medians] : families) group.families.insert(family);
    }
  }
  for (const auto& [algorithm, group] : efforts) {
    const std::vector<std::int64_t> sizes = group.sizes();
    for (auto n = sizes.rbegin(); n != sizes.rend(); ++n) {
      const SettingGroup there = group.at(*n);
      if (there.settings.size() < 2 || there.families.empty()) continue;
      const Median first = over(*there.settings.front(), *n, there);
      for (const ComparedSetting* setting : there.settings) {
        const Median own = over(*setting, *n, there);
        table.add({setting->place, algorithm, *n, std::pow(10, own.time - first.time),
                   std::pow(10, own.volume - first.volume)});
      }
      break;
    }
  }
}

}  // namespace

void add_trade(TableMaker& make) {
  const std::vector<ComparedSetting> settings = settings_of(make.sections);
  TradeTables tables;
  for (const SettingGroup& group : groups_of(settings))
    tables.add(group, least_order(make.sections));
  for (Table* table : {&tables.groups, &tables.trade, &tables.crossings}) {
    make.tables.push_back(std::move(*table));
  }
  add_efforts(settings,
              make.start("efforts", "a setting beside its algorithm's first effort",
                         {{"setting", "", "its row in settings", integer},
                          {"algorithm", "", "the algorithm"},
                          {"n", "vertices", "the largest n of two efforts", integer},
                          {"time", "", "times its time; of the timing phase only", number, 4},
                          {"volume", "", "times its volume", number, 4}}));
}

}  // namespace ar3d::report
