// Counts instructions of drawings by callgrind, which gives the same number on every run. The
// program starts itself under valgrind with a list of drawings; before each one the heap is put
// into the same state. A program of the study runs under valgrind itself, which is asked after each
// answer to write down what it has counted.
#include <malloc.h>

#include <boost/scope_exit.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <tuple>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/print.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/formats/catalog.h"

// A name without mangling that no optimiser may remove: callgrind counts from its entry to its end,
// and writes down there what it has counted.
extern "C" __attribute__((noinline)) void ar3d_counted_drawing(
    const ar3d::Graph* graph, const ar3d::AlgorithmChoice* choice) {
  ar3d::draw(*choice->algorithm, *graph, choice->options);
  asm volatile("" : : : "memory");
}

namespace ar3d {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSimulatedBytes = 8388608, kLine = 64;  // of the last level of the cache
// As begin_alike(): the allocator keeps no pieces that were used before.
constexpr const char* kNoCache = "GLIBC_TUNABLES=glibc.malloc.tcache_count=0";
constexpr std::string_view kFileFamily = "file:";

// What callgrind counts of a drawing, generation and certification left out: instructions, and as
// estimated cycles instructions + 10 for every miss of the first level of a simulated cache + 100
// for every miss of its last: the estimate of kcachegrind. The cache is the same on every machine:
// 32 KB of instructions and 32 KB of data, 8 MB behind both. -1: not counted.
using DrawingCounts = std::pair<std::int64_t, std::int64_t>;

// What a drawing costs must not depend on those before it: all that they free becomes one piece of
// the heap again, which never grows or shrinks.
void begin_alike() {
  constexpr int kHeapBytes = 1 << 28;
  mallopt(M_MXFAST, 0);
  mallopt(M_MMAP_THRESHOLD, kHeapBytes);
  mallopt(M_TRIM_THRESHOLD, 2 * kHeapBytes);
  mallopt(M_TOP_PAD, kHeapBytes);
}

std::vector<std::string> command_line(const std::string& orders, const std::string& output) {
  return {"env",
          "LD_BIND_NOW=1",  // so that no drawing is the first to call a function
          kNoCache,
          "valgrind",
          "--tool=callgrind",
          "--cache-sim=yes",
          fmt::format("--I1=32768,8,{}", kLine),
          fmt::format("--D1=32768,8,{}", kLine),
          fmt::format("--LL={},16,{}", kSimulatedBytes, kLine),
          "--toggle-collect=ar3d_counted_drawing",
          "--dump-after=ar3d_counted_drawing",
          "--combine-dumps=yes",
          "--callgrind-out-file=" + output,
          "--quiet",
          fs::read_symlink("/proc/self/exe").string(),
          "study",
          kDrawCountedVerb,
          orders};
}

// The costs of a part: its line "summary: …" in the order of "events: Ir Dr Dw I1mr …".
DrawingCounts counts_of(const std::string& events, const std::string& summary) {
  std::istringstream names(events), numbers(summary);
  std::string name;
  std::int64_t number = 0;
  std::int64_t instructions = 0, cycles = 0;
  while (names >> name && numbers >> number) {
    if (name == "Ir") instructions = number;
    const bool is_first = name.starts_with("I1") || name.starts_with("D1");
    const int weight = name == "Ir"                                       ? 1
                       : is_first                                         ? 10
                       : name.starts_with("IL") || name.starts_with("DL") ? 100
                                                                          : 0;
    cycles += weight * number;
  }
  return {instructions, cycles};
}

// The parts of a callgrind output file that have counted something, in order.
std::vector<DrawingCounts> parts_of(const std::string& path) {
  constexpr std::string_view kEvents = "events: ", kSummary = "summary: ";
  std::vector<DrawingCounts> parts;
  std::ifstream in(path);
  std::string events;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(kEvents)) events = line.substr(kEvents.size());
    if (!line.starts_with(kSummary)) continue;
    const DrawingCounts counts = counts_of(events, line.substr(kSummary.size()));
    if (counts.first > 0) parts.push_back(counts);
  }
  return parts;
}

