// Reads a folder of results files in order, joins what is measured alike into lines, and looks for
// changes in each. Changes of cells are listed by commit and setting.
#include "ar3d/analysis/history/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "ar3d/base/number.h"
#include "ar3d/base/printable.h"

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
    into.index = integer_of<std::int64_t>(file.substr(0, first)).value_or(-1);
    into.name = file.substr(first + 1, second - first - 1);
    is_good = into.index >= 0 && is_name(into.name);
  }
  if (is_good) return;
  throw InputError(
      fmt::format("{}: its name does not begin with a place and a name, as 000123_v1.0_… does; "
                  "`ar3d history add` gives files their names",
                  path.string()));
}

/// Returns the mean of the short yardsticks, as log_slowness of a row.
double log_slowness(const CommitResults& results) {
  return (results.yardsticks[0] + results.yardsticks[2]) / 2;
}

CommitResults read_one(const std::string& path) {
  CommitResults read;
  read.file = path;
  read_file_name(path, read);
  const Rows rows(path);
  read.source_hash = rows.identity().source_hash;
  read.study = rows.identity().study_id;
  read.created = rows.identity().created;
  take_rows(rows, read);
  const std::string load = load_of_other_work(rows.environment(), read.rows_at_a_time);
  if (!read.build_kind.empty()) {
    read.untimed = fmt::format("a {} build", one_line(read.build_kind));
  } else if (!load.empty() && std::isnan(log_slowness(read))) {
    read.untimed = fmt::format("a busy machine (load {})", one_line(load));
  }
  return read;
}

/// By what the values of a line have in common; filled in the order of the results.
using LineKey = std::tuple<std::size_t, std::string, HistoryCell, Measure>;
using Lines = std::map<LineKey, HistoryLine>;

/// @param unit  what times of the cells are in units of, as a logarithm. @param more  that is to be
/// taken off their levels.
void add_values(std::size_t result, const CommitResults& commit, double unit, double more,
                Lines& lines) {
  for (const auto& [cell, values] : commit.cells) {
    for (std::size_t i = 0; i < kMeasures.size(); ++i) {
      const bool is_time = kMeasures[i] == Measure::time;
      const double value = is_time ? std::exp(values.times.level - more + unit) : values.means[i];
      if (!std::isfinite(value) ||
          (is_time && !(commit.untimed.empty() && values.times.rounds > 0))) {
        continue;
      }
      HistoryLine& line = lines[{commit.environment, commit.study, cell, kMeasures[i]}];
      line.results.push_back(result);
      line.values.push_back(value);
      line.exact.push_back(values.exact[i]);
      line.times.push_back(values.times);
      line.times.back().level -= more;
      line.is_counted &= std::isfinite(values.means[static_cast<std::size_t>(Measure::cycles)]);
    }
  }
}

/// Collects what changed in cells into changes of settings.
class Changes {
 public:
  explicit Changes(History& history) : history_(history) {
    for (std::size_t i = 0; i < history.lines.size(); ++i) {
      const HistoryLine& line = history.lines[i];
      for (const std::size_t result : line.results)
        ++cells_[{result, setting_of(line), line.measure}];
    }
  }

  /// Values without noise: what changed since the last change.
  void add_exact(std::size_t number, double threshold) {
    const HistoryLine& line = history_.lines[number];
    const bool is_drawing = line.measure >= Measure::volume;
    std::size_t last = 0;
    for (std::size_t i = 1; i < line.values.size(); ++i) {
      const double before = line.values[last], after = line.values[i];
      const double effect = before > 0 && after > 0 ? std::log(after / before) : kMissing;
      const bool is_changed =
          is_drawing ? line.exact[i] != line.exact[last] : std::abs(effect) > std::log1p(threshold);
      if (!is_changed) continue;
      last = i;
      found_[{line.results[i], line.results[i - 1], setting_of(line), line.measure,
              (after > before) - (after < before)}]
          .emplace_back(effect, number);
    }
  }

