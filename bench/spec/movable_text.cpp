#include "ar3d/bench/spec/movable_text.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "ar3d/bench/spec/toml_table.h"

namespace ar3d {
namespace {

/// @param graphs  a path, a table with `file`, or a list of these.
void make_paths_absolute(toml::node& graphs, const std::string& folder) {
  if (toml::array* const list = graphs.as_array()) {
    for (toml::node& entry : *list) make_paths_absolute(entry, folder);
  } else if (toml::table* const table = graphs.as_table()) {
    if (toml::node* const file = table->get("file")) make_paths_absolute(*file, folder);
  } else if (toml::value<std::string>* const path = graphs.as_string()) {
    path->get() = std::filesystem::absolute(std::filesystem::path(folder) / path->get()).string();
  }
}

void make_sweep_movable(toml::node& sweep, const std::string& folder) {
  if (sweep.as_table() == nullptr) return;
  if (toml::node* const graphs = sweep.as_table()->get("graphs")) {
    make_paths_absolute(*graphs, folder);
  }
}

}  // namespace

std::string movable_text(const StudySpec& spec) {
  const bool has_graphs = std::any_of(spec.sweeps.begin(), spec.sweeps.end(),
                                      [](const Sweep& sweep) { return !sweep.graphs.empty(); });
  if (!has_graphs) return spec.text;
  toml::table study = parse_toml(spec.text, spec.name);
  if (toml::node* const sweeps = study.get("sweep")) {
    make_sweep_movable(*sweeps, spec.folder);
    if (toml::array* const list = sweeps->as_array()) {
      for (toml::node& sweep : *list) make_sweep_movable(sweep, spec.folder);
    }
  }
  std::ostringstream text;
  text << study << '\n';
  return text.str();
}

}  // namespace ar3d
