#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/model/settings.h"

namespace ar3d {

/// An algorithm: a pure function Graph -> Drawing beside what its theorem promises. A program that
/// draws is one, too.
struct Algorithm {
  std::string name;
  std::string summary;  ///< one sentence
  std::string source;   ///< theorem of the paper
  Guarantee guarantee;
  std::vector<SettingSpec> options;
  std::function<Drawing(const Graph&, const Settings&)> draw;  ///< with complete values: draw()
  bool by_name_only = false;  ///< "all" in a study does not mean it
  /// The space that it searches for n vertices; empty if its costs grow as powers of n.
  std::function<double(const Settings&, std::uint64_t n)> space = {};
};

/// The values with every default filled in, in the order of algorithm.options.
/// @throws InputError on an unknown name, a name given twice or a value out of range.
Settings complete_options(const Algorithm& algorithm, const Settings& given);

/// Draws with checked options.
/// @throws InputError if an option is bad or graph.max_degree() passes the guarantee's (names the
/// first such vertex).
Drawing draw(const Algorithm& algorithm, const Graph& graph, const Settings& given = {});

/// Says how much a drawing may cost, on one scale for all algorithms:
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

// What every algorithm refuses, also when it is called without the catalogue.

/// @throws InputError naming the algorithm unless 0 <= effort <= highest.
void check_effort(std::string_view algorithm, int effort, int highest);

/// @throws InputError naming the first vertex whose degree passes the algorithm's limit. O(1) if
/// there is none, else O(n).
void refuse_larger_degrees(std::string_view algorithm, const Graph& graph, std::uint32_t limit);

/// @throws InputError if the graph has more vertices than the algorithm's integer widths are proved
/// for. O(1).
void refuse_more_vertices(std::string_view algorithm, const Graph& graph, std::uint32_t limit);

}  // namespace ar3d
