// What README prints runs as it is printed.
// Shares of the proved box are those of the committed bounds table.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <regex>
#include <sstream>
#include <tuple>
#include <utility>

#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/run_storage.h"
#include "support/program.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

/// The first code block of `language` after `heading`.
std::string block(const std::string& heading, const std::string& language) {
  const std::string page = read_file(AR3D_SOURCE_DIR "/README.md");
  const std::string mark = "```" + language + "\n";
  const std::size_t begin = page.find(mark, page.find("\n" + heading + "\n"));
  if (begin == std::string::npos) return "echo no such block >&2; exit 99";
  const std::size_t text = begin + mark.size();
  return page.substr(text, page.find("```", text) - text);
}

/// Command lines with the program that was built; without those that build another one or run the
/// whole suite.
std::string runnable(const std::string& block) {
  std::string commands;
  std::istringstream lines(block);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("compare --base") != std::string::npos) continue;
    commands += std::regex_replace(line, std::regex(R"(\./ar3d)"), AR3D_PROGRAM) + "\n";
  }
  return commands;
}

TEST(Readme, CommandsAndPythonRunAsPrinted) {
  const ScratchDirectory folder;
  const std::string enter = "cd " + folder.path("") + " && ";
  const Outcome shell =
      expect_exit(0, run(enter + "set -euo pipefail; " + runnable(block("## Use it", "sh"))));
  for (const char* made : {"smoke.html", "k5.html", "drawing.html", "six.h5"}) {
    EXPECT_TRUE(fs::exists(folder.path(made))) << made;
  }
  folder.write("printed.py", block("## Use it", "python"));
  expect_output(run(enter + "/usr/bin/python3 -W error::FutureWarning printed.py"), "diamond");
}

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, separator);) cells.push_back(cell);
  return cells;
}

/// The rows of a committed table with these options, by the names of their columns.
std::vector<std::map<std::string, std::string>> committed(const std::string& file,
                                                          const std::string& options) {
  std::istringstream table(read_file(AR3D_SOURCE_DIR "/results/reference/" + file));
  std::string line;
  std::getline(table, line);
  const std::vector<std::string> names = split(line, ',');
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(table, line)) {
    const std::vector<std::string> cells = split(line, ',');
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i) {
      row[names[i]] = cells[i];
    }
    const bool is_own =
        file.starts_with("1.0.0-bounds") || file.find(row["algorithm"]) < file.size();
    if (row["options"] == options && is_own) rows.push_back(row);
  }
  return rows;
}

/// "95 % (y": the largest share of the theorem's box, and on which axis.
std::string largest_share(const std::string& file, const std::string& options) {
  double share = 0;
  std::string of;
  for (const auto& row : committed(file, options)) {
    for (const std::string axis : {"x", "y", "z"}) {
      const double seen = 1 - std::stod(row.at("worst_slack_" + axis));
      if (seen > share) std::tie(share, of) = std::tie(seen, axis);
    }
  }
  return fmt::format("{:.2g} % ({}", 100 * share, of);
}

/// "0.495 [0.488, 0.502]".
std::string exponent(const std::string& file, const std::string& quantity,
                     const std::string& options = "effort=1",
                     const std::string& family = "random-cubic",
                     const std::string& parameters = "") {
  for (const auto& row : committed(file, options)) {
    if (row.at("family") != family || row.at("parameters") != parameters) continue;
    if (row.at("quantity") != quantity) continue;
    return fmt::format("{:.3f} [{:.3f}, {:.3f}]{}", std::stod(row.at("exponent")),
                       std::stod(row.at("exponent_low")), std::stod(row.at("exponent_high")),
                       row.at("growth") == "apparent exponent" ? ", apparent" : "");
  }
  return "no such row";
}

/// Cell `column` (0: the label) of the first row of docs/algorithms.md whose label begins so.
std::string cell(const std::string& label, std::size_t column) {
  const std::string page = read_file(AR3D_SOURCE_DIR "/docs/algorithms.md");
  const std::size_t begin = page.find("\n| " + label);
  if (begin == std::string::npos) return "no such row";
  return split(page.substr(begin + 1, page.find('\n', begin + 1) - begin - 1), '|').at(column + 1);
}

