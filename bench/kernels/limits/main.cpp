// The program ar3d_limits: every stage beside its yardstick, as a table in Markdown. Goals are
// stated for certain sizes; where a run is bounded to smaller ones they are not judged.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <regex>
#include <string>
#include <vector>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/stopwatch.h"
#include "limit.h"
#include "machine.h"

namespace ar3d::limits {
namespace {

struct Options {
  std::uint64_t max_n = 10'000'000;
  int repetitions = 9;
  std::string only = ".";
  std::uint64_t memory_mib = 256;
};

std::vector<Group> all_groups() {
  std::vector<Group> all;
  for (const auto& groups : {drawing_groups(), certifying_groups(), crossing_groups(),
                             generating_groups(), study_groups(), layout_groups()}) {
    all.insert(all.end(), groups.begin(), groups.end());
  }
  return all;
}

std::string goal_text(const Goal& goal) {
  return fmt::format("{} {:g}{}", goal.kind == Goal::Kind::at_most ? "≤" : "≥", goal.value,
                     goal.unit);
}

const char* met(const Limit& limit, bool at_goals_size) {
  if (!limit.measured) return "–";
  if (!at_goals_size) return "not judged at this n";
  const bool reached = limit.goal.kind == Goal::Kind::at_most ? *limit.measured <= limit.goal.value
                                                              : *limit.measured >= limit.goal.value;
  return reached ? "yes" : "no";
}

/// Three significant digits.
std::string value_text(double value) {
  if (value >= 100) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}f}", value, value >= 10 ? 1 : value >= 0.1 ? 2 : 3);
}

void measure(Group& group, const Scale& scale) {
  try {
    group.measure(scale, group.limits);
  } catch (const std::exception& error) {
    for (Limit& limit : group.limits) {
      limit.measured.reset();
      limit.remark = fmt::format("not measured: {}", error.what());
    }
  }
}

void print_group(const Group& group, std::uint64_t n) {
  for (const Limit& limit : group.limits) {
    fmt::print("| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", group.name, limit.stage,
               limit.yardstick, n,
               limit.measured ? value_text(*limit.measured) + limit.goal.unit : "–",
               goal_text(limit.goal), met(limit, n == group.n), limit.remark);
  }
  std::fflush(stdout);
}

void print_memory(const Options& options) {
  const MemorySpeed speed =
      measure_memory(std::size_t{options.memory_mib} << 20, options.repetitions);
  fmt::print(
      "Memory of one thread, arrays of {} MiB: {:.1f} GB/s read, {:.1f} GB/s read and written by a "
      "copy, {:.0f} ns a dependent read at a random place, {:.1f} ns a read with 32 such chains at "
      "the same time.\n\n",
      options.memory_mib, speed.read_gb_per_s, speed.copy_gb_per_s, speed.latency_ns,
      speed.overlapped_ns);
}

void run(const Options& options) {
  const Stopwatch time;
  const std::regex only(options.only);
  fmt::print("Commit {}{}, medians of {} repetitions in turns, load average before {}.\n\n",
             source_hash(), source_is_dirty() ? " and uncommitted changes" : "",
             options.repetitions, load_average());
  print_memory(options);
  fmt::print(
      "| row | stage | yardstick | n | measured | goal | met | "
      "|\n|---|---|---|---|---|---|---|---|\n");
  for (Group& group : all_groups()) {
    if (!std::regex_search(group.name, only)) continue;
    const std::uint64_t n = std::min(group.n, options.max_n);
    fmt::print(stderr, "{:.0f} s: {}\n", time.wall_s(), group.name);
    measure(group, {n, options.repetitions});
    print_group(group, n);
  }
  fmt::print("\n{:.0f} s in all, load average after {}.\n", time.wall_s(), load_average());
}

}  // namespace
}  // namespace ar3d::limits

int main(int argc, char** argv) {
  ar3d::limits::Options options;
  CLI::App app(
      "Every stage beside its yardstick, goals met and missed, as a table in Markdown.\n"
      "Example: ar3d_limits --only '^draw/diamond' --max-n 1000000");
  app.add_option("--max-n", options.max_n, "no graph has more vertices")
      ->check(CLI::Range(std::uint64_t{10}, std::uint64_t{100'000'000}))
      ->capture_default_str();
  app.add_option("--repetitions", options.repetitions, "of everything that is timed")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--only", options.only, "rows whose name this regular expression finds")
      ->capture_default_str();
  app.add_option("--memory", options.memory_mib, "MiB of the arrays that tell the memory's speed")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 20))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  try {
    ar3d::limits::run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "ar3d_limits: {}\n", error.what());
    return 2;
  }
  return 0;
}
