#pragma once

#include <string_view>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/settings.h"

namespace ar3d {

/// How much a drawing may cost, on one scale for all algorithms:
///   0  the construction of the proof, without any step that only makes drawings smaller
///   1  the default: a drawing that is small in practice, in about the same time
///   2  a smaller one, for several times the time; left out where it would gain nothing
inline constexpr int kDefaultEffort = 1;

/// The option `effort` with 0 ... highest and the default above.
SettingSpec effort_option(int highest, std::string_view description);

/// An algorithm's `draw(graph, options)` as a catalogue row calls it, its only option being
/// `effort`.
template <auto draw>
Drawing draw_with_effort(const Graph& graph, const Settings& values) {
  return draw(graph, {.effort = static_cast<int>(value_of(values, "effort"))});
}

/// @throws InputError naming the algorithm unless 0 <= effort <= highest.
void check_effort(std::string_view algorithm, int effort, int highest);

}  // namespace ar3d
