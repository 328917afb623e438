// `ar3d hunt` and `ar3d shrink`: graphs whose drawings come close to a bound, or break it.

#include "hunt.h"

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/graphs/graph6.h"
#include "commands.h"
#include "study.h"
#include "view.h"

namespace ar3d {
namespace {

void add_subject_options(CLI::App& verb, HuntArguments& arguments) {
  verb.add_option(
      "--algorithm", arguments.algorithm,
      "an algorithm of `ar3d list algorithms`; that of ROW, as it was set, if left out");
  verb.add_option("--study", arguments.study,
                  "a specification whose [[algorithm]] the algorithm may be: a program of yours");
  verb.add_option("--measure", arguments.measure,
                  "whose share of the bound counts: x, y, z, side (the largest of them) or volume")
      ->check(one_of({std::begin(kShares), std::end(kShares)}));
  verb.add_option("--bound", arguments.against, "theorem, or instance: the proof's for this graph")
      ->check(one_of({"theorem", "instance"}));
  verb.add_option("--seeded-fault", arguments.seeded_fault,
                  "breaks the drawings on purpose, to see that it is found: wrong-bend or "
                  "passed-bound");
  add_json(verb);
  add_force(verb, arguments.force);
}

/// @throws InputError if the exhibit would go to a stream, over the input or over other
/// results.
void refuse_unsafe_exhibit(const HuntArguments& arguments) {
  const std::string& prefix = arguments.output;
  if (prefix == "-") {
    throw InputError("-o is the beginning of several files' names here, not a stream");
  }
  if (prefix.empty()) return;
  refuse_unsafe_outputs(
      {.inputs = arguments.inputs,
       .outputs = {prefix + ".s6", prefix + ".jsonl", prefix + ".svg", prefix + ".txt"},
       .force = arguments.force});
}

/// The graph of the row; its algorithm, with options, is the subject unless one is given.
/// @throws InputError as replay.
Graph graph_of_row(HuntArguments& arguments) {
  const Results results = read_results(arguments.inputs[0]);
  const RunRecord& row = find_row(results, arguments.row, arguments.inputs[0]);
  if (arguments.algorithm.empty()) {
    arguments.algorithm = row.algorithm;
    for (const Setting& option : parse_settings(row.options)) {
      const auto is_it = [&](const std::string& set) { return set.starts_with(option.name + "="); };
      if (std::ranges::any_of(arguments.settings, is_it)) continue;
      arguments.settings.push_back(settings_text({option}));
    }
  }
  return graph_of(plan_of_row(row, study_origin(results)));
}

/// Gives to the family what of --set names a parameter of it and no option of the algorithm.
void sort_settings(HuntArguments& arguments) {
  const Algorithm* const algorithm = known_algorithm(arguments.algorithm);
  const auto family = std::ranges::find(families(), arguments.family, &Family::name);
  if (family == families().end()) return;
  std::erase_if(arguments.settings, [&](const std::string& setting) {
    const auto is_it = [&](const SettingSpec& spec) {
      return setting.starts_with(spec.name + "=");
    };
    const bool is_parameter =
        std::ranges::any_of(family->parameters, is_it) &&
        (algorithm == nullptr || std::ranges::none_of(algorithm->options, is_it));
    if (is_parameter) arguments.parameters.push_back(setting);
    return is_parameter;
  });
}

/// @throws InputError naming what is unknown.
Subject subject_of(const HuntArguments& arguments) {
  if (arguments.algorithm.empty()) throw InputError("--algorithm is required");
  const StudySpec spec = arguments.study.empty() ? StudySpec() : load_study(arguments.study).spec;
  Subject subject;
  subject.choice = algorithm_choice(spec, arguments.algorithm, parse_settings(arguments.settings));
  if (!arguments.seeded_fault.empty()) subject.fault = &find_seeded_fault(arguments.seeded_fault);
  subject.measure = arguments.measure;
  subject.against_instance = arguments.against == "instance";
  return subject;
}

/// @param of_row  the graph of the row, if one is given.
std::vector<FamilyChoice> chosen_families(const HuntArguments& arguments,
                                          const Algorithm& algorithm,
                                          const std::optional<Graph>& of_row) {
  if (!arguments.inputs.empty()) {
    GraphsEntry taken;
    taken.reading = arguments.reading;
    std::vector<CorpusFile> files;
    for (const std::string& path : arguments.inputs) {
      files.push_back({path, arguments.inputs.size() == 1 ? "" : path, ""});
    }
    if (of_row) {
      std::string line;
      append_sparse6(line, *of_row);
      line.pop_back();
      files[0].held = CollectedFile{.name = {}, .file = {}, .group = {}, .hash = {}, .graphs = 1};
      files[0].lines = {{0, line}};
    }
    const auto graphs = std::make_shared<const Corpus>(
        files, taken, files.size() == 1 ? files[0].path : fmt::format("{} files", files.size()));
    log_notes(graphs->notes());
    return {{&graphs->family(), {}, graphs}};
  }
  if (arguments.family == "all") return fitting_families(algorithm, arguments.hunting.n);
  const Family& family = find_family(arguments.family);
  return {{&family, complete_parameters(family, parse_settings(arguments.parameters))}};
}

int hunt_and_show(HuntArguments arguments) {
  refuse_unsafe_exhibit(arguments);
  std::optional<Graph> of_row;
  if (!arguments.row.empty()) of_row = graph_of_row(arguments);
  sort_settings(arguments);
  const Subject subject = subject_of(arguments);
  const ExternalDrawer programs;
  arguments.hunting.families = chosen_families(arguments, *subject.choice.algorithm, of_row);
  const HuntResult result = hunt(subject, arguments.hunting, [](const HuntResult& so_far) {
    log(stderr, "{:>8} graphs: {:.6g} from {}\n", so_far.evaluations, so_far.best.ratio,
        so_far.start.family->name);
  });
  const std::string which =
      !arguments.row.empty() ? "row " + arguments.row
      : result.start.corpus && arguments.inputs.size() > 1
          ? fmt::format("({})", result.start.corpus->graph_name(result.start_index))
      : result.start.corpus ? fmt::format("graph {}", result.start_index)
                            : fmt::format("with seed {}", result.start_seed);
  nlohmann::ordered_json json = trial_json(result.best, arguments);
  json.update({{"evaluations", result.evaluations},
               {"starts", result.starts},
               {"from", result.start.family->name},
               {"start", which}});
  const bool is_drawn = result.best.drawing != nullptr;
  print_result(json, "{} graphs drawn and certified, {} starts; the {} one comes from {} {}\n{}",
               result.evaluations - (is_drawn ? 0 : 1), result.starts, is_drawn ? "best" : "next",
               result.start.family->name, which, trial_text(result.best, arguments));
  if (!arguments.output.empty()) {
    write_exhibit(result.best, arguments);
    log(stdout, "{}\n", shrink_line(result.best, arguments));
  }
  return exit_code_of(result.best);
}

/// @throws InputError if the graph has nothing that could be kept.
void refuse_unshrinkable(const Trial& whole, const HuntArguments& arguments) {
  const std::string& graph = arguments.inputs[0];
  if (whole.drawing && !arguments.failure.empty()) {
    throw InputError(
        fmt::format("{}: it is drawn, so there is no {} to keep", graph, arguments.failure));
  }
  if (arguments.ratio && !(whole.ratio >= *arguments.ratio)) {
    throw InputError(
        fmt::format("{}: its ratio is {}, less than {}", graph, whole.ratio, *arguments.ratio));
  }
  if (!arguments.ratio && whole.failure.empty()) {
    throw InputError(
        fmt::format("{}: its drawing is proved right; give --ratio to shrink it", graph));
  }
}

int shrink_and_show(HuntArguments arguments) {
  refuse_unsafe_exhibit(arguments);
  std::vector<std::string> notes;
  const Graph graph = arguments.row.empty()
                          ? read_graph(arguments.inputs[0], arguments.reading, &notes)
                          : graph_of_row(arguments);
  log_notes(notes);
  const Subject subject = subject_of(arguments);
  const ExternalDrawer programs;
  Trial least = try_graph(subject, graph);
  if (!least.drawing && kind_of_failure(least) != arguments.failure) {
    print_result(trial_json(least, arguments), "{}--failure {} shrinks it all the same\n",
                 trial_text(least, arguments), kind_of_failure(least));
    return exit_code_of(least);
  }
  refuse_unshrinkable(least, arguments);
  const std::string failure = least.failure;
  Graph small = graph;
  std::uint64_t left = arguments.most_drawings;
  const bool is_minimal = shrink(
      small,
      [&](const Graph& candidate) {
        Trial trial;
        try {
          trial = try_graph(subject, candidate);
        } catch (const InputError&) {  // its program refuses to draw it
          return false;
        }
        const bool keeps = !arguments.failure.empty() ? kind_of_failure(trial) == arguments.failure
                           : arguments.ratio ? trial.drawing && trial.ratio >= *arguments.ratio
                                             : trial.drawing && trial.failure == failure;
        if (keeps) least = std::move(trial);
        return keeps;
      },
      left);
  const std::uint64_t drawings = arguments.most_drawings - left;
  nlohmann::ordered_json json = trial_json(least, arguments);
  json.update({{"evaluations", drawings}, {"minimal", is_minimal}});
  print_result(json, "{} of {} vertices and {} of {} edges are left after {} drawings{}\n{}",
               small.num_vertices(), graph.num_vertices(), small.num_edges(), graph.num_edges(),
               drawings, is_minimal ? "; none can go" : "; the evaluations ran out",
               trial_text(least, arguments));
  write_exhibit(least, arguments);
  return exit_code_of(least);
}

}  // namespace

void add_hunt(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "hunt", "Searches for the graph that comes closest to a bound, or breaks one");
  const auto arguments = std::make_shared<HuntArguments>();
  add_subject_options(*verb, *arguments);
  HuntOptions& options = arguments->hunting;
  add_repeated(*verb, "--set,--parameter", arguments->settings,
               "an option of the algorithm or a parameter of the family, name=integer; may be "
               "repeated");
  CLI::Option* const family =
      verb->add_option("--family", arguments->family,
                       "where searches start: a family, or all that the algorithm draws");
  CLI::Option* const size = verb->add_option("-n", options.n, "requested number of vertices")
                                ->check(whole_number(1, 100000));
  CLI::Option* const graphs =
      add_repeated(*verb, "--graphs", arguments->inputs,
                   "search from the graphs of this file instead; may be repeated")
          ->excludes(family)
          ->excludes(size);
  CLI::Option* const results =
      verb->add_option_function<std::string>(
              "RESULTS", [arguments](const std::string& path) { arguments->inputs = {path}; },
              "search from the graph of a row instead")
          ->excludes(graphs)
          ->excludes(family)
          ->excludes(size);
  results->needs(verb->add_option("ROW", arguments->row, "its key, or its number from 0"));
  add_graph_input_options(*verb, arguments->reading);
  for (const char* name : {"--from", "--base", "--first-line", "--undirected", "--trust-sizes"}) {
    verb->get_option(name)->needs(graphs);
  }
  verb->add_option("--seed", options.seed, "seed of the search")->check(whole_number(0));
  verb->add_option("--evaluations", options.evaluations, "how many graphs to draw and certify")
      ->check(whole_number(1, 1000000000));
  verb->add_option("--seconds", options.seconds,
                   "stop after that time even so (the result then depends on the machine)")
      ->default_str("")
      ->check(finite_number(true));
  verb->add_option("-o,--output", arguments->output,
                   "prefix of the files that show the best one: .s6, .jsonl, .svg, .txt");
  verb->footer(
      "Exit code 4 if a drawing is violated, 5 if a graph is not drawn.\n"
      "Example: ar3d hunt --algorithm diamond -n 40 --evaluations 5000 --measure z -o tall\n"
      "         ar3d hunt smoke.h5 0");
  verb->callback([arguments, &exit_code] { exit_code = hunt_and_show(*arguments); });
}

