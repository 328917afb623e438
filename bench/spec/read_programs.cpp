// Reads the programs of a specification. One without a guarantee promises nothing, so it is
// measured and never judged.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/bench/spec/toml_table.h"

namespace ar3d {
namespace {

constexpr std::int64_t kAny = std::numeric_limits<std::int64_t>::max();

// What every drawing of this program keeps: its coordinates are at most 2^61.
SizeBound bound_of_integers() {
  const AxisBound axis{0, 1, 0, 2 * kMaxCoordinate};
  return {"integers", "coordinates of a drawing are at most 2^61", {axis, axis, axis}};
}

Guarantee read_guarantee(const std::string& file, const toml::node& node) {
  TomlTable table(file, node, "guarantee");
  table.refuse_all_but({"max_degree", "max_bends", "cosine"});
  Guarantee guarantee;
  guarantee.max_degree = static_cast<std::uint32_t>(table.integer("max_degree", 0, 1000000));
  guarantee.max_bends = static_cast<std::uint32_t>(table.integer("max_bends", 0, 1000000));
  guarantee.angle_rule = AngleRule::at_least;
  const toml::node& cosine = table.get("cosine");
  std::vector<std::int64_t> parts;
  for (const toml::node* part : one_or_many(cosine)) {
    parts.push_back(toml_integer(file, *part, "cosine", -1000000, 1000000));
  }
  if (parts.size() != 2 || parts[1] < 1 || std::abs(parts[0]) > parts[1]) {
    refuse_toml(file, cosine, "cosine is not [numerator, denominator] of a fraction from -1 to 1");
  }
  guarantee.cosine = {static_cast<std::int32_t>(parts[0]), static_cast<std::int32_t>(parts[1])};
  guarantee.bound = bound_of_integers();
  return guarantee;
}

// Nothing is promised, so nothing is refused.
Guarantee no_guarantee() {
  Guarantee guarantee;
  guarantee.max_degree = std::numeric_limits<std::uint32_t>::max();
  guarantee.max_bends = std::numeric_limits<std::uint32_t>::max() - 1;
  guarantee.angle_rule = AngleRule::at_least;
  guarantee.cosine = {1, 1};
  return guarantee;
}

void read_name(const std::string& file, TomlTable& table, ExternalAlgorithm& program) {
  program.row.name = table.text("name");
  const std::string& name = program.row.name;
  const bool is_known =
      std::any_of(algorithms().begin(), algorithms().end(),
                  [&](const Algorithm& algorithm) { return algorithm.name == name; });
  if (is_known || name == "all" || !is_graphs_name(name)) {
    refuse_toml(file, table.get("name"),
                fmt::format("'{}' {}", printable(name),
                            is_known ? "is an algorithm of the catalogue"
                                     : "is no name: 1 to 47 letters, digits, '.', '-' or '_'"));
  }
}

void read_command(const std::string& file, TomlTable& table, ExternalAlgorithm& program) {
  const toml::node& command = table.get("command");
  for (const toml::node* word : one_or_many(command)) {
    program.command.push_back(toml_text(file, *word, "command"));
  }
  if (program.command.empty() || program.command[0].empty()) {
    refuse_toml(file, command, "command is empty");
  }
}

void read_rest(const std::string& file, TomlTable& table, ExternalAlgorithm& program) {
  program.input = table.text("input", program.input);
  if (program.input != "edgelist" && program.input != "graph6" && program.input != "sparse6") {
    refuse_toml(file, table.get("input"),
                fmt::format("input '{}' is none of edgelist, graph6 and sparse6",
                            printable(program.input)));
  }
  program.version = table.text("version", "");
  if (!program.version.empty() && !is_graphs_name(program.version)) {
    refuse_toml(file, table.get("version"),
                fmt::format("version '{}' is not 1 to 47 letters, digits, '.', '-' or '_'",
                            printable(program.version)));
  }
  program.one_graph_per_process = table.boolean("one_graph_per_process", false);
  if (table.has("time_limit_s")) program.time_limit_s = table.number("time_limit_s", 1e-3, 1e6);
  if (table.has("time_limit_s_per_vertex")) {
    program.time_limit_s_per_vertex = table.number("time_limit_s_per_vertex", 0, 1e6);
  }
  const toml::node* guarantee = table.find("guarantee");
  program.has_guarantee = guarantee != nullptr;
  program.row.guarantee = guarantee != nullptr ? read_guarantee(file, *guarantee) : no_guarantee();
}

}  // namespace

ProgramEntry read_program(const std::string& file, const toml::node& node) {
  TomlTable table(file, node, "algorithm");
  ExternalAlgorithm program;
  read_name(file, table, program);
  read_command(file, table, program);
  read_rest(file, table, program);
  program.row.summary = "a program of the study";
  ProgramEntry entry;
  Settings first;
  for (const std::string& option : table.other_keys()) {
    std::vector<std::int64_t> values;
    const toml::node& given = table.get(option);
    const bool is_used =
        std::any_of(program.command.begin(), program.command.end(), [&](const std::string& word) {
          return word.find("{" + option + "}") != std::string::npos;
        });
    if (!is_used) {
      refuse_toml(file, given,
                  fmt::format("unknown key '{}': no key of a program, and the command "
                              "has no {{{}}} for it as an option",
                              printable(option), printable(option)));
    }
    for (const toml::node* value : one_or_many(given)) {
      values.push_back(toml_integer(file, *value, option, -kAny - 1, kAny));
    }
    if (values.empty()) refuse_toml(file, given, fmt::format("{} is empty", printable(option)));
    program.row.options.push_back({option, -kAny - 1, kAny, values.front(), "of the program"});
    first.push_back({option, values.front()});
    entry.options.emplace_back(option, std::move(values));
  }
  with_place(file, node, [&] { command_with(program, first); });
  entry.program = std::make_shared<const ExternalAlgorithm>(std::move(program));
  return entry;
}

}  // namespace ar3d
