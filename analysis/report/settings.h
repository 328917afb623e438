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
  double volume = kMissing;
  double time = kMissing;
};

/// What one setting did on every family at every requested n: medians over graphs. Sizes with an
/// unfinished graph are left out.
struct Setting {
  std::string label;
  std::string algorithm;
  std::size_t colour = 0;
  std::size_t bends = 0;  ///< largest number of bends per edge
  std::map<std::int64_t, std::map<std::string, Median>> sizes;
};
std::vector<Setting> settings_of(const std::vector<Section>& sections);

/// Settings that can be compared, and the families that all of them drew.
struct Group {
  std::vector<const Setting*> settings;
  std::set<std::string> families;

  /// The settings with this n, and those of the families that all of these drew there.
  Group at(std::int64_t n) const;
  std::vector<std::int64_t> sizes() const;
  /// "44 families that 5 settings drew"
  std::string text() const;
};

/// At most four groups of at least two settings, none of which could have another setting without
/// losing families; most algorithms first, then most settings.
std::vector<Group> groups_of(const std::vector<Setting>& settings);

/// The median of a setting's medians over these families at an n that it has.
Median over(const Setting& setting, std::int64_t n, const std::set<std::string>& families);

/// The setting's volumes against n as lines, divided by n^order, with the last crossing of every
/// two algorithms; no svg if fewer than two settings have a size in common.
NamedPlot volume_plot(const Group& group, double order);

}  // namespace ar3d::report
