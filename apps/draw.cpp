// `ar3d draw`: every graph of a file, many at a time or a large one with all threads.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/catalog.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/model/settings.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/coordinate_width.h"
#include "batches.h"
#include "commands.h"
#include "drawing_summary.h"
#include "options.h"
#include "outputs.h"

namespace ar3d {
namespace {

struct DrawArguments {
  std::vector<std::string> inputs = {"-"};
  ReadOptions graphs;
  std::optional<std::string> algorithm;
  std::vector<std::string> options;
  std::string format;
  std::string output = "-";
  std::optional<std::string> certificate;
  std::string coordinates = "auto";
  std::string level = "full";
  ExportOptions picture;
  bool force = false;
};

/// An algorithm and the options it draws with.
struct Drawer {
  const Algorithm& algorithm;
  Settings options;
  bool is_told = true;  ///< false: chosen by the program, which is still to be said
};

/// Holds how the drawings are made and judged.
struct DrawJob {
  std::vector<Drawer> drawers;  ///< the one asked for, or those that the degree decides between
  CertificateMode certificate;
  Level level = Level::full;
  std::optional<CoordinateWidth> width = {};
};

struct GraphToDraw {
  Graph graph;
  const Drawer& drawer;
  std::string where;  // "FILE:LINE"
  std::shared_ptr<const std::vector<std::string>> names;
};

using GraphInputs = SeveralInputs<GraphReader>;

/// The first of the drawers whose theorem holds for the graph, else the last; the program's choice
/// is said once.
const Drawer& drawer_of(const Graph& graph, std::vector<Drawer>& drawers,
                        const std::string& where) {
  const auto draws = [&](const Drawer& drawer) {
    return graph.max_degree() <= drawer.algorithm.guarantee.max_degree;
  };
  const auto drawer = std::ranges::find_if(drawers, draws);
  if (drawer == drawers.end()) return drawers.back();
  if (!drawer->is_told) {
    log(stderr, "ar3d: {}: degree {}, drawn with {}; --algorithm says otherwise\n",
        printable(where), graph.max_degree(), drawer->algorithm.name);
    drawer->is_told = true;
  }
  return *drawer;
}

std::optional<GraphToDraw> next_graph(GraphInputs& inputs, DrawJob& job) {
  std::optional<Graph> graph = inputs.next();
  if (!graph) return std::nullopt;
  log_notes(inputs.reader().take_notes());
  const std::string where = inputs.reader().where();
  const Drawer& drawer = drawer_of(*graph, job.drawers, where);
  GraphToDraw task{std::move(*graph), drawer, where, {}};
  std::vector<std::string> names = inputs.reader().names();
  if (!names.empty())
    task.names = std::make_shared<const std::vector<std::string>>(std::move(names));
  return task;
}

/// @throws InputError if it does not fit the width that is asked for, too.
Drawing fitting_drawing(const GraphToDraw& task, const DrawJob& job) {
  const Algorithm& algorithm = task.drawer.algorithm;
  Drawing drawing = draw(algorithm, task.graph, task.drawer.options);
  if (job.width) require_width(*job.width, algorithm.guarantee.bound, drawing);
  drawing.names = task.names;
  return drawing;
}

/// Holds what comes of a graph: a drawing of few points as its line already, a larger one as
/// itself, so that no line of it is ever held as a whole; or why it could not be drawn, and what is
/// wrong with the drawing.
struct DrawnLine {
  std::string line;
  std::optional<Drawing> drawing;
  Examination examination;  ///< unless the level is full
  std::optional<std::string> error;
  std::optional<std::string> violation = {};
};

constexpr std::uint64_t kLongLine = std::uint64_t{1} << 16;  // vertices and edges

std::uint64_t weight_of(const Graph& graph) {
  return std::uint64_t{graph.num_vertices()} + graph.num_edges();
}

/// Holds what became of all drawings.
struct DrawOutcome {
  bool all_drawn = true;
  bool is_violated = false;
  bool all_proved = true;  ///< of those that were to be judged
  int exit_code() const {
    if (is_violated) return kViolated;
    if (!all_drawn) return kUsage;
    return all_proved ? kPass : kIncomplete;
  }
};

/// The first violation of a drawing that is to be judged.
std::optional<std::string> judge(const GraphToDraw& task, const Drawing& drawing,
                                 const DrawJob& job) {
  if (job.certificate == CertificateMode::none) return std::nullopt;
  const Certificate certificate = certify(task.graph, drawing, task.drawer.algorithm.guarantee);
  if (!certificate.violated()) return std::nullopt;
  return certificate.violations.empty() ? "a coordinate is out of range"
                                        : certificate.violations.front().message;
}

void report(const std::string& where, const std::string& what) {
  print(stderr, "ar3d: {}\n", printable(fmt::format("{}: {}", where, what)));
}

DrawnLine drawn(const GraphToDraw& task, const DrawJob& job) {
  DrawnLine result;
  try {
    Drawing drawing = fitting_drawing(task, job);
    if (job.level != Level::full) {
      result.examination =
          examine_all(task.graph, drawing, task.drawer.algorithm.guarantee, job.certificate);
    } else if (const auto violation = judge(task, drawing, job)) {
      result.violation = fmt::format("{}: violated: {}", task.where, *violation);
    }
    if (job.level == Level::full && weight_of(task.graph) < kLongLine) {
      append_drawing_line(result.line, drawing);
    } else {
      result.drawing = std::move(drawing);
    }
  } catch (const InputError& error) {
    result.error = fmt::format("{}: {}", task.where, error.what());
    append_error_line(result.line, {task.graph.num_vertices(), error.what()});
  }
  return result;
}

void write(const DrawnLine& drawn, Level level, OutputFile& file, DrawOutcome& outcome) {
  file.append(drawn.line);
  if (drawn.error) {
    outcome.all_drawn = false;
  } else if (level != Level::full) {
    outcome.is_violated |= drawn.examination.certificate.violated();
    outcome.all_proved &= drawn.examination.certificate.valid();
    write_summary_line(file, *drawn.drawing, drawn.examination, level);
  } else if (drawn.drawing) {
    write_drawing_line(file, *drawn.drawing);
  }
  if (drawn.violation) outcome.is_violated = true;
  for (const auto& text : {drawn.error, drawn.violation}) {
    if (text) print(stderr, "ar3d: {}\n", printable(*text));
  }
}

/// Every graph of the input as one line; a graph outside the guarantee gives an error line and the
/// others go on.
DrawOutcome draw_all(GraphInputs& inputs, DrawJob& job, OutputFile& file) {
  DrawOutcome outcome;
  in_batches<GraphToDraw>(
      [&] { return next_graph(inputs, job); },
      [](const GraphToDraw& task) { return weight_of(task.graph); },
      [&](const GraphToDraw& task) { return drawn(task, job); },
      [&](const DrawnLine& result) { write(result, job.level, file, outcome); });
  return outcome;
}

/// The drawings of the input's graphs one after the other. What could not be drawn is also said on
/// standard error if others may follow.
NextDrawing drawings_of(GraphInputs& inputs, DrawJob& job, bool others_follow,
                        DrawOutcome& outcome) {
  return [&, others_follow]() -> std::optional<PlacedLine> {
    const std::optional<GraphToDraw> task = next_graph(inputs, job);
    if (!task) return std::nullopt;
    try {
      Drawing drawing = fitting_drawing(*task, job);
      if (const auto violation = judge(*task, drawing, job)) {
        outcome.is_violated = true;
        report(task->where, "violated: " + *violation);
      }
      return PlacedLine{std::move(drawing), task->where};
    } catch (const InputError& error) {
      outcome.all_drawn = false;
      if (others_follow) report(task->where, error.what());
      return PlacedLine{UndrawnGraph{task->graph.num_vertices(), error.what()}, task->where};
    }
  };
}

/// Left out, the degree decides between two that promise exact angles and at most three bends.
std::vector<Drawer> drawers_of(const DrawArguments& arguments) {
  std::vector<std::string> names = {"grid", "diamond"};
  if (arguments.algorithm) names = {*arguments.algorithm};
  const Settings given = parse_settings(arguments.options);
  std::vector<Drawer> drawers;
  for (const std::string& name : names) {
    const Algorithm& row = find_algorithm(name);
    drawers.push_back({row, complete_options(row, given), arguments.algorithm.has_value()});
  }
  return drawers;
}

int draw_graphs(const DrawArguments& arguments) {
  refuse_unsafe_outputs(
      {.inputs = arguments.inputs, .outputs = {arguments.output}, .force = arguments.force});
  const Level level = parse_level(arguments.level);
  const char* usual_mode = level == Level::full ? "none" : "exact";
  const std::string mode = arguments.certificate.value_or(usual_mode);
  DrawJob job{drawers_of(arguments), parse_certificate_mode(mode), level,
              arguments.coordinates == "auto"
                  ? std::nullopt
                  : std::optional(parse_coordinate_width(arguments.coordinates))};
  const DrawingFormat& format = drawing_format(arguments.format, arguments.output);
  if (level != Level::full && format.name != "jsonl") {
    throw InputError(
        fmt::format("--level {} is written as jsonl, not as {}", to_string(level), format.name));
  }
  GraphInputs inputs(arguments.inputs, [&](const std::string& path) {
    return std::make_unique<GraphReader>(path, arguments.graphs);
  });
  DrawOutcome outcome;
  if (format.name == "jsonl") {  // many at a time
    OutputFile file(arguments.output);
    outcome = draw_all(inputs, job, file);
    file.commit();
  } else {
    format.write(drawings_of(inputs, job, format.many_per_file, outcome), arguments.output,
                 arguments.picture);
  }
  // At the other levels each drawing has been asked.
  outcome.all_proved &= level != Level::full || job.certificate == CertificateMode::none ||
                        job.drawers.front().algorithm.guarantee.claim == Claim::proved;
  return outcome.exit_code();
}

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand("draw", "Draws every graph of files");
  const auto arguments = std::make_shared<DrawArguments>();
  verb->add_option("FILE", arguments->inputs,
                   "graphs in any input format, gzip and xz too; - is standard input; several are "
                   "read one after the other");
  add_graph_input_options(*verb, arguments->graphs);
  verb->add_option(
      "--algorithm", arguments->algorithm,
      "an algorithm of `ar3d list algorithms`; left out, grid draws the graphs of degree at "
      "most 3 and diamond the others");
  add_repeated(*verb, "--set", arguments->options,
               "an option of the algorithm, name=integer; may be repeated");
  verb->add_option("--format", arguments->format,
                   "one of those below; by the file's ending, jsonl without one");
  verb->add_option(
      "--certificate", arguments->certificate,
      "exact: judge every drawing; exit code 4 if one is violated, 5 if one is not proved (a real "
      "type). none: judge none. Left out: exact at the levels extents and positions, else none");
  verb->add_option(
          "--level", arguments->level,
          "extents: one line per graph with box, bends, lengths, metrics and verdict instead "
          "of the drawing; positions: the vertices' positions, too; full: the drawing")
      ->check(one_of({"extents", "positions", "full"}));
  verb->add_option("--coordinates", arguments->coordinates,
                   "auto, or a width that drawings have to fit, else their line is an error: "
                   "proved=int16, int32, int64 by the theorem's bound, checked=int16, ... by their "
                   "own box");
  add_threads_option(*verb);
  ExportOptions& view = arguments->picture;
  verb->add_option("--turn", view.turn_degrees, "svg, tikz: turn about the z axis, degrees")
      ->check(finite_number(false));
  verb->add_option("--tilt", view.tilt_degrees, "svg, tikz: 0 is seen from above, 90 from the side")
      ->check(finite_number(false));
  verb->add_option("--perspective", view.perspective,
                   "svg, tikz: distance of the eye from the middle, in diagonals of the box; "
                   "orthographic if left out")
      ->default_str("")
      ->check(finite_number(true));
  verb->add_flag("--stretch", view.stretch,
                 "svg, tikz: scale the axes so that the box is a cube; angles are not true then");
  verb->add_option("--tube", view.tube_radius, "stl: radius of the tubes in lattice units")
      ->check(finite_number(true));
  verb->add_option("-o,--output", arguments->output, "file, or - for standard output");
  add_force(*verb, arguments->force);
  for (const char* of_pictures : {"--turn", "--tilt", "--perspective", "--stretch", "--tube"}) {
    verb->get_option(of_pictures)->group("Options of pictures");
  }
  for (const char* of_input :
       {"--from", "--base", "--first-line", "--undirected", "--trust-sizes"}) {
    verb->get_option(of_input)->group("Options of the input");
  }
  verb->footer(
      drawing_formats_text() +
      "Example: nauty-geng -D4 7 | ar3d draw - --algorithm diamond --set effort=2 | ar3d verify -");
  verb->callback([arguments, &exit_code] { exit_code = draw_graphs(*arguments); });
}

}  // namespace ar3d
