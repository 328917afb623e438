// `ar3d optimum`: the smallest box of all drawings of a graph, by formulas that a solver answers.
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/graphs/graph6.h"
#include "ar3d/optimum/smallest_box.h"
#include "batches.h"
#include "commands.h"
#include "options.h"
#include "outputs.h"

namespace ar3d {
namespace {

using optimum::Diagonals;
using optimum::FormulaRecord;
using optimum::SmallestBox;

struct OptimumArguments {
  std::vector<std::string> inputs = {"-"};
  ReadOptions graphs;
  optimum::Question question;
  std::string angle = "109.47";
  std::int64_t volume_below = optimum::SearchOptions().volume_below;
  std::optional<double> seconds;  // for each graph
  std::string output;
  std::string proofs;
  std::string solver;
  bool force = false;
};

std::string graph6_word(const Graph& graph) {
  std::string word;
  append_graph6(word, graph);
  word.pop_back();
  return word;
}

/// One graph of the input and what was found of it.
struct GraphAnswer {
  std::string where;  // "FILE:LINE"
  std::string graph;  // graph6
  SmallestBox found;
  double seconds = 0;
};

/// "512 lattice points, 8 x 8 x 8: no smaller box holds a drawing".
std::string answer_text(const SmallestBox& found) {
  if (!found.drawing) {
    return fmt::format("at least {} lattice points; no drawing was found", found.at_least);
  }
  const std::string box = optimum::to_string(found.box);
  if (found.is_closed()) {
    return fmt::format("{} lattice points, {}: no smaller box holds a drawing", found.at_most(),
                       box);
  }
  return fmt::format("{} to {} lattice points; a drawing takes {}", found.at_least, found.at_most(),
                     box);
}

nlohmann::ordered_json answer_json(const GraphAnswer& answer, const OptimumArguments& arguments) {
  nlohmann::ordered_json json = {{"graph6", answer.graph},
                                 {"angle", arguments.angle},
                                 {"bends", arguments.question.max_bends},
                                 {"plane", arguments.question.in_plane},
                                 {"at_least", answer.found.at_least},
                                 {"at_most", nullptr},
                                 {"box", nullptr},
                                 {"seconds", answer.seconds}};
  if (answer.found.drawing) {
    json["at_most"] = answer.found.at_most();
    json["box"] = answer.found.box;
  }
  json["formulas"] = nlohmann::ordered_json::array();
  for (const FormulaRecord& formula : answer.found.formulas) {
    json["formulas"].push_back({{"name", formula.name},
                                {"box", formula.box},
                                {"class", formula.point_class},
                                {"points", formula.points},
                                {"variables", formula.variables},
                                {"clauses", formula.clauses},
                                {"answer", to_string(formula.answer)},
                                {"cpu_s", formula.cpu_s},
                                {"formula_hash", formula.formula_hash},
                                {"proof_hash", formula.proof_hash}});
  }
  return json;
}

/// One line a formula, as docs/optimum.md describes it.
void append_index_lines(std::string& index, const GraphAnswer& answer,
                        const OptimumArguments& arguments) {
  for (const FormulaRecord& formula : answer.found.formulas) {
    const auto [x, y, z] = formula.box;
    fmt::format_to(std::back_inserter(index), "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                   formula.name, answer.graph, arguments.angle, arguments.question.max_bends,
                   arguments.question.in_plane ? 1 : 0, x, y, z, formula.point_class,
                   formula.points, formula.variables, formula.clauses, to_string(formula.answer),
                   formula.formula_hash, formula.proof_hash);
  }
}

/// Returns a drawing of `routed`, with which the search begins; nothing where it has no such one.
std::optional<Drawing> routed_drawing(const Graph& graph, const optimum::Question& question) {
  const bool is_body = question.diagonals == Diagonals::body;
  if (question.max_bends < 3 || question.in_plane) return std::nullopt;
  return draw(find_algorithm(is_body ? "routed" : "routed-120"), graph,
              {{"bends", std::min<std::int64_t>(question.max_bends, 5)}});
}

constexpr const char* kIndexHead =
    "name,graph6,angle,bends,plane,x,y,z,class,points,variables,clauses,answer,formula_hash,"
    "proof_hash\n";

/// @throws InputError if the folder of proofs holds something, unless `force`, or cannot be made.
void prepare_folder(const std::string& folder, bool force) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const bool is_empty = !error && std::filesystem::is_empty(folder, error);
  if (error) throw InputError(fmt::format("{}: {}", folder, error.message()));
  if (!is_empty && !force) {
    throw InputError(fmt::format("{}: not empty; --force writes into it even so", folder));
  }
}

optimum::Solver chosen_solver(const std::string& command) {
  std::istringstream text(command);
  std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
  if (!words.empty()) return optimum::command_solver(std::move(words));
  auto solver = optimum::cadical_solver();
  if (solver == nullptr) {
    throw InputError(
        "this program was built without CaDiCaL; give --solver COMMAND, such as --solver cadical");
  }
  return solver;
}

/// Answers the graphs of the input one after the other.
class OptimumRun {
 public:
  explicit OptimumRun(const OptimumArguments& arguments)
      : arguments_(arguments), solver_(chosen_solver(arguments.solver)) {
    if (!arguments.output.empty()) drawings_.emplace(arguments.output);
  }

  int run() {
    SeveralInputs<GraphReader> inputs(arguments_.inputs, [this](const std::string& path) {
      return std::make_unique<GraphReader>(path, arguments_.graphs);
    });
    const Interruptible interruptible;
    while (auto graph = inputs.next()) {
      ++number_;
      answer(*graph, inputs.reader().where());
      if (is_interrupted()) exit_code_ = kInterrupted;
      if (is_interrupted()) break;
    }
    if (!arguments_.proofs.empty()) write_file_atomically(arguments_.proofs + "/index.csv", index_);
    if (drawings_) drawings_->commit();
    if (is_json_output) print_json({{"graphs", std::move(answers_)}});
    return exit_code_;
  }

