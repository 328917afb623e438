// Names of curves and cells, for people, tables and command lines.
#include "ar3d/store/columns/curves.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

std::string with_brackets(const std::string& name, const std::string& details) {
  return details.empty() ? name : name + " (" + details + ")";
}

std::vector<std::string> words_of(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return c == '(' || c == ')' || c == ';' || c == ','; }, ' ');
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
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

CurveKey find_setting(std::span<const CurveKey> settings, const std::string& text) {
  const std::vector<std::string> asked = words_of(text);
  std::vector<CurveKey> meant;
  std::vector<std::string> labels;
  for (const CurveKey& key : settings) {
    labels.push_back(algorithm_label(key));
    const std::vector<std::string> words = words_of(labels.back());
    const bool has_all = std::ranges::all_of(
        asked, [&](const std::string& word) { return std::ranges::count(words, word) > 0; });
    if (!asked.empty() && asked.front() == key.algorithm && has_all) meant.push_back(key);
  }
  if (meant.size() == 1) return meant.front();
  throw InputError(fmt::format("'{}' is {} of the settings {}", printable(text),
                               meant.empty() ? "none" : "more than one",
                               printable(fmt::format("{}", fmt::join(labels, ", ")))));
}

}  // namespace ar3d
