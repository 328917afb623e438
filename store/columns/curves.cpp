// Names of curves and cells, for people, tables and command lines.
#include "ar3d/store/columns/curves.h"

#include <fmt/format.h>

#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

std::string with_brackets(const std::string& name, const std::string& details) {
  return details.empty() ? name : name + " (" + details + ")";
}

}  // namespace

CurveKey curve_of(const RunRecord& run) {
  return {run.algorithm, run.options, run.family, run.parameters,
          run.level == "extents" ? "" : run.level};
}

std::string options_and_level(const CurveKey& key) {
  if (key.level.empty()) return key.options;
  return key.options + (key.options.empty() ? "" : ";") + "level=" + key.level;
}

std::string algorithm_label(const CurveKey& key) {
  return with_brackets(key.algorithm, options_and_level(key));
}

std::string family_label(const CurveKey& key) { return with_brackets(key.family, key.parameters); }

std::string graph_label(const RunRecord& run) {
  const CurveKey key = curve_of(run);
  const std::string& name = run.graph_name;
  const std::string graph = name.empty()        ? fmt::format("graph {}", run.instance_index)
                            : run.group.empty() ? name
                                                : run.group + "/" + name;
  return fmt::format("{} on {}, n = {}, {}", algorithm_label(key), family_label(key),
                     run.n >= 0 ? run.n : run.requested_n, graph);
}

std::string cell_label(const CurveKey& key, std::int64_t n) {
  std::string label = algorithm_label(key);
  if (!key.family.empty()) {
    label += " on " + family_label(key);
    label += n >= 0 ? fmt::format(" n={}", n) : std::string(" all n");
  }
  return one_line(label);
}

}  // namespace ar3d
