#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {

/// Volume and drawing time: decimal logarithms, medians.
struct Median {
  double volume = kMissing;           ///< lattice points of the box
  double relative_volume = kMissing;  ///< in cubes of the smallest distance of vertices
  double time = kMissing;
};

/// What one setting did on every family but collections at every requested n: medians over graphs.
/// Sizes with an unfinished graph are left out.
struct ComparedSetting {
  const Section* section = nullptr;
  std::string label;
  std::string algorithm;
  std::size_t colour = 0;
  std::size_t bends = 0;  ///< largest number of bends per edge
  std::map<std::int64_t, std::map<std::string, Median>> sizes;
};
std::vector<ComparedSetting> settings_of(const std::vector<Section>& sections);

/// Settings that can be compared, and the families that all of them drew.
struct SettingGroup {
  std::vector<const ComparedSetting*> settings;
  std::set<std::string> families;
  /// Some setting has a unit of its own, so that all volumes are over the smallest distance of
  /// vertices.
  bool is_relative = false;

  /// The settings with this n, and those of the families that all of these drew there.
  SettingGroup at(std::int64_t n) const;
  std::vector<std::int64_t> sizes() const;
  /// "44 families that 5 settings drew"
  std::string text() const;
};

/// At most four groups of at least two settings, none of which could have another setting without
/// losing families; most algorithms first, then most settings.
std::vector<SettingGroup> groups_of(const std::vector<ComparedSetting>& settings);

/// The median of a setting's medians over the group's families at an n that it has; `volume` is the
/// relative one if the group's are.
Median over(const ComparedSetting& setting, std::int64_t n, const SettingGroup& group);

/// A graph that two settings drew: log10 of its requested n, and of the one's volume over the
/// other's.
struct PairedGraph {
  double log_n = 0, log_ratio = 0;
};
/// The graphs of the group's families that both drew and the tally keeps.
std::vector<PairedGraph> paired_graphs(const ComparedSetting& one, const ComparedSetting& other,
                                       const SettingGroup& group);

}  // namespace ar3d::report