 private:
  void answer(const Graph& graph, const std::string& where) {
    try {
      refuse_unanswerable(graph, arguments_.question);
    } catch (const InputError& error) {
      print(stderr, "ar3d: {}: {}\n", printable(where), error.what());
      add_line({graph.num_vertices(), error.what()});
      exit_code_ = kUsage;
      return;
    }
    GraphAnswer answer{where, graph6_word(graph), {}, 0};
    const Stopwatch time;
    Stopwatch since_printed;
    std::string solving;  // the formula, if it is to be printed
    answer.found = find_smallest_box(
        graph, arguments_.question, solver_,
        {.volume_below = arguments_.volume_below,
         .first = routed_drawing(graph, arguments_.question),
         .proofs = arguments_.proofs,
         .name = fmt::format("{}", number_),
         .should_stop =
             [&] {
               if (!solving.empty() && since_printed.seconds() >= 1) {
                 log(stderr, "{}\n", std::exchange(solving, ""));
                 since_printed = Stopwatch();
               }
               return is_interrupted() ||
                      (arguments_.seconds && time.seconds() > *arguments_.seconds);
             },
         .on_formula =
             [&](const FormulaRecord& formula) {
               solving =
                   fmt::format("{}: box {}: {} points, {} clauses", answer.graph,
                               optimum::to_string(formula.box), formula.points, formula.clauses);
             }});
    answer.seconds = time.seconds();
    print_result(answer);
  }

  void print_result(const GraphAnswer& answer) {
    const SmallestBox& found = answer.found;
    double cpu_s = 0;
    for (const FormulaRecord& formula : found.formulas) cpu_s += formula.cpu_s;
    log(stdout, "{}: {} ({} formulas, {:.1f} s of CPU time)\n", answer.graph, answer_text(found),
        found.formulas.size(), cpu_s);
    (void)std::fflush(stdout);
    if (!found.too_large.empty()) print(stderr, "ar3d: {}: {}\n", answer.where, found.too_large);
    if (is_json_output) answers_.push_back(answer_json(answer, arguments_));
    append_index_lines(index_, answer, arguments_);
    if (!found.is_closed() && exit_code_ == kPass) exit_code_ = kIncomplete;
    if (!found.drawing) {
      add_line({num_vertices_of(answer), answer_text(found)});
    } else if (drawings_) {
      append_drawing_line(drawings_->pending(), *found.drawing);
      drawings_->flush_if_full();
    }
  }

  static std::uint64_t num_vertices_of(const GraphAnswer& answer) {
    return static_cast<std::uint64_t>(answer.graph[0]) - 63;  // below 63: one character of graph6
  }

  /// A graph without a drawing keeps its line.
  void add_line(const UndrawnGraph& undrawn) {
    if (drawings_) append_error_line(drawings_->pending(), undrawn);
  }

  const OptimumArguments& arguments_;
  optimum::Solver solver_;
  std::optional<OutputFile> drawings_;
  std::string index_ = kIndexHead;
  nlohmann::ordered_json answers_ = nlohmann::ordered_json::array();
  std::uint64_t number_ = 0;
  int exit_code_ = kPass;
};

int find_optima(OptimumArguments& arguments) {
  arguments.question.diagonals = arguments.angle == "120" ? Diagonals::face : Diagonals::body;
  refuse_unsafe_outputs({.inputs = arguments.inputs,
                         .outputs = {arguments.output},
                         .force = arguments.force,
                         .streams = false});
  if (!arguments.proofs.empty()) prepare_folder(arguments.proofs, arguments.force);
  return OptimumRun(arguments).run();
}

}  // namespace

void add_optimum(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "optimum", "Finds the smallest box of all drawings of a small graph, and proves it smallest");
  const auto arguments = std::make_shared<OptimumArguments>();
  verb->add_option("GRAPHS", arguments->inputs,
                   "connected graphs of at most 32 vertices in any input format; - is standard "
                   "input; several are read one after the other");
  add_graph_input_options(*verb, arguments->graphs);
  verb->add_option("--bends", arguments->question.max_bends, "most bends of an edge")
      ->check(whole_number(0, optimum::kMostBends));
  verb->add_option("--angle", arguments->angle,
                   "109.47: edges along diagonals of unit cubes; 120: of their faces; all angles "
                   "are exactly that")
      ->check(one_of({"109.47", "120"}));
  verb->add_flag("--plane", arguments->question.in_plane, "all vertices lie in one plane");
  verb->add_option("--volume-below", arguments->volume_below,
                   "only boxes with fewer lattice points are tried")
      ->check(whole_number(2, 1000000));
  verb->add_option("--seconds", arguments->seconds, "stop after that time for each graph")
      ->check(finite_number(true));
  verb->add_option("-o,--output", arguments->output, "file for the drawings, as JSON lines");
  verb->add_option("--proofs", arguments->proofs,
                   "folder for the formulas, their proofs and index.csv");
  verb->add_option("--solver", arguments->solver,
                   "a program that reads DIMACS and writes DRAT, instead of the one built in");
  add_json(*verb);
  add_force(*verb, arguments->force);
  verb->footer(
      "Exit code 5 if a smallest box is known only to lie between two volumes.\n"
      "Example: ar3d generate named -n 4 | ar3d optimum - --bends 3 --angle 109.47");
  verb->callback([arguments, &exit_code] { exit_code = find_optima(*arguments); });
}

}  // namespace ar3d
