#include "cell_study.h"

#include <fmt/format.h>

#include <set>
#include <string_view>
#include <vector>

#include "ar3d/analysis/curves.h"
#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/bench/plan/plan.h"

namespace ar3d {
namespace {

/// What a plan says of the cell.
struct PlannedCell {
  CurveKey curve;
  std::uint64_t requested_n = 0;
  std::uint32_t instances = 0;
};

PlannedCell find_cell(const StudySpec& spec, const std::string& cell) {
  PlannedCell found;
  std::set<std::string> labels;
  for (const PlannedInstance& instance : plan_study(spec).instances) {
    for (const PlannedRun& run : instance.runs) {
      const CurveKey curve = {
          run.choice.algorithm->name, run.options, instance.choice.family->name,
          instance.parameters,
          run.choice.level == Level::extents ? "" : to_string(run.choice.level)};
      const std::string label = cell_label(curve, static_cast<std::int64_t>(instance.n));
      labels.insert(label);
      if (label != cell) continue;
      found.curve = curve;
      found.requested_n = instance.requested_n;
      found.instances = std::max(found.instances, instance.index + 1);
    }
  }
  if (found.instances > 0) return found;
  throw InputError(fmt::format("study '{}' has no cell '{}'{}", spec.name, cell,
                               did_you_mean(cell, {labels.begin(), labels.end()})));
}

/// "k=2;p=5" as ", k = 2, p = 5".
std::string toml_settings(std::string_view settings) {
  std::string toml = settings.empty() ? "" : ", ";
  for (const char c : settings) toml += c == '=' ? " = " : c == ';' ? ", " : std::string(1, c);
  return toml;
}

}  // namespace

StudySpec study_of_cell(const StudySpec& spec, const std::string& cell, int timed_repetitions) {
  const PlannedCell found = find_cell(spec, cell);
  const std::string text = fmt::format(
      "study = \"{}\"\nseed = {}\n[[sweep]]\nfamilies = {{ family = \"{}\"{} }}\nsizes = {}\n"
      "algorithms = {{ algorithm = \"{}\"{} }}\nlevel = \"{}\"\ninstances = {}\n"
      "timed_repetitions = {}\n",
      spec.name, spec.seed, found.curve.family, toml_settings(found.curve.parameters),
      found.requested_n, found.curve.algorithm, toml_settings(found.curve.options),
      found.curve.level.empty() ? "extents" : found.curve.level, found.instances,
      timed_repetitions);
  try {
    return parse_study(text, "the study of the cell");
  } catch (const InputError& error) {
    throw InputError(fmt::format(
        "cell '{}' cannot be run by itself (its graphs are of a file, or its algorithm is a "
        "program): {}",
        cell, error.what()));
  }
}

}  // namespace ar3d