// Writes down what is to be drawn, and graphs of files beside it.
void write_orders(const std::vector<const RunRecord*>& rows, const StudyOrigin& origin,
                  const std::string& folder, const std::string& path) {
  std::ofstream orders(path);
  std::string last_hash, last_file;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const RunRecord& row = *rows[i];
    const PlannedInstance instance = plan_of_row(row, origin);
    std::string family = row.family;
    if (instance.choice.corpus) {
      if (row.graph_hash != last_hash) {
        last_hash = row.graph_hash;
        last_file = fmt::format("{}/{}.s6", folder, i);
        write_graphs({graph_of(instance)}, find_graph_format("sparse6"), last_file);
      }
      family = std::string(kFileFamily) + last_file;
    }
    orders << fmt::format("{}\t{}\t{}\t{}\t{}\t{}\n", family, row.parameters, row.requested_n,
                          row.seed, row.algorithm, row.options);
  }
  orders.close();
  if (!orders) throw InputError(fmt::format("cannot write {}", path));
}

RunRecord order_of(const std::string& line) {
  std::istringstream words(line);
  RunRecord row;
  std::string n, seed;
  for (std::string* word :
       {&row.family, &row.parameters, &n, &seed, &row.algorithm, &row.options}) {
    std::getline(words, *word, '\t');
  }
  row.requested_n = std::strtoll(n.c_str(), nullptr, 10);
  row.seed = std::strtoull(seed.c_str(), nullptr, 10);
  return row;
}

// Of drawings that one process makes one after the other: rows of one graph that stand together
// have it generated once. Empty if it was interrupted.
std::vector<DrawingCounts> count_drawings(const std::vector<const RunRecord*>& rows,
                                          const StudyOrigin& origin) {
  const std::string folder = new_temporary_folder("ar3d-callgrind");
  BOOST_SCOPE_EXIT_ALL(&) { remove_folder(folder); };
  const std::string orders = folder + "/orders", output = folder + "/counts";
  write_orders(rows, origin, folder, orders);
  double limit_s = 600;  // a generous one: only a valgrind that hangs needs that long
  for (const RunRecord* row : rows) limit_s += 1 + 0.1 * static_cast<double>(row->n);
  const int exit_code =
      run_child(command_line(orders, output),
                {.output = "/dev/null", .ends_when_interrupted = true, .limit_s = limit_s});
  if (is_interrupted()) return {};
  std::vector<DrawingCounts> counts = parts_of(output);
  if (exit_code == 0 && counts.size() == rows.size()) return counts;
  throw InputError(fmt::format("callgrind ended with code {} behind {} of {} drawings", exit_code,
                               counts.size(), rows.size()));
}

constexpr std::size_t kCountedAnswers = 3;   // to each graph, the smallest of which counts
constexpr double kMostApart = 0.005;         // of a program that always does the same
constexpr double kSlowedBy = 100;            // valgrind, at most
constexpr std::size_t kMostBytes = 1 << 30;  // of an answer

// Drawings of rows of one program with its options, made by one process; a first answer to each
// graph is not counted. Empty if it was interrupted.
// @throws InputError if the program fails or does not always do the same.
std::vector<DrawingCounts> count_answers(const ExternalAlgorithm& program,
                                         const std::vector<const RunRecord*>& rows,
                                         const StudyOrigin& origin) {
  if (program.one_graph_per_process) throw InputError("each of its processes draws one graph");
  const std::string folder = new_temporary_folder("ar3d-callgrind");
  BOOST_SCOPE_EXIT_ALL(&) { remove_folder(folder); };
  fs::create_directory(folder + "/counts");
  std::vector<std::string> words = {"env",
                                    "PYTHONHASHSEED=0",  // which is another one in every run
                                    "valgrind",
                                    "--tool=callgrind",
                                    "--trace-children=yes",  // as env becomes another program
                                    "--combine-dumps=yes",
                                    "--callgrind-out-file=" + folder + "/counts/%p",
                                    "--vgdb-prefix=" + folder + "/vgdb",
                                    "--quiet"};
  std::ranges::copy(command_with(program, parse_settings(rows.front()->options)),
                    std::back_inserter(words));
  ExternalProcess process(words);
  for (const RunRecord* row : rows) {
    const std::string request = request_of(program, graph_of(plan_of_row(*row, origin)));
    for (std::size_t i = 0; i <= kCountedAnswers; ++i) {
      process.ask(request, kSlowedBy * program.limit_s(static_cast<std::uint64_t>(row->n)),
                  kMostBytes);
      const int code =
          run_child({"vgdb", "--vgdb-prefix=" + folder + "/vgdb", "dump"},
                    {.output = "/dev/null", .ends_when_interrupted = true, .limit_s = 60});
      if (is_interrupted()) return {};
      if (code != 0) throw InputError(fmt::format("vgdb ended with code {}", code));
    }
  }
  const std::vector<fs::path> files(fs::directory_iterator(folder + "/counts"), {});
  if (files.size() != 1) throw InputError("it starts other programs");
  const std::vector<DrawingCounts> parts = parts_of(files.front());
  std::vector<DrawingCounts> counts;
  for (auto part = parts.begin(); parts.end() - part > std::ptrdiff_t{kCountedAnswers};) {
    std::array<std::int64_t, kCountedAnswers> answers;
    for (std::int64_t& answer : answers) answer = (++part)->first;
    ++part;
    std::ranges::sort(answers);
    const auto least = static_cast<double>(answers[0]);
    if (static_cast<double>(answers[1]) > (1 + kMostApart) * least) {
      throw InputError(
          fmt::format("its instructions for one graph differ: {} and {}", answers[0], answers[1]));
    }
    counts.emplace_back(answers[0], -1);
  }
  if (counts.size() >= rows.size()) return counts;
  throw InputError(fmt::format("callgrind counted {} of {} drawings", counts.size(), rows.size()));
}

}  // namespace

