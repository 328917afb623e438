// Reads a folder of results files in order, joins what is measured alike into lines, and looks for
// changes in each. Times are first divided by how slow the machine was.
#include "ar3d/analysis/history/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string_view>
#include <tuple>

#include "ar3d/analysis/compare/environment_change.h"
#include "ar3d/analysis/statistics.h"
#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

bool may_stand_in_name(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x80 && (std::isalnum(code) != 0 || c == '.' || c == '+' || c == '-');
}

bool is_name(const std::string& name) {
  return !name.empty() && name.size() <= 60 &&
         std::all_of(name.begin(), name.end(), may_stand_in_name);
}

/// Place and name in front of a file's name. @throws InputError naming the path.
void read_file_name(const fs::path& path, CommitResults& into) {
  const std::string file = path.filename().string();
  const std::size_t first = file.find('_');
  const std::size_t second = first == std::string::npos ? first : file.find('_', first + 1);
  bool is_good = second != std::string::npos;
  if (is_good) {
    const auto [end, error] = std::from_chars(file.data(), file.data() + first, into.place);
    into.name = file.substr(first + 1, second - first - 1);
    is_good = error == std::errc() && end == file.data() + first && into.place >= 0 && first > 0 &&
              is_name(into.name);
  }
  if (is_good) return;
  throw InputError(
      fmt::format("{}: its name does not begin with a place and a name, as 000123_v1.0_… does; "
                  "`ar3d history add` gives files their names",
                  path.string()));
}

std::vector<fs::path> results_files(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() == ".h5") files.push_back(at->path());
  }
  if (error) throw InputError(fmt::format("cannot read {}: {}", folder, error.message()));
  if (files.empty()) throw InputError(fmt::format("no results files (*.h5) in {}", folder));
  return files;
}

struct ReadResults {
  CommitResults commit;
  std::map<std::string, std::string> environment;
  CellTable table;
  std::vector<GraphFileRecord> files;
};

ReadResults read_one(const fs::path& path) {
  ReadResults read;
  read.commit.file = path.string();
  read_file_name(path, read.commit);
  RunReader reader(path.string());
  read.commit.source_hash = reader.identity().source_hash;
  read.commit.study = reader.identity().study_id;
  read.commit.created = reader.identity().created;
  read.files = graph_file_records(reader.identity());
  read.environment = lasting_settings(reader.environment());
  read.table = cell_values(view_of(reader));
  read.commit.unfinished = read.table.unfinished;
  const std::string load = load_of_other_work(reader.environment(), read.table.rows_at_a_time);
  if (!read.table.build_kind.empty()) {
    read.commit.untimed = fmt::format("a {} build", one_line(read.table.build_kind));
  } else if (!load.empty() && std::isnan(read.table.log_slowness)) {
    read.commit.untimed = fmt::format("a busy machine (load {})", one_line(load));
  }
  return read;
}

struct OpenLine {
  HistoryLine line;
  std::vector<std::string> exact;
  bool is_counted = true;  ///< every one of its results has counts of the cell
};
/// By what the values of a line have in common; filled in the order of the results.
using LineKey = std::tuple<std::size_t, std::string, HistoryCell, Measure>;
using OpenLines = std::map<LineKey, OpenLine>;

void add_values(std::size_t result, const CommitResults& commit, const CellTable& table,
                OpenLines& lines) {
  for (const auto& [cell, values] : table.cells) {
    for (std::size_t i = 0; i < kMeasures.size(); ++i) {
      if (!std::isfinite(values[i].value)) continue;
      if (kMeasures[i] == Measure::time && !commit.untimed.empty()) continue;
      OpenLine& entry = lines[{commit.environment, commit.study, cell, kMeasures[i]}];
      entry.line.results.push_back(result);
      entry.line.values.push_back(values[i].value /
                                  (kMeasures[i] == Measure::time ? commit.slowness : 1));
      const bool has_counts =
          std::isfinite(values[static_cast<std::size_t>(Measure::cycles)].value);
      entry.is_counted = entry.is_counted && has_counts;
      entry.exact.push_back(values[i].exact);
    }
  }
}

/// Every place where volume or bends of some graph changed, though their mean may be the same.
std::vector<ChangePoint> changes_of_drawings(const OpenLine& entry) {
  std::vector<ChangePoint> changes;
  for (std::size_t i = 1; i < entry.exact.size(); ++i) {
    if (entry.exact[i] == entry.exact[i - 1]) continue;
    const double before = entry.line.values[i - 1], after = entry.line.values[i];
    const double effect = before > 0 && after > 0 ? std::log(after / before) : kMissing;
    changes.push_back(
        {.at = i, .first = i, .last = i, .effect = effect, .interval = {effect, effect}});
  }
  return changes;
}

