#include "subject_arguments.h"

#include <fmt/format.h>

#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/drawings/drawing_svg.h"
#include "ar3d/formats/graphs/sparse6.h"
#include "ar3d/model/assignments.h"
#include "ar3d/model/error.h"
#include "ar3d/results/atomic_file.h"

namespace ar3d {
namespace {

constexpr EdgeId kMostEdgesInPicture = 2000;

std::string draw_line(const SubjectArguments& arguments) {
  std::string line =
      fmt::format("ar3d draw {}.s6 --algorithm {}", arguments.output, arguments.algorithm);
  for (const std::string& option : arguments.options) line += " --set " + option;
  return line;
}

/// The lines with which anybody sees the same again.
std::string replay_lines(const Trial& trial, const SubjectArguments& arguments) {
  std::string lines = fmt::format("ar3d verify {0}.jsonl --graphs {0}.s6\n", arguments.output);
  if (arguments.plant.empty()) {
    return lines + fmt::format("{} | ar3d verify - --graphs {}.s6\n", draw_line(arguments),
                               arguments.output);
  }
  return lines +
         fmt::format("{} is planted: {} draws the graph right\n", arguments.plant,
                     draw_line(arguments)) +
         (trial.failure.empty() ? "the planted fault does not show\n" : "");
}

}  // namespace

void add_subject_options(CLI::App& verb, SubjectArguments& arguments) {
  verb.add_option("--algorithm", arguments.algorithm, "an algorithm of `ar3d list algorithms`")
      ->required();
  verb.add_option("--set", arguments.options,
                  "an option of the algorithm, name=integer; may be repeated")
      ->type_size(1)
      ->allow_extra_args(false);
  verb.add_option("--measure", arguments.measure,
                  "whose share of the bound counts: x, y, z, side (the largest of them) or volume")
      ->check(CLI::IsMember({"side", "x", "y", "z", "volume"}));
  verb.add_option("--bound", arguments.against, "theorem, or instance: the proof's for this graph")
      ->check(CLI::IsMember({"theorem", "instance"}));
  verb.add_option("--plant", arguments.plant,
                  "breaks the drawings on purpose, to see that it is found: wrong-bend or "
                  "passed-bound");
}

CLI::Validator positive_number() {
  return {[](std::string& text) {
            double value = 0;
            const bool is_good = CLI::detail::lexical_cast(text, value) && value > 0;
            return is_good ? std::string() : text + " is not a number above 0";
          },
          "POSITIVE"};
}

Subject subject_of(const SubjectArguments& arguments) {
  const Algorithm& algorithm = find_algorithm(arguments.algorithm);
  Subject subject;
  subject.choice = {&algorithm,
                    complete_options(algorithm, parse_assignments<OptionValue>(arguments.options))};
  if (!arguments.plant.empty()) subject.fault = &find_seeded_fault(arguments.plant);
  return subject;
}

RatioRule rule_of(const SubjectArguments& arguments) {
  RatioRule rule;
  for (const auto& [name, measure] :
       {std::pair("x", Measure::x), std::pair("y", Measure::y), std::pair("z", Measure::z),
        std::pair("volume", Measure::volume)}) {
    if (arguments.measure == name) rule.measure = measure;
  }
  if (arguments.against == "instance") rule.against = Against::instance;
  return rule;
}

std::string trial_text(const Trial& trial, const SubjectArguments& arguments) {
  std::string text = fmt::format(
      "{} vertices, {} edges: box {} x {} x {} of {:.6g} x {:.6g} x {:.6g}; "
      "{} is {:.4f} of the {}'s bound\n",
      trial.graph.num_vertices(), trial.graph.num_edges(), trial.extents[0], trial.extents[1],
      trial.extents[2], trial.bound[0], trial.bound[1], trial.bound[2], arguments.measure,
      trial.ratio, arguments.against);
  if (trial.failure.empty()) return text;
  return text + fmt::format("VIOLATED: {}: {}\n", trial.failure, trial.message);
}

void write_exhibit(const Subject& subject, const Trial& trial, const SubjectArguments& arguments) {
  const std::string& prefix = arguments.output;
  std::string graph;
  append_sparse6(graph, trial.graph);
  write_file_atomically(prefix + ".s6", graph);
  if (trial.failure != "internal_error") {
    const Drawing drawing = draw_subject(subject, trial.graph);
    std::string line;
    append_drawing_line(line, drawing);
    write_file_atomically(prefix + ".jsonl", line);
    if (trial.graph.num_edges() <= kMostEdgesInPicture) {
      write_file_atomically(prefix + ".svg", drawing_to_svg(drawing));
    }
  }
  const std::string lines = replay_lines(trial, arguments);
  write_file_atomically(prefix + ".txt", trial_text(trial, arguments) + lines);
  fmt::print("wrote {}.txt and what it names\n{}", prefix, lines);
}

}  // namespace ar3d
