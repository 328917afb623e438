#include "ar3d/analysis/google_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/store/columns/curves.h"

namespace ar3d {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* kStudy = "Google Benchmark";

std::string benchmark_name(const RunRecord& run) {
  std::string name = "draw";
  const std::string options = options_and_level(curve_of(run));
  for (const std::string* part : {&run.algorithm, &options, &run.family, &run.parameters}) {
    if (!part->empty()) name += "/" + *part;
  }
  if (run.n >= 0) name += fmt::format("/{}", run.n);
  if (run.instance_index >= 0) name += fmt::format("/instance:{}", run.instance_index);
  return one_line(name);
}

ordered_json benchmark_row(const RunRecord& run, const std::string& name) {
  ordered_json row = {{"name", name},
                      {"run_name", name},
                      {"run_type", "iteration"},
                      {"repetition_index", run.repetition},
                      {"threads", 1}};
  const bool is_drawn = run.status == RunStatus::ok || run.status == RunStatus::measured;
  if (!is_drawn || !std::isfinite(run.wall_s)) {
    row["error_occurred"] = true;
    row["error_message"] = fmt::format("{} {}", to_string(run.status), one_line(run.message));
    return row;
  }
  row["iterations"] = 1;
  row["real_time"] = 1e9 * run.wall_s;
  row["cpu_time"] = 1e9 * (std::isfinite(run.cpu_s) ? run.cpu_s : run.wall_s);
  row["time_unit"] = "ns";
  if (run.wall_s > 0) row["items_per_second"] = static_cast<double>(run.n) / run.wall_s;
  if (std::isfinite(run.log2_volume)) row["log2_volume"] = run.log2_volume;
  if (run.counted_instructions >= 0) row["INSTRUCTIONS"] = run.counted_instructions;
  return row;
}

ordered_json context_of(const RowView& rows) {
  const StudyIdentity& study = *rows.identity;
  ordered_json context = {{"date", valid_utf8(study.created)},
                          {"executable", "ar3d"},
                          {"study", valid_utf8(study.study_id)},
                          {"source_hash", valid_utf8(study.source_hash)}};
  for (const EnvironmentEntry& entry : *rows.environment) {
    context[valid_utf8(entry.name)] = valid_utf8(entry.value);
  }
  return context;
}

/// Seconds of one time unit. @throws InputError
double seconds_of(const std::string& unit) {
  static const std::map<std::string, double> kUnits = {
      {"ns", 1e-9}, {"us", 1e-6}, {"ms", 1e-3}, {"s", 1}};
  const auto at = kUnits.find(unit);
  if (at == kUnits.end()) throw InputError(fmt::format("unknown time_unit '{}'", one_line(unit)));
  return at->second;
}

RunRecord run_of(const json& row, std::int64_t repetition) {
  RunRecord run;
  run.algorithm = row.at("name").get<std::string>();
  run.repetition = repetition;
  if (row.value("error_occurred", false)) {
    run.message = row.value("error_message", "");
    return run;  // crashed, as rows are from the start
  }
  const double unit = seconds_of(row.value("time_unit", "ns"));
  run.status = RunStatus::ok;
  run.wall_s = unit * row.at("real_time").get<double>();
  run.cpu_s = unit * row.at("cpu_time").get<double>();
  if (row.contains("INSTRUCTIONS")) {
    run.counted_instructions = static_cast<std::int64_t>(
        std::clamp(row.at("INSTRUCTIONS").get<double>(), -1.0, 9e18));  // NaN never parses
  }
  return run;
}

/// What of the context says whether times are comparable: all but what differs from run to run.
std::vector<EnvironmentEntry> environment_of(const json& context) {
  static const std::set<std::string> kPassing = {"date",        "executable",     "study",
                                                 "source_hash", "mhz_per_cpu",    "load_avg",
                                                 "load_after",  "library_version"};
  std::vector<EnvironmentEntry> entries;
  for (const auto& [name, value] : context.items()) {
    if (kPassing.contains(name)) continue;
    entries.push_back({name == "num_cpus" ? "cores" : name,
                       value.is_string() ? value.get<std::string>() : value.dump()});
  }
  const json load = context.value("load_avg", json::array());
  if (!load.empty()) entries.push_back({"load_before", load.front().dump()});
  return entries;
}

Results results_of(const json& report) {
  Results results;
  results.study_id = kStudy;
  const json context = report.value("context", json::object());
  results.created = context.value("date", "");
  results.environment = environment_of(context);
  std::map<std::string, std::int64_t> repetitions;
  for (const json& row : report.at("benchmarks")) {
    if (row.value("run_type", "iteration") != "iteration") continue;
    const std::int64_t repetition = repetitions[row.at("name").get<std::string>()]++;
    results.runs.push_back(run_of(row, repetition));
  }
  return results;
}

}  // namespace

void google_benchmark_json(const RowView& rows, const TextSink& write) {
  std::set<std::string> timed;  // names with a timing phase
  for (std::size_t row = 0; row < rows.count; ++row) {
    const RunRecord& run = rows.read(row);
    if (run.phase == RunPhase::timing) timed.insert(benchmark_name(run));
  }
  write("{\n\"context\": " + context_of(rows).dump(1) + ",\n\"benchmarks\": [\n");
  bool is_first = true;
  for (std::size_t row = 0; row < rows.count; ++row) {
    const RunRecord& run = rows.read(row);
    const std::string name = benchmark_name(run);
    const RunPhase wanted = timed.contains(name) ? RunPhase::timing : RunPhase::metrics;
    if (run.phase != wanted) continue;
    write((is_first ? "" : ",\n") + benchmark_row(run, name).dump());
    is_first = false;
  }
  write("\n]\n}\n");
}

Results read_google_benchmark(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("cannot read {}: No such file or directory", path));
  try {
    return results_of(json::parse(file));
  } catch (const json::exception& error) {
    const std::string_view what = error.what();  // "[json.exception.NAME.NUMBER] what"
    const std::size_t end = what.find("] ");
    throw InputError(
        fmt::format("{} is not a Google Benchmark report: {}", path,
                    one_line(what.substr(end == std::string_view::npos ? 0 : end + 2))));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", path, error.what()));
  }
}

Results read_results_or_benchmarks(const std::string& path) {
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
    throw InputError(path + " is not a regular file");  // which can be read twice
  }
  std::ifstream file(path, std::ios::binary);
  char first = '\0';
  if (file >> first && first == '{') return read_google_benchmark(path);
  return read_results(path);
}

}  // namespace ar3d
