#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/analysis/report/plot.h"
#include "ar3d/analysis/report/sections.h"

namespace ar3d::report {

/// One graph, and what the settings made of it.
struct CollectionGraph {
  std::int64_t n = 0;
  std::vector<std::pair<std::size_t, const DrawnGraph*>> drawn;  // by setting
};

struct CollectionSetting {
  std::string label;
  const SectionCurve* curve = nullptr;
};

/// The graphs of one name with parameters, all that the tally keeps.
struct Collection {
  std::string family;
  std::vector<CollectionSetting> settings;
  bool is_relative = false, is_timed = true;
  std::map<std::pair<std::uint64_t, std::int64_t>, CollectionGraph> graphs;  // by seed and place
};

/// What graphs are compared by: a decimal logarithm of at least one drawing, the less the better.
struct CollectionMeasure {
  const char* name;
  const char* title;
  TickStyle ticks;
  std::string (*unit)(const Collection&);
  double (*log10_value)(const Collection&, const DrawnGraph&);
  bool is_larger_better = false;
};

/// A graph that two settings drew.
struct CollectionPair {
  const DrawnGraph *one = nullptr, *other = nullptr;
  double x = 0, y = 0;
  double ratio() const { return y - x; }
};

/// What one setting drew of it; null if nothing.
const DrawnGraph* drawn_by(const CollectionGraph& one, std::size_t setting);
/// "12.3" of a decimal logarithm; "–" if missing.
std::string number_text(double log10);

/// Graphs that two settings drew, in increasing order of the second value over the first.
std::vector<CollectionPair> pairs_of(const Collection& collection, const CollectionMeasure& measure,
                                     std::size_t a, std::size_t b);
/// Those with the least and the largest ratios.
std::vector<CollectionPair> outliers(const std::vector<CollectionPair>& pairs);

/// The share of graphs that each setting draws within a factor of the best (Dolan and Moré,
/// Benchmarking optimization software with performance profiles, Mathematical Programming 91,
/// 2002). Like the others, no svg if there is nothing to show.
NamedPlot profile_plot(const Collection& collection, const CollectionMeasure& measure);
/// A point a graph, and the outliers with buttons that open their drawings.
NamedPlot scatter_plot(Page& page, const Collection& collection, const CollectionMeasure& measure,
                       std::size_t a, std::size_t b);
/// Medians over the graphs of each bin of n.
NamedPlot sizes_plot(const Collection& collection, const CollectionMeasure& measure);

}  // namespace ar3d::report
