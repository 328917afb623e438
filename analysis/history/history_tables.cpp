// The tables of a history: its results, lines, values and changes, and what times can show.
#include <cmath>
#include <set>

#include "ar3d/analysis/history/history.h"

namespace ar3d {
namespace {

using enum CellType;

Table history_table(const History& history, const std::string& folder) {
  std::size_t judged = 0;
  for (const HistoryLine& line : history.lines) judged += line.is_judged;
  Table table{"summary",
              "the history",
              {{"folder", "", "where it is"},
               {"results", "", "results", integer},
               {"environments", "", "environments", integer},
               {"lines", "", "lines", integer},
               {"judged", "", "lines that are judged", integer}}};
  table.add(
      {folder, history.results.size(), history.environments.size(), history.lines.size(), judged});
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

Table values_table(const History& history) {
  Table table{"history",
              "a line's value in a result",
              {{"line", "", "its row in lines", integer},
               {"result", "", "its row in results", integer},
               {"value", "", "in the unit of the measure", number, 6},
               {"change", "", "value over the line's first one, minus 1", number, 5}}};
  for (std::size_t i = 0; i < history.lines.size(); ++i) {
    const HistoryLine& line = history.lines[i];
    const double first = line.values.front() > 0 ? line.values.front() : kMissing;
    for (std::size_t at = 0; at < line.values.size(); ++at) {
      table.add({i, line.results[at], line.values[at], line.values[at] / first - 1});
    }
  }
  return table;
}

Table changes_table(const History& history) {
  Table table{"changes",
              "what a commit changed of a setting, the last commit first",
              {{"at", "", "the first result with it, in results", integer},
               {"before", "", "the last result without it", integer},
               {"setting", "", "an algorithm with its options; empty: all"},
               {"measure", "", "as in lines"},
               {"direction", "", "slower, fewer bends, …"},
               {"worse", "", "more of the measure", flag},
               {"cells", "", "cells that changed", integer},
               {"of", "", "cells of the setting", integer},
               {"change", "", "after over before, minus 1; the median of cells", number, 4},
               {"low", "", "its 95 % interval, or the least changed cell", number, 4},
               {"high", "", "upper end, or the most changed cell", number, 4},
               {"line", "", "of the cell that changed most, in lines", integer},
               {"command", "", "compares the two results"}}};
  for (const HistoryChange& change : history.changes) {
    table.add({change.at, change.before, change.setting, to_string(change.measure),
               direction_text(change), change.direction > 0, change.cells, change.of,
               std::expm1(change.effect), std::expm1(change.interval.low),
               std::expm1(change.interval.high), change.line, compare_command(history, change)});
  }
  return table;
}

Table sights_table(const History& history) {
  Table table{"sights",
              "the smallest change of a setting's times that its results show",
              {{"environment", "", "its number, from 1 on", integer},
               {"study", "", "the study"},
               {"setting", "", "an algorithm with its options"},
               {"cells", "", "cells with times", integer},
               {"results", "", "results with times", integer},
               {"at_once", "", "by the last result alone; missing: it cannot", number, 3},
               {"best", "", "with most results on either side", number, 3}}};
  for (const auto& [environment, study, smallest] : history.sights) {
    table.add({environment + 1, study, smallest.setting, smallest.cells, smallest.results,
               std::expm1(smallest.at_once), std::expm1(smallest.best)});
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

std::vector<Table> history_tables(const History& history, const std::string& folder) {
  return {history_table(history, folder), results_table(history), lines_table(history),
          values_table(history),          changes_table(history), sights_table(history),
          environments_table(history)};
}

}  // namespace ar3d
