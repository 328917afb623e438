// The studies that the program brings along, and the text of a specification that means the same in
// another folder: its paths are made absolute.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/bench/spec/toml_table.h"
#include "ar3d_named_studies.h"

namespace ar3d {
std::span<const NamedStudy> named_studies() { return kNamedStudies; }

const NamedStudy* find_named_study(std::string_view name) {
  const auto at = std::find_if(std::begin(kNamedStudies), std::end(kNamedStudies),
                               [&](const NamedStudy& study) { return study.name == name; });
  return at == std::end(kNamedStudies) ? nullptr : &*at;
}

static const std::vector<std::string_view> kKept = {"none", "worst", "violated", "all"};

const char* to_string(KeptDrawings kept) { return kKept[static_cast<std::size_t>(kept)].data(); }

KeptDrawings parse_kept_drawings(std::string_view text) {
  const auto at = std::find(kKept.begin(), kKept.end(), text);
  if (at != kKept.end()) return static_cast<KeptDrawings>(at - kKept.begin());
  throw InputError(fmt::format("keep_drawings '{}' is none of none, worst, violated and all{}",
                               printable(text), did_you_mean(text, kKept)));
}

namespace {

/// @param graphs  a path, a table with `file` or `files`, or a list of these.
void make_paths_absolute(toml::node& graphs, const std::string& folder) {
  if (toml::array* const list = graphs.as_array()) {
    for (toml::node& entry : *list) make_paths_absolute(entry, folder);
  } else if (toml::table* const table = graphs.as_table()) {
    for (const char* key : {"file", "files", "groups"}) {
      if (toml::node* const file = table->get(key)) make_paths_absolute(*file, folder);
    }
  } else if (toml::value<std::string>* const path = graphs.as_string()) {
    path->get() = std::filesystem::absolute(std::filesystem::path(folder) / path->get()).string();
  }
}

}  // namespace

std::string movable_text(const Study& whole) {
  const StudySpec& spec = whole.spec;
  const bool has_graphs = std::any_of(spec.sweeps.begin(), spec.sweeps.end(),
                                      [](const Sweep& sweep) { return !sweep.graphs.empty(); });
  if (!has_graphs) return spec.text;
  toml::table study = parse_toml(spec.text, spec.name);
  for_each_table(study, "sweep", [&](toml::table& sweep) {
    if (toml::node* const graphs = sweep.get("graphs")) make_paths_absolute(*graphs, whole.folder);
  });
  return toml_text_of(study);
}

Study with_timed_rounds(const Study& whole, std::uint64_t rounds) {
  toml::table study = parse_toml(whole.spec.text, whole.spec.name);
  for_each_table(study, "sweep", [&](toml::table& sweep) {
    sweep.insert_or_assign("timed_repetitions", static_cast<std::int64_t>(rounds));
  });
  Study timed = whole;
  timed.spec = parse_study(toml_text_of(study), whole.spec.name + " with --timed");
  return timed;
}

std::string text_of_a_turn(const Study& whole, std::int64_t most_timed) {
  const StudySpec& spec = whole.spec;
  const auto is_long = [&](const Sweep& sweep) { return sweep.most_timed > most_timed; };
  const bool has_long = std::any_of(spec.sweeps.begin(), spec.sweeps.end(), is_long);
  if (!spec.count && !has_long) return movable_text(whole);
  toml::table study = parse_toml(movable_text(whole), spec.name);
  study.erase("count");
  for_each_table(study, "sweep", [&](toml::table& sweep) {
    if (!sweep.contains("timed_repetitions")) return;
    const std::int64_t asked = sweep["timed_repetitions"].value_or(most_timed);
    sweep.insert_or_assign("timed_repetitions", std::min(asked, most_timed));
  });
  return toml_text_of(study);
}

}  // namespace ar3d
