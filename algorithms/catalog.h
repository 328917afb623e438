#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"
#include "ar3d/model/settings.h"

namespace ar3d {

/// One row of the catalogue: a pure function Graph -> Drawing beside what its theorem promises.
struct Algorithm {
  std::string name;
  std::string summary;  ///< one sentence
  std::string source;   ///< theorem of the paper
  Guarantee guarantee;
  std::vector<SettingSpec> options;
  Drawing (*draw)(const Graph&,
                  const Settings&) = nullptr;  ///< called with complete values, see draw()
};

/// All algorithms, in the order in which they are listed.
const std::vector<Algorithm>& algorithms();

/// Those whose every drawing keeps its guarantee: what "all" means in a study. The others
/// (Claim::measured) are named where somebody wants them.
std::vector<const Algorithm*> proved_algorithms();

/// @throws InputError naming the unknown algorithm and the known ones.
const Algorithm& find_algorithm(std::string_view name);

/// The values with every default filled in, in the order of algorithm.options.
/// @throws InputError on an unknown name, a name given twice or a value out of range.
Settings complete_options(const Algorithm& algorithm, const Settings& given);

/// Draws with checked options.
/// @throws InputError if an option is bad or graph.max_degree() passes the guarantee's (names the
/// first such vertex).
Drawing draw(const Algorithm& algorithm, const Graph& graph, const Settings& given = {});

/// Adds a row to the catalogue, for programs that bring algorithms of their own: before anything
/// else uses it, by one thread. References to other rows stay valid.
/// @throws InputError if the name is taken or empty, or there is no drawing function; if there are
/// more than 1000 rows.
void register_algorithm(Algorithm row);

}  // namespace ar3d
