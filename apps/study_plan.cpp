// Which study a verb is about, and `ar3d study plan`: what it would cost.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "ar3d/analysis/table.h"
#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/estimate.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/bench/spec/toml_table.h"
#include "ar3d/store/columns/curves.h"
#include "commands.h"
#include "options.h"
#include "study.h"

namespace ar3d {
namespace {

// From this size on, a calibration costs nothing beside the study.
constexpr std::uint64_t kLargeSize = 200000;

std::string about(double seconds) {
  if (seconds < 0.1) return fmt::format("{:.2g} ms", 1e3 * seconds);
  if (seconds < 120) return fmt::format("{:.2g} s", seconds);
  if (seconds < 7200) return fmt::format("{:.3g} min", seconds / 60);
  return fmt::format("{:.3g} h", seconds / 3600);
}

std::string cost_of(const CellEstimate& cell) {
  if (!cell.is_known) return "time and memory not known";
  return fmt::format("about {} and {} per row, {} in all", about(cell.row_s),
                     bytes_text(cell.row_bytes), about(cell.total_s));
}

std::string cost_of(const StudyEstimate& estimate, int workers) {
  if (estimate.unknown_rows == estimate.rows) return "its time and memory are not known";
  std::string text =
      fmt::format("estimated from runs up to n = {}: {} on {} threads, {} for the largest row",
                  estimate.calibration_n, about(estimate.wall_s), workers,
                  bytes_text(estimate.largest_row_bytes));
  if (estimate.unknown_rows > 0) {
    text += fmt::format("; of {} rows time and memory are not known", estimate.unknown_rows);
  }
  return text;
}

// The files left out, the first few by name.
std::string skipped_text(const std::vector<SkippedFile>& skipped) {
  constexpr std::size_t kShown = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, skipped.size()); ++i) {
    text += fmt::format("  left out: {}\n", printable(skipped[i].reason));
  }
  if (skipped.size() > kShown) text += fmt::format("  … and {} more\n", skipped.size() - kShown);
  return text;
}

// Which of its graphs are outside of the theorems of the algorithms that are to draw it.
void print_collection(const StudyCorpus& collection) {
  const Corpus& graphs = *collection.corpus;
  std::set<std::uint32_t> limits;
  for (const AlgorithmChoice& choice : collection.sweep->algorithms) {
    limits.insert(choice.algorithm->guarantee.max_degree);
  }
  std::string above;
  for (const std::uint32_t limit : limits) {
    const std::size_t count = graphs.count_above(limit);
    if (count > 0) above += fmt::format(", {} of degree above {}", count, limit);
  }
  print("{}: {} graphs{}, {} files left out\n{}", collection.record.name, graphs.size(), above,
        graphs.skipped().size(), skipped_text(graphs.skipped()));
}

// Cells of a collection are summed: one line for each algorithm.
void print_cells(const StudyEstimate& estimate, const std::set<std::string>& collections) {
  std::map<CurveKey, std::vector<CellEstimate>> curves;
  for (const CellEstimate& cell : estimate.cells) {
    if (!collections.contains(cell.curve.family)) {
      print("{}: {} instances, {} rows, {}\n",
            cell_label(cell.curve, static_cast<std::int64_t>(cell.n)), cell.instances, cell.rows,
            cost_of(cell));
      continue;
    }
    curves[cell.curve].push_back(cell);
  }
  for (const auto& [key, cells] : curves) {
    const auto [least, largest] = std::ranges::minmax(cells, {}, &CellEstimate::n);
    std::size_t rows = 0;
    double total_s = 0;
    for (const CellEstimate& cell : cells) {
      rows += cell.rows;
      total_s += cell.total_s;
    }
    const bool is_known = std::ranges::all_of(cells, &CellEstimate::is_known);
    print("{}..{}: {} rows, {}\n", cell_label(key, static_cast<std::int64_t>(least.n)), largest.n,
          rows, is_known ? about(total_s) + " in all" : "time and memory not known");
  }
}

nlohmann::ordered_json plan_json(const StudySpec& spec, const StudyPlan& plan,
                                 const StudyEstimate& estimate) {
  const auto if_known = [](bool is_known, double value) {
    return is_known ? nlohmann::ordered_json(value) : nullptr;
  };
  nlohmann::ordered_json cells = nlohmann::ordered_json::array();
  for (const CellEstimate& cell : estimate.cells) {
    nlohmann::ordered_json json = key_json(cell.curve);
    json.update({{"cell", cell_label(cell.curve, static_cast<std::int64_t>(cell.n))},
                 {"n", cell.n},
                 {"instances", cell.instances},
                 {"rows", cell.rows},
                 {"row_s", if_known(cell.is_known, cell.row_s)},
                 {"row_bytes", if_known(cell.is_known, cell.row_bytes)},
                 {"total_s", if_known(cell.is_known, cell.total_s)}});
    cells.push_back(std::move(json));
  }
  nlohmann::ordered_json left_out = nlohmann::ordered_json::object();
  for (const auto& [algorithm, families] : plan.left_out) left_out[algorithm->name] = families;
  return {{"study", spec.name},
          {"instances", plan.instances.size()},
          {"rows", estimate.rows},
          {"optional_rows", estimate.optional_rows},
          {"unknown_rows", estimate.unknown_rows},
          {"threads", estimate.threads},
          {"wall_s", estimate.wall_s},
          {"counting_s", spec.count ? estimate.counting_s : 0},
          {"largest_row_bytes", estimate.largest_row_bytes},
          {"left_out", left_out},
          {"cells", cells}};
}