  /// @param results, cells  the numbers of the series' results and cells in the history.
  void add_times(const std::vector<TimeStep>& steps, const std::vector<std::size_t>& results,
                 const std::vector<std::size_t>& cells) {
    for (const TimeStep& step : steps) {
      HistoryChange change{.at = results[step.at],
                           .before = results[step.at - 1],
                           .setting = step.setting,
                           .measure = Measure::time,
                           .direction = step.change > 0 ? 1 : -1,
                           .cells = step.cells,
                           .of = step.cells,
                           .effect = step.change,
                           .interval = {step.change - step.error, step.change + step.error},
                           .line = cells[step.most]};
      if (step.cell != kNoCell) change.of = cells_[{change.at, step.setting, Measure::time}];
      history_.changes.push_back(std::move(change));
    }
  }

  void finish() {
    for (auto& [key, cells] : found_) {
      HistoryChange change;
      std::tie(change.at, change.before, change.setting, change.measure, change.direction) = key;
      change.cells = cells.size();
      change.of = cells_[{change.at, change.setting, change.measure}];
      std::vector<double> effects;
      for (const auto& [effect, line] : cells) effects.push_back(effect);
      change.effect = median(effects);
      std::stable_sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
        return std::abs(a.first) > std::abs(b.first);
      });
      change.interval = {cells.back().first, cells.front().first};
      change.line = cells.front().second;
      history_.changes.push_back(std::move(change));
    }
    const auto order = [&](const HistoryChange& change) {
      const CommitResults& at = history_.results[change.at];
      const double size = std::isfinite(change.effect) ? std::abs(change.effect) : -1;
      return std::tuple(-at.index, at.name, change.at, change.measure, -size);
    };
    std::stable_sort(history_.changes.begin(), history_.changes.end(),
                     [&](const auto& a, const auto& b) { return order(a) < order(b); });
  }

 private:
  static std::string setting_of(const HistoryLine& line) {
    return algorithm_label(line.cell.curve);
  }

  History& history_;
  /// Holds how many cells a setting has in a result.
  std::map<std::tuple<std::size_t, std::string, Measure>, std::size_t> cells_;
  /// By result, the one before, setting, measure and direction: effects and lines.
  std::map<std::tuple<std::size_t, std::size_t, std::string, Measure, int>,
           std::vector<std::pair<double, std::size_t>>>
      found_;
};

/// Judges the times of one study in one environment; the lines are [begin, end).
void judge_times(std::size_t begin, std::size_t end, const CompareOptions& rule, History& history,
                 Changes& changes) {
  TimeSeries series;
  std::vector<std::size_t> cells, results;
  for (std::size_t i = begin; i < end; ++i) {
    HistoryLine& line = history.lines[i];
    if (line.measure != Measure::time) continue;
    line.is_judged = !line.is_counted;
    if (!line.is_judged) continue;
    cells.push_back(i);
    series.settings.push_back(algorithm_label(line.cell.curve));
    results.insert(results.end(), line.results.begin(), line.results.end());
  }
  std::sort(results.begin(), results.end());
  results.erase(std::unique(results.begin(), results.end()), results.end());
  for (const std::size_t result : results) {
    series.yardsticks.push_back(history.results[result].yardsticks);
    series.results.emplace_back(cells.size());
  }
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const HistoryLine& line = history.lines[cells[cell]];
    for (std::size_t i = 0; i < line.results.size(); ++i) {
      const auto at = std::lower_bound(results.begin(), results.end(), line.results[i]);
      series.results[static_cast<std::size_t>(at - results.begin())][cell] = line.times[i];
    }
  }
  const auto& [steps, all_smallest] = find_time_steps(series, rule);
  changes.add_times(steps, results, cells);
  for (const SmallestStep& smallest : all_smallest) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (series.settings[i] != smallest.setting) continue;
      history.lines[cells[i]].is_judged = std::isfinite(smallest.best);
    }
    history.sights.emplace_back(history.lines[begin].environment, history.lines[begin].study,
                                smallest);
  }
}

