// `ar3d verify`: judges drawings against a guarantee, many at a time.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/examination.h"
#include "batches.h"
#include "commands.h"
#include "options.h"
#include "promise.h"
#include "view.h"

namespace ar3d {
namespace {

struct VerifyArguments {
  std::vector<std::string> inputs = {"-"};
  std::vector<std::string> graphs;
  ReadOptions graphs_as;
  std::string algorithm;
  PromiseArguments promise;
  std::string test = "automatic";
  std::string certificate = "exact";
};

/// With the graph of --graphs.
using LineToJudge = std::pair<PlacedLine, std::optional<Graph>>;

/// The promise that a drawing is held to. @throws InputError as find_algorithm.
Guarantee promise_of(const Drawing& drawing, const VerifyArguments& arguments) {
  if (const auto given = promise_of(arguments.promise)) return *given;
  const std::string& name = arguments.algorithm;
  return find_algorithm(name.empty() ? drawing.algorithm() : name).guarantee;
}

/// Names what becomes of a line.
enum class LineVerdict {
  certified,
  violated,
  not_drawn,
  measured,  ///< in a real type, not violated: nothing is proved
  unproved,  ///< not violated, by another certificate than exact
  unknown,   ///< of an algorithm whose promises are not known here
};
using JudgedLine = std::pair<LineVerdict, std::string>;  // with what is printed of it

CrossingTest crossing_test(const std::string& name) {
  if (name == "all-pairs") return CrossingTest::all_pairs;
  if (name == "halving") return CrossingTest::halving;
  return CrossingTest::automatic;
}

JudgedLine judge(const LineToJudge& task, const VerifyArguments& arguments) {
  const auto& placed = task.first;
  if (const auto* undrawn = std::get_if<UndrawnGraph>(&placed.line)) {
    return {LineVerdict::not_drawn,
            fmt::format("{}: not drawn: {}\n", placed.where, undrawn->error)};
  }
  const Drawing& drawing = std::get<Drawing>(placed.line);
  if (arguments.algorithm.empty() && !arguments.promise.bends &&
      known_algorithm(drawing.algorithm()) == nullptr) {
    return {
        LineVerdict::unknown,
        fmt::format("{}: not judged: no algorithm here is called '{}'{} "
                    "(--algorithm judges it by another one's guarantee, --bends by a promise)\n",
                    placed.where, printable(drawing.algorithm()),
                    did_you_mean(drawing.algorithm(), names_of(algorithms())))};
  }
  try {
    const Guarantee promise = promise_of(drawing, arguments);
    const bool leaves_box_open = arguments.promise.bends && arguments.promise.box.empty();
    const Graph graph = task.second ? *task.second : claimed_graph(drawing);
    const Examination examination =
        examine(graph, drawing, promise, {.certificate = true, .metrics = false, .hash = false},
                {.crossing_test = crossing_test(arguments.test),
                 .check_size = !leaves_box_open,
                 .mode = parse_certificate_mode(arguments.certificate),
                 .compares = [&](std::uint64_t pairs) {
                   log(stderr, "ar3d: {}: compares {} pairs of segments\n", placed.where, pairs);
                 }});
    const Certificate& certificate = examination.certificate;
    if (certificate.given_up && certificate.violations.empty()) {
      return {LineVerdict::unknown,
              fmt::format("{}: not judged: its segments need more than {} comparisons, as they lie "
                          "in one plane or side by side\n",
                          placed.where, kMostComparisons)};
    }
    std::string text;
    for (const Violation& violation : certificate.violations) {
      text +=
          fmt::format("{}: {}: {}\n", placed.where, to_string(violation.kind), violation.message);
    }
    if (examination.summary.real) {
      const RealAssessment& found = *examination.summary.real;
      text += fmt::format(
          "{}: in {}: angles miss by at most {:.6g} degrees, {} crossings, {} collapsed segments\n",
          placed.where, drawing.real->type, found.largest_miss, found.crossings, found.collapsed);
    }
    if (!certificate.complete) text += fmt::format("{}: … and more\n", placed.where);
    const bool is_unproved = certificate.mode == CertificateMode::none;
    return {certificate.violated() ? LineVerdict::violated
            : certificate.measured ? LineVerdict::measured
            : is_unproved          ? LineVerdict::unproved
                                   : LineVerdict::certified,
            text};
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", placed.where, error.what()));
  }
}

/// Holds how many lines became of each kind.
using Counts = std::array<std::uint64_t, static_cast<std::size_t>(LineVerdict::unknown) + 1>;

constexpr const char* kVerdictNames[] = {"certified", "violated",   "not_drawn",
                                         "measured",  "not_proved", "not_judged"};

nlohmann::ordered_json counts_json(const Counts& counts, nlohmann::ordered_json&& messages) {
  nlohmann::ordered_json json;
  for (std::size_t i = 0; i < counts.size(); ++i) json[kVerdictNames[i]] = counts[i];
  json["messages"] = std::move(messages);
  return json;
}

std::string summary(const Counts& counts, const std::string& certificate) {
  const auto [certified, violated, not_drawn, measured, unproved, unknown] = counts;
  return fmt::format(
      "{} certified, {} violated, {} not drawn{}{}{}\n", certified, violated, not_drawn,
      unknown > 0 ? fmt::format(", {} not judged", unknown) : "",
      measured > 0 ? fmt::format(", {} measured", measured) : "",
      unproved > 0 ? fmt::format(", {} not proved (certificate {})", unproved, certificate) : "");
}

int exit_code_of(const Counts& counts) {
  const auto [certified, violated, not_drawn, measured, unproved, unknown] = counts;
  if (violated > 0) return kViolated;
  const bool is_all = not_drawn + measured + unproved + unknown == 0;
  return is_all && certified > 0 ? kPass : kIncomplete;
}

/// The next drawing, with its graph if --graphs was given. @throws InputError if one of the two is
/// missing. @param number  of drawings so far.
std::optional<LineToJudge> next_task(const VerifyArguments& arguments,
                                     SeveralInputs<DrawingJsonlReader>& drawings,
                                     SeveralInputs<GraphReader>* graphs, std::uint64_t number) {
  std::optional<DrawingJsonlReader::Line> line = drawings.next();
  std::optional<Graph> graph;
  if (graphs != nullptr) {
    graph = graphs->next();
    log_notes(graphs->reader().take_notes());
  }
  if (graphs != nullptr && line.has_value() != graph.has_value()) {
    const std::string graph_files = fmt::format("{}", fmt::join(arguments.graphs, " "));
    const std::string files = fmt::format("{}", fmt::join(arguments.inputs, " "));
    throw InputError(graph ? fmt::format("{} has more graphs than {} has drawings: {}", graph_files,
                                         files, number)
                           : fmt::format("{} has {} graphs, but {} has more drawings", graph_files,
                                         number, files));
  }
  if (!line) return std::nullopt;
  return LineToJudge{{std::move(*line), drawings.reader().where()}, std::move(graph)};
}

int verify_drawings(const VerifyArguments& arguments) {
  // Before any work.
  parse_certificate_mode(arguments.certificate);
  if (!arguments.algorithm.empty()) find_algorithm(arguments.algorithm);
  promise_of(arguments.promise);
  SeveralInputs<DrawingJsonlReader> drawings(arguments.inputs, [](const std::string& path) {
    return std::make_unique<DrawingJsonlReader>(path);
  });
  std::optional<SeveralInputs<GraphReader>> graphs;
  if (!arguments.graphs.empty()) {
    graphs.emplace(arguments.graphs, [&](const std::string& path) {
      return std::make_unique<GraphReader>(path, arguments.graphs_as);
    });
  }
  std::uint64_t number = 0;
  Counts counts{};
  nlohmann::ordered_json messages = nlohmann::ordered_json::array();  // of --json
  in_batches<LineToJudge>(
      [&] {
        auto task = next_task(arguments, drawings, graphs ? &*graphs : nullptr, number);
        number += task.has_value();
        return task;
      },
      [](const LineToJudge& task) { return weight_of(task.first.line); },
      [&](const LineToJudge& task) { return judge(task, arguments); },
      [&](const JudgedLine& line) {
        ++counts[static_cast<std::size_t>(line.first)];
        if (is_quiet_output || line.second.empty()) return;
        log(stdout, "{}", line.second);
        if (!is_json_output) return;
        messages.push_back({{"verdict", kVerdictNames[static_cast<std::size_t>(line.first)]},
                            {"text", line.second}});
      });
  print_result(counts_json(counts, std::move(messages)), "{}",
               summary(counts, arguments.certificate));
  return exit_code_of(counts);
}

}  // namespace

void add_verify(CLI::App& app, int& exit_code) {
  CLI::App* verb =
      app.add_subcommand("verify", "Proves drawings right in exact integers, or says why not");
  const auto arguments = std::make_shared<VerifyArguments>();
  verb->add_option("FILE", arguments->inputs,
                   "drawings as JSON lines; - is standard input; several are read one after the "
                   "other");
  add_repeated(*verb, "--graphs", arguments->graphs,
               "the graphs that were to be drawn, in the same order; may be repeated; else the "
               "drawings' own edges count");
  add_graph_input_options(*verb, arguments->graphs_as);
  CLI::Option* algorithm =
      verb->add_option("--algorithm", arguments->algorithm,
                       "whose guarantee to check; else the one the drawing names");
  add_promise_options(*verb, arguments->promise);
  verb->get_option("--bends")->excludes(algorithm);
  CLI::Option* test = verb->add_option("--crossing-test", arguments->test,
                                       "automatic, all-pairs (the slow oracle) or halving");
  test->check(one_of({"automatic", "all-pairs", "halving"}));
  verb->add_option("--certificate", arguments->certificate, "exact, or none: nothing is judged")
      ->excludes(test);
  add_threads_option(*verb);
  verb->add_flag("-q,--quiet", is_quiet_output, "only the summary");
  add_json(*verb);
  verb->footer(
      "Exit code 4 if a drawing is violated. Exit code 5 if a graph was not drawn, a drawing's "
      "algorithm is not known here, or its points are of a real type (its misses are measured). "
      "Exit code 5, too, for a certificate other than exact, and if nothing was verified.\n"
      "Example: ar3d draw graphs.s6 --algorithm diamond | ar3d verify - --graphs graphs.s6");
  verb->callback([arguments, &exit_code] { exit_code = verify_drawings(*arguments); });
}

}  // namespace ar3d
