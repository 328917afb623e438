#pragma once

#include <map>
#include <string>

#include "ar3d/model/drawing.h"

namespace ar3d::testing {

/// Sums of counters over drawings, by name.
using CounterSums = std::map<std::string, std::int64_t>;

inline void add_counters(const Drawing& drawing, CounterSums& sums) {
  for (const Counter& counter : drawing.counters) sums[counter.name] += counter.value;
}

/// @throws std::out_of_range if the drawing has no such counter.
inline std::int64_t counter_of(const Drawing& drawing, const std::string& name) {
  CounterSums all;
  add_counters(drawing, all);
  return all.at(name);
}

}  // namespace ar3d::testing