std::string counting_problem() {
  if (std::string_view(build_kind()) == "sanitised") {
    return "a sanitised build cannot run under callgrind";
  }
  static const int code =
      run_child({"valgrind", "--version"},
                {.output = "/dev/null", .ends_when_interrupted = true, .limit_s = 60});
  return code == 0 ? "" : "valgrind cannot be run (sudo apt-get install valgrind)";
}

void draw_for_counting(const std::string& file) {
  begin_alike();
  std::vector<char> sweep(2 * kSimulatedBytes);
  std::ifstream in(file);
  std::optional<Graph> graph;
  std::string graph_words;
  for (std::string line; std::getline(in, line);) {
    const RunRecord row = order_of(line);
    const Algorithm& algorithm = find_algorithm(row.algorithm);
    const AlgorithmChoice choice{&algorithm,
                                 complete_options(algorithm, parse_settings(row.options))};
    std::string words = line.substr(0, line.find("\t" + row.algorithm + "\t"));
    if (words != graph_words) {
      graph.reset();
      graph = row.family.starts_with(kFileFamily)
                  ? read_graph(row.family.substr(kFileFamily.size()))
                  : graph_of(plan_of_row(row));
      graph_words = std::move(words);
    }
    for (std::size_t i = 0; i < sweep.size(); i += kLine) sweep[i] = 1;  // nothing else is cached
    ar3d_counted_drawing(&*graph, &choice);
  }
}

std::size_t fill_counts(Results& results, std::int64_t max_n) {
  const StudyOrigin origin = study_origin(results);
  using Key = std::tuple<std::string, std::string, std::string>;
  const auto key_of = [](const RunRecord& run) -> Key {
    return {run.graph_hash, run.algorithm, run.options};
  };
  std::map<Key, DrawingCounts> counts;
  // By program and options; null: all of the catalogue.
  std::map<std::pair<const ExternalAlgorithm*, std::string>, std::vector<const RunRecord*>> groups;
  for (const RunRecord& run : results.runs) {
    if (run.n > max_n || !is_drawn(run) || !counts.try_emplace(key_of(run), -1, -1).second)
      continue;
    const auto program = origin.study ? find_program(origin.study->spec, run.algorithm) : nullptr;
    groups[{program.get(), program == nullptr ? "" : run.options}].push_back(&run);
  }
  if (groups.empty()) return 0;
  if (const std::string problem = counting_problem(); !problem.empty()) throw InputError(problem);
  std::size_t drawings = 0;
  for (const auto& [group, rows] : groups) {
    const ExternalAlgorithm* program = group.first;
    try {
      const std::vector<DrawingCounts> counted =
          program == nullptr ? count_drawings(rows, origin) : count_answers(*program, rows, origin);
      if (counted.empty()) return 0;
      for (std::size_t i = 0; i < rows.size(); ++i) counts[key_of(*rows[i])] = counted[i];
      drawings += rows.size();
    } catch (const std::exception& error) {
      if (program == nullptr) throw;
      print(stderr, "ar3d: {} is not counted: {}\n", program->row.name, printable(error.what()));
    }
  }
  for (RunRecord& run : results.runs) {
    const auto at = counts.find(key_of(run));
    if (at == counts.end() || at->second.first < 0) continue;
    std::tie(run.counted_instructions, run.estimated_cycles) = at->second;
  }
  return drawings;
}

}  // namespace ar3d
