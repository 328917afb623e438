#include "subject_arguments.h"

#include <fmt/format.h>

#include <cmath>

#include "ar3d/analysis/replay.h"
#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/drawings/drawing_svg.h"
#include "ar3d/formats/graphs/sparse6.h"
#include "ar3d/model/settings.h"
#include "outputs.h"
#include "words.h"

namespace ar3d {
namespace {

constexpr EdgeId kMostEdgesInPicture = 2000;

std::string algorithm_words(const SubjectArguments& arguments) {
  std::string words = " --algorithm " + shell_word(arguments.algorithm);
  for (const std::string& option : arguments.options) words += " --set " + shell_word(option);
  return words;
}

std::string draw_line(const SubjectArguments& arguments) {
  return fmt::format("ar3d draw {}{}", shell_word(arguments.output + ".s6"),
                     algorithm_words(arguments));
}

/// The lines with which anybody sees the same again.
std::string replay_lines(const Trial& trial, const SubjectArguments& arguments) {
  const std::string graph = shell_word(arguments.output + ".s6");
  std::string lines =
      fmt::format("ar3d verify {} --graphs {}\n", shell_word(arguments.output + ".jsonl"), graph);
  if (arguments.seeded_fault.empty()) {
    return lines + fmt::format("{} | ar3d verify - --graphs {}\n", draw_line(arguments), graph);
  }
  return lines +
         fmt::format("the fault {} is seeded: {} draws the graph right\n", arguments.seeded_fault,
                     draw_line(arguments)) +
         (trial.failure.empty() ? "the seeded fault does not show\n" : "");
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
      ->check(one_of({"side", "x", "y", "z", "volume"}));
  verb.add_option("--bound", arguments.against, "theorem, or instance: the proof's for this graph")
      ->check(one_of({"theorem", "instance"}));
  verb.add_option("--seeded-fault", arguments.seeded_fault,
                  "breaks the drawings on purpose, to see that it is found: wrong-bend or "
                  "passed-bound");
  add_force(verb, arguments.force);
}

std::string shrink_line(const Trial& trial, const SubjectArguments& arguments) {
  std::string line =
      fmt::format("ar3d shrink {}{} --measure {} --bound {}", shell_word(arguments.output + ".s6"),
                  algorithm_words(arguments), arguments.measure, arguments.against);
  if (!arguments.seeded_fault.empty()) {
    line += " --seeded-fault " + shell_word(arguments.seeded_fault);
  }
  if (trial.failure.empty()) line += fmt::format(" --ratio {}", trial.ratio);
  return line + " -o " + shell_word(arguments.output + "-small");
}

void refuse_unsafe_exhibit(const SubjectArguments& arguments, const std::string& input) {
  const std::string& prefix = arguments.output;
  if (prefix == "-") {
    throw InputError("-o is the beginning of several files' names here, not a stream");
  }
  if (prefix.empty()) return;
  refuse_unsafe_outputs(
      {.inputs = {input},
       .outputs = {prefix + ".s6", prefix + ".jsonl", prefix + ".svg", prefix + ".txt"},
       .force = arguments.force});
}

Subject subject_of(const SubjectArguments& arguments) {
  const Algorithm& algorithm = find_algorithm(arguments.algorithm);
  Subject subject;
  subject.choice = {&algorithm, complete_options(algorithm, parse_settings(arguments.options))};
  if (!arguments.seeded_fault.empty()) {
    subject.fault = &find_seeded_fault(arguments.seeded_fault);
  }
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
      std::floor(trial.ratio * 1e4) / 1e4, arguments.against);
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
