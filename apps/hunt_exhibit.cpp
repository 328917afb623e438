// What `ar3d hunt` and `ar3d shrink` show of the graph that they end with: a text, files, and the
// lines that show it again.
#include <fmt/format.h>

#include "ar3d/base/new_file.h"
#include "ar3d/formats/drawings/drawing_exports.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/graphs/graph6.h"
#include "commands.h"
#include "hunt.h"
#include "view.h"

namespace ar3d {
namespace {

constexpr EdgeId kMostEdgesInPicture = 2000;

std::string algorithm_words(const HuntArguments& arguments) {
  std::string words = " --algorithm " + shell_word(arguments.algorithm);
  for (const std::string& option : arguments.settings) words += " --set " + shell_word(option);
  if (!arguments.study.empty()) words += " --study " + shell_word(arguments.study);
  return words;
}

std::string failure_words(const Trial& trial) {
  return trial.drawing ? "" : " --failure " + kind_of_failure(trial);
}

/// The lines with which anybody sees the same again.
std::string replay_lines(const Trial& trial, const HuntArguments& arguments) {
  const std::string graph = shell_word(arguments.output + ".s6");
  if (!arguments.study.empty() || !trial.drawing) {
    return fmt::format("ar3d shrink {}{}{} -o {}\n", graph, algorithm_words(arguments),
                       failure_words(trial), shell_word(arguments.output + "-again"));
  }
  const std::string lines =
      fmt::format("ar3d verify {} --graphs {}\n", shell_word(arguments.output + ".jsonl"), graph);
  const std::string draw = fmt::format("ar3d draw {}{}", graph, algorithm_words(arguments));
  if (arguments.seeded_fault.empty()) {
    return lines + fmt::format("{} | ar3d verify - --graphs {}\n", draw, graph);
  }
  return lines +
         fmt::format("the fault {} is seeded: {} draws the graph right\n", arguments.seeded_fault,
                     draw) +
         (trial.failure.empty() ? "the seeded fault does not show\n" : "");
}

}  // namespace

std::string kind_of_failure(const Trial& trial) {
  if (trial.drawing) return "";
  return trial.failure == to_string(RunStatus::timeout) ? "timeout" : "crash";
}

int exit_code_of(const Trial& trial) {
  return trial.failure.empty() ? kPass : trial.drawing ? kViolated : kIncomplete;
}

std::string shrink_line(const Trial& trial, const HuntArguments& arguments) {
  std::string line =
      fmt::format("ar3d shrink {}{} --measure {} --bound {}", shell_word(arguments.output + ".s6"),
                  algorithm_words(arguments), arguments.measure, arguments.against);
  if (!arguments.seeded_fault.empty()) {
    line += " --seeded-fault " + shell_word(arguments.seeded_fault);
  }
  if (trial.failure.empty()) line += fmt::format(" --ratio {}", trial.ratio);
  return line + failure_words(trial) + " -o " + shell_word(arguments.output + "-small");
}

nlohmann::ordered_json trial_json(const Trial& trial, const HuntArguments& arguments) {
  const auto if_drawn = [&](const nlohmann::ordered_json& value) {
    return trial.drawing ? value : nlohmann::ordered_json();
  };
  return {{"n", trial.graph.num_vertices()},
          {"m", trial.graph.num_edges()},
          {"extents", if_drawn(trial.extents)},
          {"bound", if_drawn(trial.bound)},
          {"measure", arguments.measure},
          {"against", arguments.against},
          {"ratio", if_drawn(trial.ratio)},
          {"failure", trial.failure},
          {"message", trial.message}};
}

std::string trial_text(const Trial& trial, const HuntArguments& arguments) {
  if (!trial.drawing) {
    return fmt::format("{} vertices, {} edges: NOT DRAWN: {}: {}\n", trial.graph.num_vertices(),
                       trial.graph.num_edges(), trial.failure, trial.message);
  }
  std::string text = fmt::format(
      "{} vertices, {} edges: box {} x {} x {} of {:.6g} x {:.6g} x {:.6g}; "
      "{} is {:.6g} of the {}'s bound\n",
      trial.graph.num_vertices(), trial.graph.num_edges(), trial.extents[0], trial.extents[1],
      trial.extents[2], trial.bound[0], trial.bound[1], trial.bound[2], arguments.measure,
      trial.ratio, arguments.against);
  if (trial.failure.empty()) return text;
  return text + fmt::format("VIOLATED: {}: {}\n", trial.failure, trial.message);
}

void write_exhibit(const Trial& trial, const HuntArguments& arguments) {
  const std::string& prefix = arguments.output;
  std::string graph;
  append_sparse6(graph, trial.graph);
  write_file_atomically(prefix + ".s6", graph);
  if (trial.drawing) {
    std::string line;
    append_drawing_line(line, *trial.drawing);
    write_file_atomically(prefix + ".jsonl", line);
    if (trial.graph.num_edges() <= kMostEdgesInPicture) {
      write_file_atomically(prefix + ".svg", drawing_to_svg(*trial.drawing));
    }
  }
  const std::string lines = replay_lines(trial, arguments);
  write_file_atomically(prefix + ".txt", trial_text(trial, arguments) + lines);
  log(stdout, "wrote {}.txt and what it names\n{}", prefix, lines);
}

}  // namespace ar3d
