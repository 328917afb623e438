// `ar3d history` as its users run it.
#include <fmt/format.h>

#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

/// The results of a small study, as if a program of that commit had made them on an idle machine.
std::string results_of(const ScratchDirectory& scratch, const std::string& commit) {
  const std::string spec = scratch.write(
      "tiny.toml",
      "study = 'tiny'\n[[sweep]]\nfamilies = 'cycle'\nsizes = 20\nalgorithms = 'grid'\n");
  const std::string path = scratch.path("now.h5");
  expect_exit(0, run("{} study run " + spec + " --threads 1 --quiet --force -o " + path));
  Results results = read_results(path);
  results.source_hash = commit;
  results.dirty = false;
  for (EnvironmentEntry& entry : results.environment) {
    if (entry.name.starts_with("load_")) entry.value = "0.00 0.00 0.00";
  }
  write_results(results, path);
  return path;
}

/// A repository with two commits, and what git calls them.
std::vector<std::string> two_commits(const std::string& folder) {
  const Outcome made = expect_exit(0, run("git init -q " + folder + " && cd " + folder +
                                          " && for i in 1 2; do git -c user.name=t -c "
                                          "user.email=t@t commit -q --allow-empty -m $i; "
                                          "git rev-parse HEAD; done"));
  return {made.out.substr(0, 40), made.out.substr(41, 40)};
}

TEST(HistoryProgram, ResultsAreAddedInTheOrderOfTheirCommitsAndReported) {
  const ScratchDirectory scratch;
  const std::string checkout = scratch.path("checkout"), folder = scratch.path("history");
  const std::vector<std::string> commits = two_commits(checkout);
  for (const std::size_t i : {1, 0}) {  // the younger one first
    const std::string results = results_of(scratch, commits[i]);
    expect_output(run("cd " + checkout + " && {} history add " + results + " --folder " + folder),
                  "00000" + std::to_string(i + 1) + "_" + commits[i].substr(0, 12) + "_tiny_");
  }
  const std::string json = scratch.path("history.json");
  const Outcome report =
      expect_exit(0, run("{} history report --folder " + folder + " --json " + json));
  EXPECT_THAT(report.out, HasSubstr("time: 0 of 1 lines judged"));
  EXPECT_THAT(report.out, HasSubstr("volume: 1 of 1 lines judged"));
  EXPECT_THAT(read_file(folder + "/history.html"), HasSubstr("<title>ar3d history: "));
  EXPECT_EQ(rows_by_table(read_file(json))["results"][0]["commit"], commits[0].substr(0, 12));
  expect_exit(0, run("{} history report --folder " + folder));  // the page is made again
}

TEST(HistoryProgram, AReleaseHasTheNameAndPlaceThatItIsGiven) {
  const ScratchDirectory scratch;
  const std::string results = results_of(scratch, "unknown"), folder = scratch.path("history");
  const std::string add = "{} history add " + results + " --folder " + folder;
  expect_exit(0, run(add + " --place 3 --name v1.0-rc1"));
  expect_error(run(add + " --place 3 --name v1.0-rc1"), "--force replaces it");
  expect_exit(0, run(add + " --place 3 --name v1.0-rc1 --force"));
  expect_error(run(add + " --place 4 --name v1.0-rc2"),
               "is in the history already, as " + folder + "/000003_v1.0-rc1_");
  expect_error(run("{} history report --folder " + folder), "nothing was judged", 5);
}

TEST(HistoryProgram, GraphsOfARenamedFileAreOneLine) {
  const ScratchDirectory scratch;
  const std::string folder = scratch.path("history"), json = scratch.path("history.json");
  const auto add = [&](const std::string& file, int index) {
    must(
        fmt::format("cd {} && {{}} study run -q --threads 1 --graphs {} --algorithm grid "
                    "-o {}.h5",
                    scratch.path(""), file, index));
    expect_exit(0, run(fmt::format("{{}} history add {}/{}.h5 --folder {} --place {} --name r{}",
                                   scratch.path(""), index, folder, index, index)));
  };
  must("{} generate random-cubic -n 20 --count 3 -o " + scratch.path("a.s6"));
  must("{} generate random-cubic -n 20 --count 3 --seed 9 -o " + scratch.path("c.s6"));
  add("a.s6", 1);
  fs::rename(scratch.path("a.s6"), scratch.path("b.s6"));
  add("b.s6", 2);
  fs::rename(scratch.path("c.s6"), scratch.path("a.s6"));
  add("a.s6", 3);  // the first name again, but of other graphs
  expect_exit(0, run("{} history report --folder " + folder + " --json " + json));
  std::vector<std::string> cells;  // one for each value of the volume
  auto tables = rows_by_table(read_file(json));
  for (const auto& value : tables["history"]) {
    const auto& line = tables["lines"][value["line"].get<std::size_t>()];
    if (line["measure"] == "volume") cells.push_back(line["cell"]);
  }
  EXPECT_THAT(cells, ::testing::UnorderedElementsAre(HasSubstr(" on b.s6"), HasSubstr(" on b.s6"),
                                                     HasSubstr(" on a.s6")));
}

TEST(HistoryProgram, BadInputIsOneClearLine) {
  const ScratchDirectory scratch;
  const std::string results = results_of(scratch, std::string(40, 'a'));
  const auto changed = [&](const std::string& name, const auto& change) {
    Results copy = read_results(results);
    change(copy);
    write_results(copy, scratch.path(name));
    return scratch.path(name);
  };
  const std::string dirty = changed("dirty.h5", [](Results& r) { r.dirty = true; });
  const std::string empty = changed("empty.h5", [](Results& r) { r.runs.clear(); });
  const std::string half = changed("half.h5", [](Results& r) { r.planned_rows = 100; });
  const std::string text = scratch.write("text.h5", "text");
  fs::create_directories(scratch.path("none"));
  fs::create_directories(scratch.path("wrong"));
  fs::copy_file(results, scratch.path("wrong/x.h5"));
  const std::string page = scratch.write("page.html", "a page of a user");
  const std::string to = " --folder " + scratch.path("history");
  for (const auto& [arguments, message] : std::vector<std::pair<std::string, std::string>>{
           {"add " + results + to, "say with --place where it stands in the order"},
           {"add " + results + to + " --place 1 --name a_b", "no name of a commit or release"},
           {"add " + results + to + " --place -1", "not a whole number"},
           {"add " + dirty + to + " --place 1", "with changes to commit aaaaaaaaaaaa"},
           {"add " + empty + to + " --place 1", "empty.h5 has no rows"},
           {"add " + half + to + " --place 1", "not finished: 1 of 100 rows"},
           {"add " + text + to + " --place 1", "text.h5"},
           {"add " + scratch.path("no.h5") + to, "no.h5"},
           {"report --folder " + scratch.path("nowhere"), "cannot read"},
           {"report --folder " + scratch.path("none"), "no results files (*.h5)"},
           {"report --folder " + scratch.path("wrong"), "x.h5: its name does not begin with"},
           {"report --folder " + scratch.path("wrong") + " -o " + page, "--force replaces it"},
           {"add " + results + to + " --place 1 --name ''", "--name: is empty"},
           {"report --threshold 0", "--threshold: '0' is not a number from 0.1 to 1000"},
           {"report --threshold abc", "'abc' is not a number from 0.1 to 1000"},
           {"", "subcommand"}}) {
    expect_one_line(run("cd " + scratch.path("none") + " && {} history " + arguments), message);
  }
  EXPECT_FALSE(fs::exists(scratch.path("history")));
}

}  // namespace
}  // namespace ar3d::testing
