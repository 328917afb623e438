// The program ar3d_limits: every stage beside its yardstick, as a table in Markdown. Goals are
// stated for certain sizes; where a run is bounded to smaller ones they are not judged. With
// --families, drawing beside its yardstick for every family and size instead.
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
#include "ar3d/bench/measure/instruments.h"
#include "limit.h"

namespace ar3d::kernels {
namespace {

struct LimitOptions {
  std::uint64_t max_n = 10'000'000;
  int repetitions = 9;
  std::string only = ".";
  std::uint64_t memory_mib = 256;
  bool quick = false;
  bool families = false;
};

/// Memory comes first: the more a process has freed, the longer arrays malloc keeps in its heap.
std::vector<LimitGroup> all_groups() {
  std::vector<LimitGroup> all;
  for (const auto& groups :
       {memory_groups(), drawing_groups(), certifying_groups(), crossing_groups(), reading_groups(),
        generating_groups(), study_groups(), layout_groups()}) {
    all.insert(all.end(), groups.begin(), groups.end());
  }
  return all;
}

std::string goal_text(const Goal& goal) {
  return fmt::format("{} {:g}{}", goal.is_least ? "≥" : "≤", goal.value, goal.unit);
}

bool is_reached(const Limit& limit) {
  return limit.goal.is_least ? *limit.measured >= limit.goal.value
                             : *limit.measured <= limit.goal.value;
}

const char* met(const Limit& limit, bool at_goals_size) {
  if (!limit.measured) return "–";
  if (!at_goals_size) return "not judged at this n";
  return is_reached(limit) ? "yes" : "no";
}

/// The last cell: what was measured, and of a goal that is missed the reason.
std::string remark(const Limit& limit, bool at_goals_size) {
  if (!limit.measured || !at_goals_size || is_reached(limit)) return limit.remark;
  const char* known = limit.why_missed.empty() ? "reason not known" : limit.why_missed.c_str();
  return fmt::format("{}{}missed: {}", limit.remark, limit.remark.empty() ? "" : "; ", known);
}

/// Three significant digits.
std::string value_text(double value) {
  if (value >= 100) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}f}", value, value >= 10 ? 1 : value >= 0.1 ? 2 : 3);
}

/// What a group throws is told in its lines; false if that was a fault.
bool measure(LimitGroup& group, const RunSize& scale) {
  const auto tell = [&](const char* what, const char* message) {
    for (Limit& limit : group.limits) {
      limit.measured.reset();
      limit.remark = fmt::format("{}: {}", what, message);
    }
  };
  try {
    group.measure(scale, group.limits);
  } catch (const NotMeasured& missing) {
    tell("not measured", missing.what());
  } catch (const std::exception& error) {
    tell("failed", error.what());
    return false;
  }
  return true;
}

void print_group(const LimitGroup& group, std::uint64_t n) {
  for (const Limit& limit : group.limits) {
    fmt::print(
        "| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", group.name, limit.stage, limit.yardstick,
        n, limit.measured ? fmt::format("{}{}", value_text(*limit.measured), limit.goal.unit) : "–",
        goal_text(limit.goal), met(limit, n == group.n), remark(limit, n == group.n));
  }
  std::fflush(stdout);
}

void print_memory(const LimitOptions& options) {
  const MemorySpeed speed =
      measure_memory(std::size_t{options.memory_mib} << 20, options.repetitions);
  fmt::print(
      "Memory of one thread, arrays of {} MiB: {:.1f} GB/s read, {:.1f} GB/s read and written by a "
      "copy, {:.0f} ns a dependent read at a random place, {:.1f} ns a read with 32 such chains at "
      "the same time.\n\n",
      options.memory_mib, speed.read_gb_per_s, speed.copy_gb_per_s, speed.latency_ns,
      speed.overlapped_ns);
}

/// False if a row failed.
bool print_limits(const LimitOptions& options) {
  const std::regex only(options.only);
  print_memory(options);
  fmt::print(
      "| row | stage | yardstick | n | measured | goal | met | "
      "|\n|---|---|---|---|---|---|---|---|\n");
  const Stopwatch time;
  bool all_well = true;
  for (LimitGroup& group : all_groups()) {
    if (!std::regex_search(group.name, only)) continue;
    const std::uint64_t n = std::min(group.n, options.max_n);
    fmt::print(stderr, "{:.0f} s: {}\n", time.wall_s(), group.name);
    all_well = measure(group, {n, options.repetitions}) && all_well;
    print_group(group, n);
  }
  return all_well;
}

/// False if a row failed.
bool run(const LimitOptions& options) {
  const Stopwatch time;
  fmt::print("Commit {}{}, medians of {} repetitions in turns, load average before {}.\n\n",
             source_hash(), source_is_dirty() ? " and uncommitted changes" : "",
             options.repetitions, load_average());
  bool all_well = true;
  if (options.families) {
    print_families(options.max_n, options.repetitions, options.only);
  } else {
    all_well = print_limits(options);
  }
  fmt::print("\n{:.0f} s in all, load average after {}.\n", time.wall_s(), load_average());
  return all_well;
}

}  // namespace
}  // namespace ar3d::kernels

int main(int argc, char** argv) {
  ar3d::kernels::LimitOptions options;
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
  app.add_flag("--families", options.families,
               "drawing beside a search for every algorithm, family and power of ten from 10^3 on, "
               "in rows named ALGORITHM/FAMILY");
  app.add_flag("--quick", options.quick,
               "graphs of 1000 vertices at most, once: only to see that every row is measured");
  app.add_option("--memory", options.memory_mib, "MiB of the arrays that tell the memory's speed")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 20))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (options.quick) {
    options.max_n = std::min(options.max_n, std::uint64_t{1000});
    options.repetitions = 1;
    options.memory_mib = 1;
  }
  try {
    return ar3d::kernels::run(options) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "ar3d_limits: {}\n", error.what());
    return 2;
  }
}