// A line for each algorithm that does not draw all families of its sweeps.
std::string left_out_families(const StudyPlan& plan) {
  std::string text;
  for (const auto& [algorithm, families] : plan.left_out) {
    text += fmt::format("left out: {} draws degree {} at most, not {}\n", algorithm->name,
                        algorithm->guarantee.max_degree, fmt::join(families, ", "));
  }
  return text;
}

// What the machine cannot give: batches of more threads than there are cores to run on.
std::string crowded_batches(const StudyPlan& plan) {
  const std::size_t allowed = std::max<std::size_t>(1, allowed_cores().size());
  const auto cores = static_cast<std::int64_t>(std::min<std::size_t>(allowed, quota_threads()));
  std::int64_t most = 0;
  for (const PlannedBlock& block : plan.instances.blocks()) {
    for (const PlannedRun& run : block.first.runs) {
      if (is_batched(run.phase) && !is_over_ranks(run.phase)) most = std::max(most, run.workers);
    }
  }
  if (most <= cores) return "";
  return fmt::format("batches of {} threads share {} core{}: their efficiency says nothing\n", most,
                     cores, cores == 1 ? "" : "s");
}

void print_estimate(const Study& study, const StudyPlan& plan, const StudyEstimate& estimate,
                    int workers) {
  std::set<std::string> collections;
  for (const StudyCorpus& corpus : corpora_of(study)) {
    if (!corpus.entry->is_collection) continue;
    if (collections.insert(corpus.record.name).second) print_collection(corpus);
  }
  print_cells(estimate, collections);
  print("{}{}", left_out_families(plan), crowded_batches(plan));
  print("{} cells, {} instances, {} rows", estimate.cells.size(), plan.instances.size(),
        estimate.rows);
  if (estimate.optional_rows > 0) print(" and at most {} more", estimate.optional_rows);
  print("\n{}\n", cost_of(estimate, workers));
  if (study.spec.count) print("counting takes about {} more\n", about(estimate.counting_s));
  if (plan.budget.study_s && estimate.wall_s > *plan.budget.study_s) {
    print("the budget of {} will probably end it earlier\n", about(*plan.budget.study_s));
  }
}

std::string toml_quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') quoted += '\\';
    if (byte < 32 || byte == 127) {
      quoted += fmt::format("\\u{:04X}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

/// Returns what a folder's collection is called; empty if it is no folder.
std::string folder_name(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_directory(path, error)) return "";
  return own_graphs_name(std::filesystem::canonical(path, error).string());
}

/// The specification that graphs of files are short for.
std::string graphs_study_text(const StudyChoice& study) {
  const ReadOptions& reading = study.reading;
  std::string text =
      fmt::format("study = \"graphs\"\nseed = {}\n{}\n[[sweep]]\n{}graphs = [\n", study.seed,
                  study.count ? "count = true\n" : "",
                  study.timed > 0 ? fmt::format("timed_repetitions = {}\n", study.timed) : "");
  for (const std::string& file : study.files) {
    const std::string name = study.name.empty() ? folder_name(file) : study.name;
    text += name.empty() ? "  { file = " : "  { files = ";
    text += toml_quoted(file);
    if (!name.empty()) text += ", name = " + toml_quoted(name);
    if (!study.groups.empty()) text += ", groups = " + toml_quoted(study.groups);
    if (study.skip) text += ", skip = true";
    if (study.sample > 0) text += fmt::format(", sample = {}", study.sample);
    if (!reading.format.empty()) text += ", format = " + toml_quoted(reading.format);
    if (reading.base) text += fmt::format(", base = {}", *reading.base);
    if (reading.first_line == FirstLine::edge) text += ", first_line = \"edge\"";
    if (reading.first_line == FirstLine::header) text += ", first_line = \"header\"";
    if (study.simple) text += ", simple = true";
    if (reading.undirected) text += ", undirected = true";
    if (study.largest_component) text += ", largest_component = true";
    if (study.shuffle) text += ", shuffle = 1";
    text += " },\n";
  }
  text += "]\nalgorithms = [";
  for (const std::string& algorithm : study.algorithms) text += toml_quoted(algorithm) + ", ";
  return text + (study.algorithms.empty() ? "\"all\"]\n" : "]\n");
}

}  // namespace

