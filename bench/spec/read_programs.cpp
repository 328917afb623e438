// Reads the programs of a specification. One without a guarantee promises nothing, so it is
// measured and never judged.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/external/external_drawer.h"
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

Guarantee read_guarantee(const toml::node& node) {
  Guarantee guarantee;
  const auto read_cosine = [&](const toml::node& cosine, const std::string& key) {
    std::vector<std::int32_t> parts;
    for (const toml::node* part : one_or_many(cosine)) {
      into(parts.emplace_back(), -1000000, 1000000)(*part, key);
    }
    if (parts.size() != 2 || parts[1] < 1 || std::abs(parts[0]) > parts[1]) {
      refuse_toml(cosine, "cosine is not [numerator, denominator] of a fraction from -1 to 1");
    }
    guarantee.cosine = {parts[0], parts[1]};
  };
  read_toml_table(node, "guarantee",
                  {{"max_degree", into(guarantee.max_degree, 0, 1000000), true},
                   {"max_bends", into(guarantee.max_bends, 0, 1000000), true},
                   {"cosine", read_cosine, true}});
  guarantee.angle_rule = AngleRule::at_least;
  guarantee.bound = bound_of_integers();
  return guarantee;
}

// Nothing is promised, so nothing is refused.
Guarantee no_guarantee() {
  Guarantee guarantee;
  guarantee.claim = Claim::nothing;
  guarantee.max_degree = std::numeric_limits<std::uint32_t>::max();
  guarantee.max_bends = std::numeric_limits<std::uint32_t>::max() - 1;
  guarantee.angle_rule = AngleRule::at_least;
  guarantee.cosine = {1, 1};
  return guarantee;
}

void require_name(const toml::node& node, const std::string& name) {
  const bool is_known =
      std::any_of(algorithms().begin(), algorithms().end(),
                  [&](const Algorithm& algorithm) { return algorithm.name == name; });
  if (!is_known && name != "all" && is_graphs_name(name)) return;
  refuse_toml(node, fmt::format("'{}' {}", printable(name),
                                is_known ? "is an algorithm of the catalogue"
                                         : "is no name: 1 to 47 letters, digits, '.', '-' or '_'"));
}

/// Reads a text that is one of the choices.
TomlReader choice_into(std::string& to, std::vector<std::string> choices) {
  return [&to, choices = std::move(choices)](const toml::node& node, const std::string& key) {
    to = toml_text(node, key);
    if (std::ranges::find(choices, to) == choices.end()) {
      refuse_toml(
          node, fmt::format("{} '{}' is none of {}", key, printable(to), fmt::join(choices, ", ")));
    }
  };
}

std::vector<std::int64_t> option_values(const toml::node& given, const std::string& option,
                                        const std::vector<std::string>& command) {
  const bool is_used = std::ranges::any_of(command, [&](const std::string& word) {
    return word.find("{" + option + "}") != std::string::npos;
  });
  if (!is_used) {
    refuse_toml(given, fmt::format("unknown key '{}': no key of a program, and the command "
                                   "has no {{{}}} for it as an option",
                                   printable(option), printable(option)));
  }
  std::vector<std::int64_t> values;
  for (const toml::node* value : toml_list(given, printable(option))) {
    values.push_back(toml_integer(*value, option, -kAny - 1, kAny));
  }
  return values;
}

}  // namespace

std::shared_ptr<const ExternalAlgorithm> read_program(const toml::node& node) {
  const auto made = std::make_shared<ExternalAlgorithm>();
  ExternalAlgorithm& program = *made;
  Settings first;
  const auto read_name = [&](const toml::node& name, const std::string& key) {
    program.row.name = toml_text(name, key);
    require_name(name, program.row.name);
  };
  const auto read_command = [&](const toml::node& command, const std::string& key) {
    for (const toml::node* word : one_or_many(command)) {
      program.command.push_back(toml_text(*word, key));
    }
    if (program.command.empty() || program.command[0].empty()) {
      refuse_toml(command, "command is empty");
    }
  };
  const auto read_version = [&](const toml::node& version, const std::string& key) {
    program.version = toml_text(version, key);
    if (program.version.empty() || is_graphs_name(program.version)) return;
    refuse_toml(version, fmt::format("version '{}' is not 1 to 47 letters, digits, '.', '-' or '_'",
                                     printable(program.version)));
  };
  const auto read_guarantee_of_program = [&](const toml::node& guarantee, const std::string&) {
    program.row.guarantee = read_guarantee(guarantee);
  };
  program.row.guarantee = no_guarantee();
  program.row.summary = "a program of the study";
  program.row.draw = [&program](const Graph& graph, const Settings& options) {
    return ExternalDrawer::draw(program, graph, options);
  };
  read_toml_table(
      node, "algorithm",
      {{"name", read_name, true},
       {"command", read_command, true},
       {"input", choice_into(program.input, {"edgelist", "graph6", "sparse6"})},
       {"version", read_version},
       {"coordinates", choice_into(program.coordinates, {"float", "double"})},
       {"one_graph_per_process", into(program.one_graph_per_process)},
       {"time_limit_s", number_into(program.limit_s.always, 1e-3, 1e6)},
       {"time_limit_s_per_vertex", number_into(program.limit_s.per_vertex, 0, 1e6)},
       {"guarantee", read_guarantee_of_program}},
      [&](const toml::node& given, const std::string& option) {
        program.choices.emplace_back(option, option_values(given, option, program.command));
        const std::int64_t first_value = program.choices.back().second.front();
        program.row.options.push_back({option, -kAny - 1, kAny, first_value, "of the program"});
        first.push_back({option, first_value});
      });
  if (!program.coordinates.empty()) {
    if (program.row.guarantee.claim == Claim::proved) {
      refuse_toml(node, "coordinates in a real type keep no guarantee: leave one of the two out");
    }
    program.row.guarantee.claim = Claim::measured;
  }
  with_location(node, [&] { command_with(program, first); });
  return made;
}

}  // namespace ar3d