TEST(Readme, SharesAndExponentsAreThoseOfTheCommittedTables) {
  const std::string share = "largest share of the proved box";
  for (const auto& [name, column] : {std::pair{"compact-120", 5u}, std::pair{"two-bend-109", 6u}}) {
    EXPECT_THAT(cell("| ", column), HasSubstr("`" + std::string(name) + "`"));
    const std::string bounds = fmt::format("0.2.0-{}-bounds.csv", name);
    EXPECT_THAT(cell(share, column), HasSubstr(largest_share(bounds, "effort=1")));
    EXPECT_THAT(cell(share, column), HasSubstr(largest_share(bounds, "effort=0") + ", effort 0)"));
  }
  const std::string growth = "0.2.0-compact-120-growth.csv";
  EXPECT_THAT(cell("exponent of the longest side", 5), HasSubstr(exponent(growth, "longest side")));
  EXPECT_THAT(cell("exponent of the volume", 5), HasSubstr(exponent(growth, "volume")));
}

// The first screen has the box of the large one.
TEST(Readme, FirstTableAgreesWithTheLargeOne) {
  const std::string page = read_file(AR3D_SOURCE_DIR "/README.md");
  const std::vector<std::string> names = {"diamond", "grid",        "two-bend",
                                          "compact", "compact-120", "two-bend-109"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::size_t begin = page.find("\n| `" + names[i] + "` |");
    ASSERT_NE(begin, std::string::npos) << names[i];
    const auto cells = split(page.substr(begin + 1, page.find('\n', begin + 1) - begin - 1), '|');
    ASSERT_EQ(cells.size(), 6u) << "five columns";
    EXPECT_THAT(cell("random graphs", i + 1), HasSubstr(cells[5].substr(1, cells[5].size() - 2)))
        << names[i];
  }
}

// In the skewed coordinates of Theorem 3, random cubic graphs and those that grow fastest.
TEST(Readme, SkewedExponentsAreThoseOfTheCommittedTable) {
  for (const auto& [family, parameters] : {std::pair{"random-cubic", "shuffle=1"},
                                           {"percolated-laves-graph", "keep=800000;shuffle=1"}}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::string found =
          exponent("1.0.0-bounds-growth.csv", fmt::format("skewed {} extent", "xyz"[axis]),
                   "spread=1;gap=0;cycle=0", family, parameters);
      EXPECT_EQ(cell("`" + std::string(family), axis + 1),
                " " + found.substr(0, found.find(", apparent")) + " ");
    }
  }
}

/// A bound of the report as the page prints it: superscripts, no additive constant; the paper's
/// n^3 stands for its order.
std::string printed(const nlohmann::json& bound, bool is_order) {
  if (bound.is_null()) return "–";
  std::string text = bound.get<std::string>();
  if (is_order && text == "n^3") return "O(n³)";
  text = text.substr(0, text.find('+'));
  if (text.ends_with(' ')) text.pop_back();
  for (const auto& [from, to] : {std::pair{"\\^2", "²"}, {"\\^3", "³"}, {"sqrt\\(n\\)", "√n"}}) {
    text = std::regex_replace(text, std::regex(from), to);
  }
  return text;
}

// docs/algorithms.md has a line a setting of what the report has a line an axis of.
TEST(Readme, PromisedAndDrawnIsWhatTheReportOfTheCommittedStudySays) {
  const ScratchDirectory folder;
  const std::string json = folder.path("tables.json");
  expect_exit(0, run("{} report " AR3D_SOURCE_DIR "/results/reference/1.0.0-bounds.h5 -o " +
                     folder.path("page.html") + " --json " + json));
  const std::string page = read_file(AR3D_SOURCE_DIR "/docs/algorithms.md");
  auto tables = rows_by_table(read_file(json));
  const std::map<std::string, std::string> labels = {
      {"diamond (effort=0)", "`diamond`, effort 0"},
      {"grid-paper (spread=0;gap=0;cycle=0)", "`grid-paper`, `spread=0`"},
      {"grid-paper (spread=2;gap=1;cycle=0)", "`grid-paper`, `spread=2`, `gap=1`"}};
  std::map<std::string, std::vector<std::string>> lines;  // cells of a setting
  const auto number = [](const nlohmann::json& value, const char* format) {
    return value.is_null() ? std::string("–")
                           : fmt::format(fmt::runtime(format), value.get<double>());
  };
  for (const auto& promise : tables["promises"]) {
    const std::string setting =
        tables["settings"][promise["setting"].get<std::size_t>()]["setting"];
    std::vector<std::string>& cells = lines[setting];
    cells.resize(4);
    const std::array of_axis = {printed(promise["paper"], true), printed(promise["proved"], false),
                                number(promise["exponent"], "{:.3f}"),
                                number(promise["constant"], "{:.3g}")};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cells[i] += (cells[i].empty() ? "" : ", ") + of_axis[i];
    }
  }
  EXPECT_EQ(lines.size(), 12u);
  const std::regex thrice("^(.*), \\1, \\1$");
  for (auto& [setting, cells] : lines) {
    if (setting.starts_with("lattice")) continue;
    for (std::string& of_axes : cells) of_axes = std::regex_replace(of_axes, thrice, "$1");
    const std::string name = "`" + setting.substr(0, setting.find(" (")) + "`";
    const auto label = labels.find(setting);
    EXPECT_THAT(
        page, HasSubstr(fmt::format("\n| {} | {} |\n", label == labels.end() ? name : label->second,
                                    fmt::join(cells, " | "))));
  }
}