void judge(const CompareOptions& rule, History& history) {
  Changes changes(history);
  for (std::size_t begin = 0; begin < history.lines.size();) {
    std::size_t end = begin;
    while (end < history.lines.size() &&
           history.lines[end].environment == history.lines[begin].environment &&
           history.lines[end].study == history.lines[begin].study) {
      const Measure measure = history.lines[end].measure;
      if (measure != Measure::time) {
        changes.add_exact(
            end, measure == Measure::cycles ? rule.cycle_threshold : rule.instruction_threshold);
      }
      ++end;
    }
    judge_times(begin, end, rule, history, changes);
    begin = end;
  }
  changes.finish();
}

std::size_t index_of(const std::map<std::string, std::string>& environment,
                     std::vector<std::map<std::string, std::string>>& among) {
  const auto at = std::find(among.begin(), among.end(), environment);
  if (at != among.end()) return static_cast<std::size_t>(at - among.begin());
  among.push_back(environment);
  return among.size() - 1;
}

/// A file of graphs has one name in all results, the one of the last: its graphs' hash tells it.
/// @param read  in the order of the history.
void name_files_alike(std::vector<CommitResults>& read) {
  std::map<std::string, std::string> last_name;  // by the hash of the graphs
  for (const CommitResults& one : read) {
    for (const GraphFileRecord& file : one.graph_files) last_name[file.hash] = file.name;
  }
  for (CommitResults& one : read) {
    std::map<std::string, std::string> renamed;
    for (const GraphFileRecord& file : one.graph_files) renamed[file.name] = last_name[file.hash];
    std::map<HistoryCell, CellValues> cells;
    for (auto& [cell, values] : one.cells) {
      HistoryCell named = cell;
      const auto at = renamed.find(cell.curve.family);
      if (at != renamed.end()) named.curve.family = at->second;
      cells.emplace(std::move(named), std::move(values));
    }
    one.cells = std::move(cells);
  }
}

}  // namespace

std::string history_file_name(std::int64_t index, const std::string& name,
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
  return fmt::format("{:06}_{}_{}_{}.h5", index, name, study_id,
                     content_hash(settings).substr(0, 8));
}

std::vector<std::string> results_files(const std::string& folder, std::error_code& error) {
  std::vector<std::string> files;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() == ".h5") files.push_back(at->path().string());
  }
  return files;
}

History read_history(const std::string& folder, const CompareOptions& rule) {
  std::error_code error;
  const std::vector<std::string> files = results_files(folder, error);
  if (error) throw InputError(fmt::format("cannot read {}: {}", folder, error.message()));
  if (files.empty()) throw InputError(fmt::format("no results files (*.h5) in {}", folder));
  std::vector<CommitResults> read;
  for (const std::string& path : files) read.push_back(read_one(path));
  std::ranges::sort(
      read, {}, [](const CommitResults& one) { return std::tie(one.index, one.name, one.file); });
  name_files_alike(read);
  History history;
  Lines lines;
  std::map<std::size_t, std::vector<double>> slownesses;  // by environment
  for (CommitResults& one : read) {
    one.environment = index_of(one.settings, history.environments);
    slownesses[one.environment].push_back(log_slowness(one));
  }
  for (CommitResults& one : read) {
    const double own = log_slowness(one), usual = median(slownesses[one.environment]);
    const double unit = std::isnan(usual) ? 0 : usual;
    if (!std::isnan(own)) one.slowness = std::exp(own - unit);
    add_values(history.results.size(), one, unit, std::isnan(own) ? unit : 0, lines);
    one.cells.clear();
    history.results.push_back(std::move(one));
  }
  for (auto& [key, line] : lines) {
    std::tie(line.environment, line.study, line.cell, line.measure) = key;
    line.is_judged = line.values.size() >= 2;
    history.lines.push_back(std::move(line));
  }
  judge(rule, history);
  return history;
}

}  // namespace ar3d
