#include "ar3d/analysis/report/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/statistics.h"

namespace ar3d::report {
namespace {

constexpr std::size_t kMostGroups = 4;

double median_of(const SizeTally& size, Quantity quantity, bool timed) {
  std::vector<double> logs;
  for (const DrawnGraph& graph : size.graphs) logs.push_back(log_value(graph, quantity, timed));
  return decimal(median(std::move(logs)));
}

ComparedSetting setting_of(const Section& section) {
  ComparedSetting setting{section.label, section.algorithm, 0, 0, {}};
  for (const SectionCurve& curve : section.curves) {
    for (std::size_t b = 0; b < curve.tally->bends.size(); ++b) {
      if (curve.tally->bends[b] > 0) setting.bends = std::max(setting.bends, b);
    }
    for (const auto& [n, size] : curve.tally->sizes) {
      if (size.drawn == 0 || size.censored || size.requested_n < 1) continue;
      const bool timed = curve.tally->has_timing_rows;
      const Median medians{median_of(size, Quantity::volume, timed),
                           median_of(size, Quantity::wall_s, timed)};
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
    settings.back().colour = settings.size() - 1;
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
    if (is_largest && one.size() > 1) groups.push_back({{one.begin(), one.end()}, own});
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
  SettingGroup there{{}, families};
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

std::string SettingGroup::text() const {
  const std::string which = families.size() == 1 ? *families.begin() + ", which"
                                                 : fmt::format("{} families that", families.size());
  return fmt::format("{} {} settings drew", which, settings.size());
}

Median over(const ComparedSetting& setting, std::int64_t n, const std::set<std::string>& families) {
  std::vector<double> volumes, times;
  for (const auto& [family, medians] : setting.sizes.at(n)) {
    if (!families.contains(family)) continue;
    volumes.push_back(medians.volume);
    times.push_back(medians.time);
  }
  return {median(std::move(volumes)), median(std::move(times))};
}

}  // namespace ar3d::report