// What docs/lower-bounds.md says of random 4-regular graphs by `compact`; the bound of every row.
TEST(Readme, LowerBoundsAreThoseOfTheCommittedStudy) {
  constexpr double kLargest = std::numeric_limits<double>::max();
  std::array<double, 3> least = {kLargest, kLargest, kLargest}, most = {};
  const Column needed = run_column("volume_at_least");
  for (const RunRecord& run :
       read_results(AR3D_SOURCE_DIR "/results/reference/1.0.0-bounds.h5").runs) {
    if (run.status != RunStatus::ok) continue;
    const double volume = std::exp2(run.log2_volume), bound = column_number(needed, run);
    ASSERT_TRUE(1 <= bound && bound <= volume * (1 + 1e-9)) << run.row_key;
    if (run.algorithm != "compact" || run.family != "random-4-regular") continue;
    if (run.instance_index > 0 || run.n < 631 || run.n > 2512) continue;
    const double unit = std::pow(run.n, 1.5);
    const std::array values = {volume / unit, bound / unit, volume / bound / 100};
    for (std::size_t i = 0; i < values.size(); ++i) {
      least[i] = std::min(least[i], values[i]);
      most[i] = std::max(most[i], values[i]);
    }
  }
  std::string page = read_file(AR3D_SOURCE_DIR "/docs/lower-bounds.md");
  page = std::regex_replace(page, std::regex("(\\d),(\\d)"), "$1$2");
  EXPECT_THAT(page, HasSubstr(fmt::format("draws {:.0f} to {:.0f} n^1.5", least[0], most[0])));
  EXPECT_THAT(page, HasSubstr(fmt::format("least {:.2f} to {:.2f} n^1.5", least[1], most[1])));
  EXPECT_THAT(page, HasSubstr(fmt::format("**{:.0f}00 to {:.0f}00 times", least[2], most[2])));
}

// results/reference/compact-120.md says so of every drawing that it counts.
TEST(Readme, CompactOf120NeededNoZonesInTheCommittedFile) {
  const ScratchDirectory folder;
  const std::string script =
      folder.write("counters.py",
                   "import h5py, re\n"
                   "runs = h5py.File('" AR3D_SOURCE_DIR
                   "/results/reference/0.2.0-compact-120.h5')['runs'][:]\n"
                   "runs = runs[runs['algorithm'] == b'compact-120']\n"
                   "assert not runs['violations'].any()\n"
                   "wider = 0\n"
                   "for options, n, text in zip(runs['options'], runs['n'], runs['counters']):\n"
                   "    c = dict(re.findall(r'(\\w+)=(\\d+)', text.decode()))\n"
                   "    if options == b'effort=0':\n"
                   "        continue\n"
                   "    assert c['zones'] == c['moved_components'] == '0', c\n"
                   "    if c['widenings'] != '0':\n"
                   "        assert options == b'effort=2' and n <= 700 and c['widenings'] == '1'\n"
                   "        wider += 1\n"
                   "print(len(runs), wider)\n");
  const Outcome counted = run("/usr/bin/python3 " + script);
  EXPECT_EQ(counted.out, "559 22\n") << counted.err;
}

}  // namespace
}  // namespace ar3d::testing
