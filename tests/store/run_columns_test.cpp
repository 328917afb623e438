// The columns of /runs and the page that lists them.
#include "ar3d/store/columns/run_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <utility>

#include "ar3d/store/columns/side_tables.h"
#include "store/sample_runs.h"
#include "support/problem.h"

namespace ar3d::testing {
namespace {

TEST(Columns, NamesAreUniqueAndDescribed) {
  std::set<std::string> names;
  for (const Column& column : run_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    EXPECT_FALSE(column.meaning.empty()) << column.name;
    EXPECT_EQ(column.unit.empty(), column.type == ColumnType::text || column.name == "seed")
        << column.name;
  }
  EXPECT_TRUE(names.contains("extent_z"));
}

// A table as the schema page lists it: columns that differ in their names alone share a line, and of
// metrics it names their table.
std::string shown(const StoredTable& table) {
  std::vector<std::pair<std::string, std::string>> lines;  // names and what they have in common
  for (const Column& column : table.columns) {
    std::string name =
        fmt::format("`{}`{}", column.name, column.kind == ColumnKind::instance ? " *" : "");
    constexpr const char* kTypes[] = {"text", "int64", "uint64", "float64"};
    std::string type = kTypes[static_cast<std::size_t>(column.type)];
    if (type == "text" && column.size > 1) type += fmt::format("[{}]", column.size);
    if (!column.unit.empty() && column.unit != "1") type += ", " + column.unit;
    std::string rest = fmt::format(" ({}): {}\n", type, column.meaning);
    if (column.kind == ColumnKind::metric) {
      name = "the metrics: extents, volume, bends, lengths, …";
      rest = " (int64 or float64): `ar3d list metrics` prints all in this order\n";
    }
    const auto same = std::ranges::find(lines, rest, &std::pair<std::string, std::string>::second);
    if (same == lines.end()) {
      lines.emplace_back(name, rest);
    } else if (std::string& names = same->first; name.ends_with("_y`") || name.ends_with("_z`")) {
      const std::size_t stem = names.find(name.substr(0, name.size() - 2));  // after its _x
      names.insert(names.find('`', stem + 1), fmt::format("/{}", name[name.size() - 2]));
    } else if (column.kind != ColumnKind::metric) {
      names += ", " + name;
    }
  }
  std::string page;
  for (const auto& [names, rest] : lines) page += "- " + names + rest;
  return page;
}

TEST(Columns, SchemaPageIsMadeOfThem) {
  std::ifstream in(AR3D_SOURCE_DIR "/results/SCHEMA.md");
  const std::string page(std::istreambuf_iterator<char>(in), {});
  std::vector<StoredTable> tables = side_table_specs();
  tables.push_back(runs_spec());
  tables.push_back(environments_spec(0, 0));
  for (const StoredTable& table : tables) {
    const std::size_t at = page.find("## Columns of `/" + table.name + "`\n\n" + shown(table));
    EXPECT_NE(at, std::string::npos) << table.name << " stands there as\n\n" << shown(table);
  }
}

TEST(Columns, NumbersOfMissingValuesAreMissing) {
  ar3d::RunRecord run = sample_run(4);
  run.bends[1] = 5;
  run.bends[2] = -1;
  run.log2_volume = 2.5;
  run.longest_edge_length = kMissing;
  EXPECT_EQ(metric_of(run, "bends_1"), 5);
  EXPECT_EQ(metric_of(run, "log2_volume"), 2.5);
  EXPECT_TRUE(std::isnan(metric_of(run, "bends_2")));
  EXPECT_TRUE(std::isnan(metric_of(run, "longest_edge_length")));
}

TEST(Columns, DifferencesNameTheColumnAndLeaveTimesOut) {
  ar3d::RunRecord a = sample_run(4);
  ar3d::RunRecord b = a;
  b.wall_s = 7;
  b.peak_bytes = 5;
  EXPECT_TRUE(differing_columns(a, b).empty());
  b.extents[1] += 1;
  b.counters = "H=4";
  EXPECT_THAT(differing_columns(a, b), ElementsAre("counters", "extent_y"));
}

TEST(Columns, IdentifyingTextsArePrintableAtEveryPlace) {
  for (int c = 0; c < 256; ++c) {
    for (std::size_t index = 0; index < 19; ++index) {
      ar3d::RunRecord run = sample_run(4);
      run.options = std::string(19, index % 2 == 0 ? ' ' : '~');
      run.options[index] = static_cast<char>(c);
      EXPECT_EQ(problem([&] { record_of(run); }).empty(), c >= ' ' && c <= '~')
          << c << " at " << index;
    }
  }
}

TEST(RunStatus, TextsGoBothWays) {
  for (int i = 0; i < 7; ++i) {
    const auto status = static_cast<RunStatus>(i);
    EXPECT_EQ(parse_run_status(to_string(status)), status);
  }
  EXPECT_THROW(parse_run_status("fine"), InputError);
  for (int i = 0; i < 6; ++i) {
    const auto phase = static_cast<RunPhase>(i);
    EXPECT_EQ(parse_run_phase(to_string(phase)), phase);
  }
  EXPECT_THROW(parse_run_phase("fast"), InputError);
}

}  // namespace
}  // namespace ar3d::testing
