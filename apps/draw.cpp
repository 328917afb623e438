#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/model/error.h"
#include "ar3d/model/printable.h"
#include "ar3d/model/settings.h"
#include "ar3d/verify/certificate.h"
#include "batches.h"
#include "commands.h"
#include "drawing_formats.h"
#include "graph_input.h"
#include "numbers.h"
#include "outputs.h"

namespace ar3d {
namespace {

struct DrawArguments {
  std::string input = "-";
  GraphInput graphs;
  std::string algorithm;
  std::vector<std::string> options;
  std::string format;
  std::string output = "-";
  std::string certificate = "none";
  ExportOptions picture;
  bool force = false;
};

/// How the drawings are made and judged.
struct Making {
  const Algorithm& algorithm;
  Settings options;
  CertificateMode certificate;
};

struct Task {
  Graph graph;
  std::string where;  // "FILE:LINE"
};

/// A line of output, why the graph could not be drawn if it could not, and what is wrong with the
/// drawing.
struct Line {
  std::string text;
  std::optional<std::string> error;
  std::optional<std::string> violation = {};
};

/// What became of all drawings.
struct Outcome {
  bool all_drawn = true;
  bool is_violated = false;
};

/// The first violation of the drawing that the certificate finds. InputError passes: a mode that
/// does not take such a drawing.
std::optional<std::string> violation_of(const Graph& graph, const Drawing& drawing,
                                        const Making& making) {
  if (making.certificate.kind == CertificateMode::Kind::none) return std::nullopt;
  const Certificate certificate =
      certify(graph, drawing, making.algorithm.guarantee, {.mode = making.certificate});
  if (!certificate.violated()) return std::nullopt;
  return certificate.violations.empty() ? "a coordinate is out of range"
                                        : certificate.violations.front().message;
}

void report(const std::string& where, const std::string& what) {
  fmt::print(stderr, "ar3d: {}\n", printable(fmt::format("{}: {}", where, what)));
}

/// Every graph of the input as one line; a graph outside the guarantee gives an error line and the
/// others go on.
Outcome draw_all(GraphReader& reader, const Making& making, OutputFile& file) {
  Outcome outcome;
  in_batches<Task>(
      [&]() -> std::optional<Task> {
        std::optional<Graph> graph = reader.next();
        if (!graph) return std::nullopt;
        return Task{std::move(*graph), reader.where()};
      },
      [](const Task& task) {
        return std::uint64_t{task.graph.num_vertices()} + task.graph.num_edges();
      },
      [&](const Task& task) {
        Line line;
        try {
          const Drawing drawing = draw(making.algorithm, task.graph, making.options);
          if (const auto found = violation_of(task.graph, drawing, making)) {
            line.violation = fmt::format("{}: violated: {}", task.where, *found);
          }
          append_drawing_line(line.text, drawing);
        } catch (const InputError& error) {
          line.error = fmt::format("{}: {}", task.where, error.what());
          append_error_line(line.text, {task.graph.num_vertices(), error.what()});
        }
        return line;
      },
      [&](const Line& line) {
        file.append(line.text);
        if (line.error) outcome.all_drawn = false;
        if (line.violation) outcome.is_violated = true;
        for (const auto& text : {line.error, line.violation}) {
          if (text) fmt::print(stderr, "ar3d: {}\n", printable(*text));
        }
      });
  return outcome;
}

/// The drawings of the input's graphs one after the other. What could not be drawn is also said on
/// standard error if others may follow.
NextDrawing drawings_of(GraphReader& reader, const Making& making, bool others_follow,
                        Outcome& outcome) {
  return [&, others_follow]() -> std::optional<PlacedLine> {
    const std::optional<Graph> graph = reader.next();
    if (!graph) return std::nullopt;
    try {
      Drawing drawing = draw(making.algorithm, *graph, making.options);
      if (const auto found = violation_of(*graph, drawing, making)) {
        outcome.is_violated = true;
        report(reader.where(), "violated: " + *found);
      }
      return PlacedLine{std::move(drawing), reader.where()};
    } catch (const InputError& error) {
      outcome.all_drawn = false;
      if (others_follow) report(reader.where(), error.what());
      return PlacedLine{UndrawnGraph{graph->num_vertices(), error.what()}, reader.where()};
    }
  };
}

int draw_graphs(const DrawArguments& arguments) {
  refuse_unsafe_outputs(
      {.inputs = {arguments.input}, .outputs = {arguments.output}, .force = arguments.force});
  const Algorithm& algorithm = find_algorithm(arguments.algorithm);
  const Making making{algorithm, complete_options(algorithm, parse_settings(arguments.options)),
                      parse_certificate_mode(arguments.certificate)};
  const DrawingFormat& format = drawing_format(arguments.format, arguments.output);
  GraphReader reader(arguments.input, arguments.graphs.read_options());
  Outcome outcome;
  if (format.name == "jsonl") {  // many at a time
    OutputFile file(arguments.output);
    outcome = draw_all(reader, making, file);
    file.commit();
  } else {
    format.write(drawings_of(reader, making, format.many_per_file, outcome), arguments.output,
                 arguments.picture);
  }
  if (outcome.is_violated) return kViolated;
  return outcome.all_drawn ? kPass : kUsage;
}

}  // namespace

void add_draw(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand("draw", "Draws every graph of a file");
  const auto arguments = std::make_shared<DrawArguments>();
  verb->add_option("FILE", arguments->input,
                   "graphs in any input format, gzip and xz too; - is standard input");
  add_graph_input_options(*verb, arguments->graphs);
  verb->add_option("--algorithm", arguments->algorithm, "an algorithm of `ar3d list algorithms`")
      ->required();
  verb->add_option("--set", arguments->options,
                   "an option of the algorithm, name=integer; may be repeated")
      ->type_size(1)
      ->allow_extra_args(false);
  verb->add_option("--format", arguments->format,
                   "one of those below; by the file's ending, jsonl without one");
  verb->add_option("--certificate", arguments->certificate,
                   "judge every drawing: exact, filtered, double, sample=K, or none, which is the "
                   "default; exit code 4 if one is violated");
  PictureView& view = arguments->picture.view;
  verb->add_option("--turn", view.turn_degrees, "svg, tikz: turn about the z axis, degrees")
      ->check(finite_number(false));
  verb->add_option("--tilt", view.tilt_degrees, "svg, tikz: 0 is seen from above, 90 from the side")
      ->check(finite_number(false));
  verb->add_option("--perspective", view.perspective,
                   "svg, tikz: distance of the eye from the middle, in diagonals of the box; "
                   "orthographic if left out")
      ->check(finite_number(true));
  verb->add_flag("--stretch", view.stretch,
                 "svg, tikz: scale the axes so that the box is a cube; angles are not true then");
  verb->add_option("--tube", arguments->picture.tube_radius,
                   "stl: radius of the tubes in lattice units")
      ->check(finite_number(true));
  verb->add_option("-o,--output", arguments->output, "file, or - for standard output");
  add_force(*verb, arguments->force);
  verb->footer(
      drawing_formats_text() +
      "Example: nauty-geng -D4 7 | ar3d draw - --algorithm diamond --set effort=2 | ar3d verify -");
  verb->callback([arguments, &exit_code] { exit_code = draw_graphs(*arguments); });
}

}  // namespace ar3d
