// `ar3d generate`: graphs of a family, or one that has a name of its own.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/generators/families.h"
#include "ar3d/model/settings.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"

namespace ar3d {
namespace {

struct GenerateArguments {
  std::string family;
  std::optional<std::uint64_t> n;
  std::uint64_t seed = 1;
  std::uint64_t count = 1;
  std::vector<std::string> parameters;
  std::string format;
  std::string output = "-";
  bool force = false;
};

[[noreturn]] void refuse_unknown(const std::string& name) {
  std::vector<std::string_view> known = names_of(families());
  const auto named = names_of(named_graphs());
  known.insert(known.end(), named.begin(), named.end());
  throw InputError(fmt::format(
      "unknown family or graph '{}'{} (see: ar3d list families, ar3d list named-graphs)", name,
      did_you_mean(name, known)));
}

/// A family with its parameters, or one of the named graphs by its name; n is that graph's then,
/// unless it was given.
FamilyChoice requested(GenerateArguments& arguments) {
  auto given = parse_settings(arguments.parameters);
  const auto is_it = [&](const auto& row) { return row.name == arguments.family; };
  const auto family = std::ranges::find_if(families(), is_it);
  if (family != families().end()) {
    if (!arguments.n) {
      throw InputError(fmt::format("family {} takes a size: -n NUMBER", family->name));
    }
    return {&*family, complete_parameters(*family, given)};
  }
  const auto graph = std::ranges::find_if(named_graphs(), is_it);
  if (graph == named_graphs().end()) refuse_unknown(arguments.family);
  given.push_back({"index", graph - named_graphs().begin()});
  const Family& named = find_family("named");
  arguments.n = arguments.n.value_or(graph->num_vertices);
  return {&named, complete_parameters(named, given)};
}

void refuse_wrapping_seeds(const GenerateArguments& arguments) {
  constexpr std::uint64_t kLast = std::numeric_limits<std::uint64_t>::max();
  if (arguments.seed <= kLast - (arguments.count - 1)) return;
  throw InputError(
      fmt::format("{} seeds from {} on pass {}", arguments.count, arguments.seed, kLast));
}

void generate_graphs(GenerateArguments arguments) {
  refuse_unsafe_outputs({.inputs = {}, .outputs = {arguments.output}, .force = arguments.force});
  refuse_wrapping_seeds(arguments);
  const FamilyChoice choice = requested(arguments);
  const GraphFormat& format = graph_format_to_write(arguments.format, arguments.output);
  OutputFile file(arguments.output);
  const GraphWriter write = format.writer(file, {});
  for (std::uint64_t i = 0; i < arguments.count; ++i) {
    const Graph graph =
        generate(*choice.family, *arguments.n, arguments.seed + i, choice.parameters);
    if (i == 0 && graph.num_vertices() != *arguments.n) {
      log(stderr, "ar3d: {} has no graph with {} vertices for these parameters: this has {}\n",
          arguments.family, *arguments.n, graph.num_vertices());
    }
    write(graph);
    file.flush_if_full();
  }
  file.append(format.tail);
  file.commit();
}

}  // namespace

void add_generate(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand("generate", "Writes graphs of a family, or a named graph");
  const auto arguments = std::make_shared<GenerateArguments>();
  verb->add_option("FAMILY", arguments->family,
                   "a family of `ar3d list families`, or a graph of `ar3d list named-graphs`")
      ->required();
  verb->add_option("-n", arguments->n,
                   "requested number of vertices; the nearest below that the family has is taken, "
                   "else its least")
      ->check(whole_number(0, std::numeric_limits<std::uint32_t>::max()));
  verb->add_option("--seed", arguments->seed, "seed of the first graph; each further one adds 1")
      ->check(whole_number(0));
  verb->add_option("--count", arguments->count, "number of graphs")->check(whole_number(1));
  add_repeated(*verb, "--set,--parameter", arguments->parameters,
               "a parameter of the family, name=integer; may be repeated");
  verb->add_option("--format", arguments->format,
                   "graph format; by the file's ending, sparse6 without one");
  verb->add_option("-o,--output", arguments->output, "file, or - for standard output");
  add_force(*verb, arguments->force);
  verb->footer(
      "Example: ar3d generate generalised-petersen -n 100 --set k=7 -o gp.s6\n"
      "or:      ar3d generate petersen");
  verb->callback([arguments] { generate_graphs(*arguments); });
}

}  // namespace ar3d
