#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/guarantee.h"

namespace ar3d {

/// One option of an algorithm as a study, the command line and the docs see it: an integer in a
/// closed range.
struct OptionSpec {
  std::string name;
  std::int64_t low = 0;
  std::int64_t high = 0;
  std::int64_t default_value = 0;
  std::string description;
};

/// Values for an algorithm's options, by name; what is not named keeps its default.
struct OptionValue {
  std::string name;
  std::int64_t value = 0;
  friend bool operator==(const OptionValue&, const OptionValue&) = default;
};
using OptionValues = std::vector<OptionValue>;

/// One row of the catalogue: a pure function Graph -> Drawing beside what its theorem promises.
struct Algorithm {
  std::string name;
  std::string summary;  ///< one sentence
  std::string source;   ///< theorem of the paper
  Guarantee guarantee;
  std::vector<OptionSpec> options;
  Drawing (*draw)(const Graph&,
                  const OptionValues&) = nullptr;  ///< called with complete values, see draw()
};

/// All algorithms, in the order in which they are listed.
const std::vector<Algorithm>& algorithms();

/// @throws InputError naming the unknown algorithm and the known ones.
const Algorithm& find_algorithm(std::string_view name);

/// The values with every default filled in, in the order of algorithm.options.
/// @throws InputError on an unknown name, a name given twice or a value out of range.
OptionValues complete_options(const Algorithm& algorithm, const OptionValues& given);

/// Draws with checked options.
/// @throws InputError if an option is bad or graph.max_degree() passes the guarantee's (names the
/// first such vertex).
Drawing draw(const Algorithm& algorithm, const Graph& graph, const OptionValues& given = {});

/// The value of a completed option. @throws InternalError if it is missing.
std::int64_t option(const OptionValues& values, std::string_view name);

}  // namespace ar3d
