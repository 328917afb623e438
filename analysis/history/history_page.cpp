// The page of a history: tables of its results, lines, values and changes, in the template of the
// tree.
#include <cmath>
#include <set>

#include "ar3d/analysis/history/history.h"
#include "ar3d/analysis/report.h"

namespace ar3d {
namespace {

using enum CellType;

Table history_table(const History& history, const std::string& folder) {
  std::size_t judged = 0, lines = 0, changes = 0;
  for (const HistoryLine& line : history.lines) {
    judged += line.is_judged;
    changes += line.changes.size();
    ++lines;
  }
  Table table{"summary",
              "the history",
              {{"folder", "", "where it is"},
               {"results", "", "results", integer},
               {"environments", "", "environments", integer},
               {"lines", "", "lines", integer},
               {"judged", "", "lines that are judged", integer},
               {"unjudged", "", "the others", integer},
               {"changes", "", "changes", integer},
               {"shortest", "", "results of one environment that times need", integer}}};
  table.add({folder, history.results.size(), history.environments.size(), lines, judged,
             lines - judged, changes, 2 * history.rule.time.shortest});
  return table;
}

Table results_table(const History& history) {
  Table table{"results",
              "a results file of the history",
              {{"place", "", "where it stands in the order", integer},
               {"name", "", "of the commit or release"},
               {"commit", "", "of the program"},
               {"study", "", "the study"},
               {"created", "", "when it was begun"},
               {"environment", "", "its number, from 1 on", integer},
               {"unfinished", "", "rows", integer},
               {"slowness", "", "how many times as slow as usual the machine was", number, 3},
               {"untimed", "", "why its times are left out; empty: they are not"}}};
  for (const CommitResults& one : history.results) {
    table.add({one.place, one.name, one.source_hash.substr(0, 12), one.study, one.created,
               one.environment + 1, one.unfinished, one.slowness, one.untimed});
  }
  return table;
}

Table lines_table(const History& history) {
  Table table{"lines",
              "a measure of a cell over the results of one study and environment",
              {{"environment", "", "its number, from 1 on", integer},
               {"study", "", "the study"},
               {"setting", "", "an algorithm with its options"},
               {"family", "", "the family"},
               {"n", "vertices", "vertices", integer},
               {"graphs", "", "hash of the cell's graphs"},
               {"cell", "", "the cell's name"},
               {"measure", "", "time, instructions, cycles, volume, bends, crossings or angle"},
               {"judged", "", "the line is judged", flag}}};
  for (const HistoryLine& line : history.lines) {
    table.add({line.environment + 1, line.study, algorithm_label(line.cell.curve),
               family_label(line.cell.curve), count_or_none(line.cell.n), line.cell.graphs,
               cell_label(line.cell.curve, line.cell.n), to_string(line.measure), line.is_judged});
  }
  return table;
}

/// The median between the changes around each value.
std::vector<double> levels_of(const HistoryLine& line) {
  std::vector<double> levels;
  for (std::size_t i = 0; i <= line.changes.size(); ++i) {
    const std::size_t end = i < line.changes.size() ? line.changes[i].at : line.values.size();
    const auto first = line.values.begin() + static_cast<std::ptrdiff_t>(levels.size());
    const auto last = line.values.begin() + static_cast<std::ptrdiff_t>(end);
    levels.resize(end, median({first, last}));
  }
  return levels;
}

Table values_table(const History& history) {
  Table table{"history",
              "a line's value in a result",
              {{"line", "", "its row in lines", integer},
               {"result", "", "its row in results", integer},
               {"value", "", "in the unit of the measure", number, 6},
               {"change", "", "value over the line's first one, minus 1", number, 5},
               {"level", "", "the same of the median between two changes", number, 5}}};
  for (std::size_t i = 0; i < history.lines.size(); ++i) {
    const HistoryLine& line = history.lines[i];
    const std::vector<double> levels = levels_of(line);
    const double first = line.values.front() > 0 ? line.values.front() : kMissing;
    for (std::size_t at = 0; at < line.values.size(); ++at) {
      table.add({i, line.results[at], line.values[at], line.values[at] / first - 1,
                 levels[at] / first - 1});
    }
  }
  return table;
}

Table changes_table(const History& history) {
  Table table{"changes",
              "a change of a line, the largest first",
              {{"line", "", "its row in lines", integer},
               {"direction", "", "slower, fewer bends, …"},
               {"worse", "", "more of the measure", flag},
               {"at", "", "the line's first value with it", integer},
               {"first", "", "with 95 % confidence it is not earlier", integer},
               {"last", "", "and not later", integer},
               {"change", "", "new over old level, minus 1; missing: no ratio", number, 4},
               {"low", "", "its 95 % interval", number, 4},
               {"high", "", "upper end", number, 4},
               {"old_value", "", "the value before it", number, 6},
               {"new_value", "", "the first value with it", number, 6},
               {"before", "", "name of the result before it"},
               {"after", "", "name of the first result with it"},
               {"surely_before", "", "the last result that surely has not got it"},
               {"surely_after", "", "the first result that surely has it"},
               {"gradual", "", "a straight line fits better than a step", flag},
               {"command", "", "compares the results before it with those behind it"}}};
  for (const PlacedChange& placed : changes_in_order(history)) {
    const HistoryLine& line = *placed.line;
    const ChangePoint& change = *placed.change;
    const Neighbours at = around(history, placed, false), surely = around(history, placed, true);
    table.add({&line - history.lines.data(), direction_text(placed), change.effect > 0, change.at,
               change.first, change.last, std::expm1(change.effect),
               std::expm1(change.interval.low), std::expm1(change.interval.high),
               line.values[change.at - 1], line.values[change.at], at.before->name, at.after->name,
               surely.before->name, surely.after->name, change.gradual,
               compare_command(history, line, change)});
  }
  return table;
}

/// What all environments share is left out where there are several.
Table environments_table(const History& history) {
  Table table{"environments",
              "a setting of an environment",
              {{"environment", "", "its number, from 1 on", integer},
               {"name", "", "the setting"},
               {"value", "", "its value"}}};
  std::set<std::string> names;
  for (const auto& settings : history.environments) {
    for (const auto& [name, value] : settings) names.insert(name);
  }
  for (const std::string& name : names) {
    std::vector<std::string> values;
    for (const auto& settings : history.environments) {
      const auto at = settings.find(name);
      values.push_back(at == settings.end() ? "absent" : at->second);
    }
    if (values.size() > 1 && std::set(values.begin(), values.end()).size() == 1) continue;
    for (std::size_t i = 0; i < values.size(); ++i) table.add({i + 1, name, values[i]});
  }
  return table;
}

}  // namespace

std::string render_history(const History& history, const std::string& folder) {
  return render_page("history", folder,
                     {history_table(history, folder), results_table(history), lines_table(history),
                      values_table(history), changes_table(history), environments_table(history)});
}

}  // namespace ar3d
