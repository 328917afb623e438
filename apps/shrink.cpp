#include "ar3d/bench/search/shrink.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"
#include "commands.h"
#include "graph_input.h"
#include "numbers.h"
#include "subject_arguments.h"

namespace ar3d {
namespace {

struct ShrinkArguments {
  SubjectArguments subject;
  std::string input;
  GraphInput graph;
  std::optional<double> ratio;
  std::uint64_t evaluations = 100000;
};

Graph only_graph(const std::string& path, const ReadOptions& options) {
  GraphReader reader(path, options);
  const std::optional<Graph> graph = reader.next();
  if (!graph) throw InputError(fmt::format("{}: no graph", path));
  if (reader.next())
    throw InputError(fmt::format("{}: a second graph; one is wanted", reader.where()));
  return *graph;
}

int shrink_and_show(const ShrinkArguments& arguments) {
  refuse_unsafe_exhibit(arguments.subject, arguments.input);
  const Subject subject = subject_of(arguments.subject);
  const RatioRule rule = rule_of(arguments.subject);
  const Graph graph = only_graph(arguments.input, arguments.graph.read_options());
  const Trial whole = try_graph(subject, rule, graph);
  const bool keeps_failure = !arguments.ratio;
  if (keeps_failure && whole.failure.empty()) {
    throw InputError(
        fmt::format("{}: its drawing is proved right; give --ratio to shrink it", arguments.input));
  }
  if (!keeps_failure && !(whole.ratio >= *arguments.ratio)) {
    throw InputError(fmt::format("{}: its ratio is {}, less than {}", arguments.input, whole.ratio,
                                 *arguments.ratio));
  }
  const ShrinkResult result = shrink(
      graph,
      [&](const Graph& candidate) {
        const Trial trial = try_graph(subject, rule, candidate);
        return keeps_failure ? trial.failure == whole.failure : trial.ratio >= *arguments.ratio;
      },
      arguments.evaluations);
  const Trial least = try_graph(subject, rule, result.graph);
  fmt::print("{} of {} vertices and {} of {} edges are left after {} drawings{}\n",
             result.graph.num_vertices(), graph.num_vertices(), result.graph.num_edges(),
             graph.num_edges(), result.evaluations,
             result.minimal ? "; none can go" : "; the evaluations ran out");
  fmt::print("{}", trial_text(least, arguments.subject));
  write_exhibit(subject, least, arguments.subject);
  return least.failure.empty() ? kPass : kViolated;
}

}  // namespace

void add_shrink(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "shrink", "Reduces a graph whose drawing is violated or extreme while it stays so");
  const auto arguments = std::make_shared<ShrinkArguments>();
  verb->add_option("GRAPH", arguments->input, "one graph in any input format")->required();
  add_graph_input_options(*verb, arguments->graph);
  add_subject_options(*verb, arguments->subject);
  verb->add_option("--ratio", arguments->ratio,
                   "keep the share of the bound at least this; else the violation stays")
      ->check(finite_number(true));
  verb->add_option("--evaluations", arguments->evaluations, "at most so many drawings")
      ->check(whole_number(1, 1000000000));
  verb->add_option("-o,--output", arguments->subject.output,
                   "prefix of the files that show what is left: .s6, .jsonl, .svg, .txt")
      ->required();
  verb->footer(
      "Exit code 4 if the drawing is violated.\n"
      "Example: ar3d shrink tall.s6 --algorithm diamond --measure z --ratio 0.8 -o small");
  verb->callback([arguments, &exit_code] { exit_code = shrink_and_show(*arguments); });
}

}  // namespace ar3d
