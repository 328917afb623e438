// Settings that can be compared: on which families, and what each did there.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostGroups = 4;

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

/// Family, requested n, seed and index: what makes two rows rows of one graph.
using ComparedGraph = std::tuple<std::string, std::int64_t, std::uint64_t, std::int64_t>;

std::map<ComparedGraph, double> volumes_of(const ComparedSetting& setting,
                                           const SettingGroup& group) {
  std::map<ComparedGraph, double> volumes;
  for (const SectionCurve& curve : setting.section->curves) {
    if (!group.families.contains(curve.family)) continue;
    for (const auto& [n, size] : curve.tally->sizes) {
      for (const DrawnGraph& graph : size.graphs) {
        volumes.try_emplace({curve.family, size.requested_n, graph.seed, graph.instance},
                            log10_volume(graph, group.is_relative));
      }
    }
  }
  return volumes;
}

ComparedSetting setting_of(const Section& section) {
  ComparedSetting setting{&section, section.label, section.algorithm, 0, 0, {}};
  for (const SectionCurve& curve : section.curves) {
    if (curve.is_collection) continue;  // compared graph by graph
    for (std::size_t b = 0; b < curve.tally->bends.size(); ++b) {
      if (curve.tally->bends[b] > 0) setting.bends = std::max(setting.bends, b);
    }
    for (const auto& [n, size] : curve.tally->sizes) {
      if (size.drawn == 0 || size.censored || size.requested_n < 1) continue;
      const double time =
          curve.tally->has_timing_rows ? median_of(size, Quantity::wall_s) : kMissing;
      const Median medians{median_of(size, Quantity::volume), median_relative_volume(size), time};
      if (std::isnan(medians.volume)) continue;
      setting.sizes[size.requested_n][curve.family] = medians;
    }
  }
  return setting;
}

using SettingSet = std::set<const ComparedSetting*>;

bool contains(const SettingSet& large, const SettingSet& small) {
  return std::includes(large.begin(), large.end(), small.begin(), small.end());
}

std::size_t algorithms_in(const SettingSet& settings) {
  std::set<std::string> algorithms;
  for (const ComparedSetting* setting : settings) algorithms.insert(setting->algorithm);
  return algorithms.size();
}

}  // namespace

std::vector<ComparedSetting> settings_of(const std::vector<Section>& sections) {
  std::vector<ComparedSetting> settings;
  for (const Section& section : sections) {
    settings.push_back(setting_of(section));
    settings.back().place = settings.size() - 1;
  }
  return settings;
}

std::vector<SettingGroup> groups_of(const std::vector<ComparedSetting>& settings) {
  std::map<std::string, SettingSet> drawn_by;  // by family
  for (const ComparedSetting& setting : settings) {
    for (const auto& [n, families] : setting.sizes) {
      for (const auto& [family, medians] : families) drawn_by[family].insert(&setting);
    }
  }
  std::map<SettingSet, std::set<std::string>> families_of;
  for (const auto& [family, by] : drawn_by) families_of[by].insert(family);
  std::vector<SettingGroup> groups;
  for (const auto& [one, own] : families_of) {
    const bool is_largest =
        std::none_of(families_of.begin(), families_of.end(), [&one = one](const auto& other) {
          return other.first != one && contains(other.first, one);
        });
    if (!is_largest || one.size() < 2) continue;
    const bool is_relative =
        std::any_of(one.begin(), one.end(),
                    [](const ComparedSetting* setting) { return setting->section->has_own_unit; });
    groups.push_back({{one.begin(), one.end()}, own, is_relative});
  }
  std::stable_sort(groups.begin(), groups.end(), [](const SettingGroup& a, const SettingGroup& b) {
    const auto rank = [](const SettingGroup& group) {
      return std::tuple(algorithms_in({group.settings.begin(), group.settings.end()}),
                        group.settings.size(), group.families.size());
    };
    return rank(a) > rank(b);
  });
  if (groups.size() > kMostGroups) groups.resize(kMostGroups);
  return groups;
}

SettingGroup SettingGroup::at(std::int64_t n) const {
  SettingGroup there{{}, families, is_relative};
  for (const ComparedSetting* setting : settings) {
    const auto size = setting->sizes.find(n);
    if (size == setting->sizes.end()) continue;
    there.settings.push_back(setting);
    std::erase_if(there.families,
                  [&](const std::string& family) { return !size->second.contains(family); });
  }
  return there;
}

std::vector<std::int64_t> SettingGroup::sizes() const {
  std::set<std::int64_t> all;
  for (const ComparedSetting* setting : settings) {
    for (const auto& [n, medians] : setting->sizes) all.insert(n);
  }
  return {all.begin(), all.end()};
}

Median over(const ComparedSetting& setting, std::int64_t n, const SettingGroup& group) {
  std::vector<double> volumes, times;
  for (const auto& [family, medians] : setting.sizes.at(n)) {
    if (!group.families.contains(family)) continue;
    const double volume = group.is_relative ? medians.relative_volume : medians.volume;
    if (!std::isnan(volume)) volumes.push_back(volume);
    times.push_back(medians.time);
  }
  return {median(std::move(volumes)), kMissing, median(std::move(times))};
}

std::vector<PairedGraph> paired_graphs(const ComparedSetting& one, const ComparedSetting& other,
                                       const SettingGroup& group) {
  std::vector<PairedGraph> pairs;
  const std::map<ComparedGraph, double> volumes = volumes_of(other, group);
  for (const auto& [graph, volume] : volumes_of(one, group)) {
    const auto at = volumes.find(graph);
    if (at == volumes.end() || std::isnan(volume - at->second)) continue;
    pairs.push_back({log10_of(std::get<1>(graph)), volume - at->second});
  }
  return pairs;
}

}  // namespace ar3d::report
