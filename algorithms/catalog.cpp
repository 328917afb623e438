#include "ar3d/algorithms/catalog.h"

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/algorithms/compact/compact.h"
#include "ar3d/algorithms/degree_limit.h"
#include "ar3d/algorithms/diamond/diamond.h"
#include "ar3d/algorithms/grid/grid.h"
#include "ar3d/algorithms/two_bend/two_bend.h"
#include "ar3d/model/error.h"

namespace ar3d {

const std::vector<Algorithm>& algorithms() {
  static const std::vector<Algorithm> rows = {
      // One row an algorithm, each made by a function of its own folder.
      diamond_row(),
      two_bend_row(),
      grid_row(),
      compact_row(),
  };
  return rows;
}

const Algorithm& find_algorithm(std::string_view name) {
  std::string known;
  for (const Algorithm& row : algorithms()) {
    if (row.name == name) return row;
    known += (known.empty() ? "" : ", ") + row.name;
  }
  throw InputError(fmt::format("unknown algorithm '{}' (known: {})", name, known));
}

OptionValues complete_options(const Algorithm& algorithm, const OptionValues& given) {
  OptionValues values;
  for (const OptionSpec& spec : algorithm.options)
    values.push_back({spec.name, spec.default_value});
  std::vector<bool> set(values.size(), false);
  for (const OptionValue& wanted : given) {
    const auto at = std::find_if(values.begin(), values.end(),
                                 [&](const OptionValue& v) { return v.name == wanted.name; });
    if (at == values.end()) {
      throw InputError(fmt::format("algorithm {} has no option '{}'", algorithm.name, wanted.name));
    }
    const auto i = static_cast<std::size_t>(at - values.begin());
    const OptionSpec& spec = algorithm.options[i];
    if (set[i]) throw InputError(fmt::format("option '{}' is given twice", wanted.name));
    if (wanted.value < spec.low || wanted.value > spec.high) {
      throw InputError(fmt::format("option {} = {} is outside {}..{}", spec.name, wanted.value,
                                   spec.low, spec.high));
    }
    set[i] = true;
    at->value = wanted.value;
  }
  return values;
}

Drawing draw(const Algorithm& algorithm, const Graph& graph, const OptionValues& given) {
  refuse_larger_degrees(algorithm.name, graph, algorithm.guarantee.max_degree);
  return algorithm.draw(graph, complete_options(algorithm, given));
}

std::int64_t option(const OptionValues& values, std::string_view name) {
  for (const OptionValue& value : values) {
    if (value.name == name) return value.value;
  }
  throw InternalError(fmt::format("option '{}' was not completed", name));
}

}  // namespace ar3d
