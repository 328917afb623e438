#pragma once

#include <array>
#include <optional>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/algorithms/strips/search.h"

namespace ar3d::strips {

inline constexpr int kHighestEffort = 2;

/// How narrow the first strip is at efforts 1 and 2; nothing: the zones of the proof at once.
/// @throws InputError naming the algorithm if there is no such effort.
inline std::optional<Tightness> first_tightness(const char* algorithm, int effort,
                                                const std::array<Tightness, 2>& narrow) {
  check_effort(algorithm, effort, kHighestEffort);
  if (effort == 0) return std::nullopt;
  return narrow[static_cast<std::size_t>(effort - 1)];
}

/// The row's option `effort`, and its drawing function with it.
template <auto draw>
void offer_efforts(Algorithm& row) {
  row.options = {effort_option(
      kHighestEffort,
      "0: the zones of the proof; 1: a narrow strip; 2: a narrower one, several times slower")};
  row.draw = [](const Graph& graph, const Settings& values) {
    return draw(graph, {.effort = static_cast<int>(value_of(values, "effort"))});
  };
}

}  // namespace ar3d::strips
