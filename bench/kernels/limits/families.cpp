// ar3d_limits --families: drawing beside the search, to see what grows faster than it. A sweep over
// sizes in a list of its own, since the table of goals has one size a row.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "../inputs.h"
#include "../turns.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/instruments.h"
#include "limit.h"

namespace ar3d::kernels {
namespace {

/// Below this many vertices everything is in the caches, and times say little about growth.
constexpr double kGrowthFrom = 5'000;
/// Repeats end after so many seconds of the slowest algorithm, if need be after the first.
constexpr double kSecondsPerCell = 1;

/// A drawing time of one algorithm, family and n.
struct Timing {
  double n = 0;
  double ns = 0;     ///< per vertex
  double ratio = 0;  ///< to the search of the same graph
};

struct FamilyRow {
  const Algorithm* algorithm;
  std::string name;
  std::vector<Timing> timings;
  std::string refused = {};  ///< why the largest graphs are not drawn
};

/// Exponent of n in the ratio, least squares in logarithms; NaN from fewer than two sizes.
double growth(const std::vector<Timing>& timings) {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Timing& timing : timings) {
    if (timing.n < kGrowthFrom) continue;
    const double log_n = std::log(timing.n);
    const double log_ratio = std::log(timing.ratio);
    count += 1;
    x += log_n;
    y += log_ratio;
    xx += log_n * log_n;
    xy += log_n * log_ratio;
  }
  const double spread = count * xx - x * x;
  return count < 2 || spread <= 0 ? std::nan("") : (count * xy - x * y) / spread;
}

/// Seconds of a drawing; 0 for a graph that the algorithm refuses, which is its last one.
double time_drawing(const Graph& graph, FamilyRow& row) {
  if (!row.refused.empty()) return 0;
  try {
    const CpuStopwatch time;
    (void)draw(*row.algorithm, graph);
    return time.cpu_s();
  } catch (const InputError& error) {
    row.refused = error.what();
    return 0;
  }
}

/// All rows in turns with the search.
void time_rows(const Graph& graph, int repetitions, std::vector<FamilyRow>& rows) {
  std::vector<std::function<double()>> works = {
      timed(Clock::cpu, [&] { (void)search_breadth_first(graph); })};
  for (FamilyRow& row : rows) {
    works.emplace_back([&graph, &row] { return time_drawing(graph, row); });
  }
  Turns turns(std::move(works));
  turns.run(repetitions, kSecondsPerCell, {}, 1);
  const double n = graph.num_vertices();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].refused.empty()) continue;
    const double seconds = turns.median_of(i + 1);
    rows[i].timings.push_back({n, 1e9 * seconds / n, seconds / turns.median_of(0)});
  }
}

std::vector<FamilyRow> rows_of(const Family& family, const std::regex& only) {
  std::vector<FamilyRow> rows;
  for (const Algorithm* algorithm : proved_algorithms()) {
    if (family.max_degree > algorithm->guarantee.max_degree) continue;
    const std::string name = algorithm->name + "/" + family.name;
    if (std::regex_search(name, only)) rows.push_back({algorithm, name, {}});
  }
  return rows;
}

std::vector<std::uint64_t> sizes_up_to(std::uint64_t max_n) {
  std::vector<std::uint64_t> sizes;
  for (std::uint64_t n = 1'000; n <= max_n; n *= 10) sizes.push_back(n);
  return sizes;
}

std::string growth_text(double exponent) {
  return std::isnan(exponent) ? "–" : fmt::format("{:+.2f}", exponent);
}

void print_row(const FamilyRow& row, std::size_t num_sizes) {
  std::string line = fmt::format("| `{}` |", row.name);
  for (std::size_t i = 0; i < num_sizes; ++i) {
    line += i < row.timings.size()
                ? fmt::format(" {:.0f}; {:.3g} |", row.timings[i].ns, row.timings[i].ratio)
                : std::string(" – |");
  }
  fmt::print("{} {} | {} |\n", line, growth_text(growth(row.timings)), row.refused);
  std::fflush(stdout);
}

/// A family with few sizes gives the same graph for several: it is timed once.
void time_family(const Family& family, std::uint64_t max_n, int repetitions,
                 std::vector<FamilyRow>& rows) {
  std::uint64_t before = 0;
  for (const std::uint64_t n : sizes_up_to(max_n)) {
    const Graph graph = shuffled(family, n);
    if (graph.num_vertices() <= before) return;
    before = graph.num_vertices();
    time_rows(graph, repetitions, rows);
  }
}

void print_head(const std::vector<std::uint64_t>& sizes) {
  fmt::print(
      "CPU time of drawing in nanoseconds per vertex; ratio to the breadth-first search of the "
      "same graph; n as near below the power of ten as the family has it. Growth: the ratio "
      "grows like n to that power, from 10^4 on.\n\n| row |");
  for (const std::uint64_t n : sizes) fmt::print(" {:.0e} |", static_cast<double>(n));
  fmt::print(" growth | |\n|---|");
  for (std::size_t i = 0; i < sizes.size(); ++i) fmt::print("---|");
  fmt::print("---|---|\n");
}

}  // namespace

void print_families(std::uint64_t max_n, int repetitions, const std::string& expression) {
  const OneThread one_thread;
  const std::regex only(expression);
  const auto sizes = sizes_up_to(max_n);
  const Stopwatch time;
  std::map<std::string, std::pair<double, std::string>> largest;  // by algorithm: exponent and row
  print_head(sizes);
  for (const Family& family : families()) {
    std::vector<FamilyRow> rows = rows_of(family, only);
    if (rows.empty()) continue;
    fmt::print(stderr, "{:.0f} s: {}\n", time.wall_s(), family.name);
    time_family(family, max_n, repetitions, rows);
    for (const FamilyRow& row : rows) {
      print_row(row, sizes.size());
      const double exponent = growth(row.timings);
      const auto [entry, is_new] = largest.try_emplace(row.algorithm->name, exponent, row.name);
      if (!(entry->second.first >= exponent) && !std::isnan(exponent)) {
        entry->second = {exponent, row.name};
      }
    }
  }
  for (const auto& [algorithm, found] : largest) {
    fmt::print("\nLargest growth of `{}`: {}, `{}`.\n", algorithm, growth_text(found.first),
               found.second);
  }
}

}  // namespace ar3d::kernels