void add_study_choice(CLI::App& verb, StudyChoice& choice) {
  verb.add_option("STUDY", choice.study, "a TOML file or a study of `ar3d list studies`");
  CLI::Option* const files =
      verb.add_option("--graphs", choice.files,
                      "instead of STUDY: all graphs of these files, of those that a pattern in "
                      "quotes matches, or of a folder, which is one collection");
  verb.add_option("--name", choice.name,
                  "with --graphs: all files that match, or that the folder holds, are one "
                  "collection of this name, its groups the sub-folders; a folder's own if left out")
      ->needs(files);
  verb.add_option("--groups", choice.groups,
                  "of a collection: a table, a line FILE,GROUP each, that says the groups instead")
      ->needs(files);
  verb.add_option("--timed", choice.timed, "number of timed rounds of all drawings, in every sweep")
      ->default_str("")
      ->check(whole_number(1, 1000000));
  verb.add_flag("--count", choice.count, "with --graphs: instructions are counted by callgrind")
      ->needs(files);
  verb.add_flag("--skip", choice.skip,
                "with --graphs: files that cannot be read are counted, listed and left out")
      ->needs(files);
  add_repeated(verb, "--algorithm", choice.algorithms,
               "with --graphs: one to draw them with; may be repeated, all if left out")
      ->needs(files);
  verb.add_option("--from", choice.reading.format,
                  "with --graphs: their format; detected by content if left out")
      ->needs(files);
  add_edge_list_options(verb, choice.reading);
  for (const char* name : {"--base", "--first-line", "--undirected"})
    verb.get_option(name)->needs(files);
  verb.add_option("--sample", choice.sample, "with --graphs: so many graphs of each file")
      ->default_str("")
      ->check(whole_number(1, 10000000))
      ->needs(files);
  verb.add_option("--seed", choice.seed, "with --graphs: of sample and labels")
      ->check(whole_number(0, std::numeric_limits<std::int64_t>::max()))
      ->needs(files);
  verb.add_flag("--simple", choice.simple,
                "with --graphs: loops and parallel edges are dropped; else they are refused")
      ->needs(files);
  verb.add_flag("--largest-component", choice.largest_component,
                "with --graphs: of each graph only its largest component")
      ->needs(files);
  verb.add_flag("--shuffle", choice.shuffle, "with --graphs: the labels permuted at random")
      ->needs(files);
}

Study chosen_study(const StudyChoice& choice) {
  if (choice.study.empty() == choice.files.empty()) {
    throw InputError("either STUDY or --graphs says what to run; --help shows both");
  }
  if (!choice.study.empty()) {
    const Study study = load_study(choice.study);
    return choice.timed == 0 ? study : with_timed_rounds(study, choice.timed);
  }
  if (!choice.name.empty() && choice.files.size() > 1) {
    throw InputError(
        "--name is of one collection, but there are several --graphs: a pattern in quotes, or a "
        "folder, is one");
  }
  return parse_study(graphs_study_text(choice), kOptionsFile);
}

std::string refuse_impossible_study(const Study& study, const SessionPolicy& policy) {
  const StudyPlan plan = plan_study(study);
  require_possible(plan, policy);
  const std::vector<PlannedBlock>& blocks = plan.instances.blocks();
  const bool is_large = std::any_of(blocks.begin(), blocks.end(), [](const PlannedBlock& block) {
    return block.first.n >= kLargeSize;
  });
  if (is_large || plan.budget.limits_rows()) {
    refuse_impossible(plan, estimate(plan, policy.workers), available_memory());
  }
  return left_out_families(plan) + crowded_batches(plan);
}

void add_study_plan(CLI::App& study, int&) {
  CLI::App* verb = study.add_subcommand(
      "plan", "Lists the cells of a study with estimated time and memory; refuses impossible ones");
  const auto chosen = std::make_shared<StudyChoice>();
  const auto threads = std::make_shared<int>(0);
  add_study_choice(*verb, *chosen);
  verb->add_option("--threads", *threads,
                   "rows made at the same time; as many as cores if left out")
      ->default_str("")
      ->check(whole_number(1, 1024));
  add_json(*verb);
  verb->footer(
      "Estimates are extrapolated from short runs at small sizes on this machine; expect them to "
      "be "
      "right within a factor of three.\nExit code 2 if a cell is impossible.\nExample: ar3d study "
      "plan quick");
  verb->callback([chosen, threads] {
    const Study asked = chosen_study(*chosen);
    require_programs(asked.spec);
    const StudyPlan plan = plan_study(asked);
    const int workers = workers_for(*threads);
    log(stderr, "ar3d: {} graphs planned; small ones are drawn to estimate time and memory\n",
        plan.instances.size());
    const StudyEstimate made = estimate(plan, workers);
    if (is_json_output) print_json(plan_json(asked.spec, plan, made));
    if (!is_json_output) print_estimate(asked, plan, made, workers);
    refuse_impossible(plan, made, available_memory());
  });
}

}  // namespace ar3d