void add_shrink(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "shrink", "Reduces a graph whose drawing is violated or extreme while it stays so");
  const auto arguments = std::make_shared<HuntArguments>();
  verb->add_option_function<std::string>(
          "GRAPH", [arguments](const std::string& path) { arguments->inputs = {path}; },
          "one graph in any input format, or with ROW a results file")
      ->required();
  verb->add_option("ROW", arguments->row, "the graph of this row: its key, or its number from 0");
  add_repeated(*verb, "--set", arguments->settings,
               "an option of the algorithm, name=integer; may be repeated");
  add_graph_input_options(*verb, arguments->reading);
  add_subject_options(*verb, *arguments);
  verb->add_option("--ratio", arguments->ratio,
                   "keep the share of the bound at least this; else the violation stays")
      ->check(finite_number(true));
  verb->add_option("--failure", arguments->failure,
                   "shrink a graph that is not drawn, while its program ends so: timeout or crash")
      ->check(one_of({"timeout", "crash"}))
      ->excludes(verb->get_option("--ratio"));
  verb->add_option("--evaluations", arguments->most_drawings, "at most so many drawings")
      ->check(whole_number(1, 1000000000));
  verb->add_option("-o,--output", arguments->output,
                   "prefix of the files that show what is left: .s6, .jsonl, .svg, .txt")
      ->required();
  verb->footer(
      "Exit code 4 if the drawing is violated, 5 if the graph is not drawn.\n"
      "Example: ar3d shrink tall.s6 --algorithm diamond --measure z --ratio 0.8 -o small");
  verb->callback([arguments, &exit_code] { exit_code = shrink_and_show(*arguments); });
}

}  // namespace ar3d