HistoryLine judged(const LineKey& key, OpenLine entry, const HistoryRule& rule) {
  HistoryLine& line = entry.line;
  std::tie(line.environment, line.study, line.cell, line.measure) = key;
  std::vector<double> logs;
  for (const double value : line.values) logs.push_back(std::log(value));
  const bool is_time = line.measure == Measure::time;
  line.is_judged = line.values.size() >= 2 * (is_time ? rule.time.shortest : 1);
  if (is_time && entry.is_counted) line.is_judged = false;
  switch (line.measure) {
    case Measure::time:
      if (line.is_judged) line.changes = find_changes(logs, rule.time);
      break;
    case Measure::instructions:
      line.changes = find_exact_changes(logs, std::log1p(rule.instruction_threshold));
      break;
    case Measure::cycles:
      line.changes = find_exact_changes(logs, std::log1p(rule.cycle_threshold));
      break;
    default:
      line.changes = changes_of_drawings(entry);
  }
  return std::move(line);
}

std::size_t place_of(const std::map<std::string, std::string>& environment,
                     std::vector<std::map<std::string, std::string>>& among) {
  const auto at = std::find(among.begin(), among.end(), environment);
  if (at != among.end()) return static_cast<std::size_t>(at - among.begin());
  among.push_back(environment);
  return among.size() - 1;
}

/// A file of graphs has one name in all results, the one of the last: its graphs' hash tells it.
/// @param read  in the order of the history.
void name_files_alike(std::vector<ReadResults>& read) {
  std::map<std::string, std::string> last_name;  // by the hash of the graphs
  for (const ReadResults& one : read) {
    for (const GraphFileRecord& file : one.files) last_name[file.hash] = file.name;
  }
  for (ReadResults& one : read) {
    std::map<std::string, std::string> renamed;
    for (const GraphFileRecord& file : one.files) renamed[file.name] = last_name[file.hash];
    std::map<HistoryCell, CellValues> cells;
    for (auto& [cell, values] : one.table.cells) {
      HistoryCell named = cell;
      const auto at = renamed.find(cell.curve.family);
      if (at != renamed.end()) named.curve.family = at->second;
      cells.emplace(std::move(named), std::move(values));
    }
    one.table.cells = std::move(cells);
  }
}

}  // namespace

std::string history_file_name(std::int64_t place, const std::string& name,
                              const StudyIdentity& study,
                              const std::vector<EnvironmentEntry>& environment) {
  if (!is_name(name)) {
    throw InputError(fmt::format(
        "'{}' is no name of a commit or release: up to 60 letters, digits, '.', '+' and '-'",
        name));
  }
  std::string settings;
  for (const auto& [key, value] : lasting_settings(environment)) {
    settings.append(key).append("\n").append(value).append("\n");
  }
  std::string study_id = study.study_id.substr(0, 60);
  std::replace_if(
      study_id.begin(), study_id.end(), [](char c) { return !may_stand_in_name(c) && c != '_'; },
      '-');
  return fmt::format("{:06}_{}_{}_{}.h5", place, name, study_id,
                     content_hash(settings).substr(0, 8));
}

History read_history(const std::string& folder, const HistoryRule& rule) {
  std::vector<ReadResults> read;
  for (const fs::path& path : results_files(folder)) read.push_back(read_one(path));
  std::sort(read.begin(), read.end(), [](const ReadResults& a, const ReadResults& b) {
    return std::tie(a.commit.place, a.commit.name, a.commit.file) <
           std::tie(b.commit.place, b.commit.name, b.commit.file);
  });
  name_files_alike(read);
  History history;
  history.rule = rule;
  OpenLines lines;
  std::map<std::size_t, std::vector<double>> slownesses;  // by environment
  for (ReadResults& one : read) {
    one.commit.environment = place_of(one.environment, history.environments);
    if (std::isnan(one.table.log_slowness)) continue;
    slownesses[one.commit.environment].push_back(one.table.log_slowness);
  }
  for (ReadResults& one : read) {
    if (!std::isnan(one.table.log_slowness)) {
      one.commit.slowness =
          std::exp(one.table.log_slowness - median(slownesses[one.commit.environment]));
    }
    add_values(history.results.size(), one.commit, one.table, lines);
    one.table.cells.clear();
    history.results.push_back(one.commit);
  }
  for (auto& [key, entry] : lines) history.lines.push_back(judged(key, std::move(entry), rule));
  return history;
}

std::size_t History::count(Measure measure, bool judged_only) const {
  return static_cast<std::size_t>(
      std::count_if(lines.begin(), lines.end(), [&](const HistoryLine& line) {
        return line.measure == measure && (line.is_judged || !judged_only);
      }));
}

}  // namespace ar3d
