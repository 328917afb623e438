// From rows to verdicts through the program: check, report, hunt and shrink, and their bad inputs.
#include <functional>
#include <sstream>

#include "analysis/synthetic.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

/// Writes the results, after a change, where the test can use them.
std::string results_file(const ScratchDirectory& scratch,
                         const std::function<void(Results&)>& change = {}) {
  Results results = good_results({"diamond"}, {"cubic"}, 3, 2);
  if (change) change(results);
  const std::string path = scratch.path("results.h5");
  write_results(results, path);
  return path;
}

TEST(CheckProgram, ExitCodeIsTheVerdict) {
  const ScratchDirectory scratch;
  expect_exit(0, run("{} check " + results_file(scratch)));
  expect_output(
      run("{} check " +
          results_file(scratch, [](Results& results) { results.runs[4].extents[2] = 1000; })),
      "extent 1000 along z passes the theorem's", 4);
  expect_output(run("{} check " + results_file(scratch,
                                               [](Results& results) {
                                                 results.runs[1].violations = 2;
                                                 results.runs[1].status = RunStatus::violated;
                                                 results.runs[1].message =
                                                     "crossing: edges 3 and 7";
                                               })),
                "crossing: edges 3 and 7", 4);
}

TEST(CheckProgram, NoRowsAndNoNumbersAreIncomplete) {
  const ScratchDirectory scratch;
  expect_output(
      run("{} check " + results_file(scratch, [](Results& results) { results.runs.clear(); })),
      "nothing measured: the file has no rows", 5);
  expect_output(
      run("{} check " +
          results_file(scratch, [](Results& results) { results.runs[2].log2_volume = kMissing; })),
      "log2_volume is not a number of at least 0 although ok", 5);
}

TEST(ReportProgram, OfNoRowsSaysSoAndIsIncomplete) {
  const ScratchDirectory scratch;
  const std::string path = results_file(scratch, [](Results& results) { results.runs.clear(); });
  expect_one_line(run("{} report " + path), "nothing measured: the file has no rows", 5);
  EXPECT_THAT(read_file(scratch.path("results.html")), HasSubstr("\"INCOMPLETE\""));
}

TEST(ReportProgram, WritesTables) {
  const ScratchDirectory scratch;
  const std::string path =
      results_file(scratch, [](Results& results) { results.runs[0].family = "=1+1"; });
  expect_exit(0, run("{} report " + path + " --csv " + scratch.path("l.csv") + " --growth " +
                     scratch.path("g.csv") + " --rows " + scratch.path("r.csv") + " --json " +
                     scratch.path("a.json")));
  EXPECT_THAT(read_file(scratch.path("r.csv")),
              AllOf(HasSubstr("published_bound_x"), HasSubstr(",\"'=1+1\",")));
  EXPECT_THAT(read_file(scratch.path("l.csv")), HasSubstr("volume_share"));
  EXPECT_THAT(read_file(scratch.path("g.csv")), HasSubstr("exponent_low"));
  EXPECT_THAT(read_file(scratch.path("a.json")), StartsWith("{\"format\":\"ar3d tables 1\""));
}

TEST(FiguresProgram, WritesWhatIsAskedFor) {
  const ScratchDirectory scratch;
  const std::string folder = scratch.path("figures");
  const std::string figures = "{} figures " + results_file(scratch) + " -o " + folder;
  expect_exit(0,
              run(figures + " --quantity side,z --families cubic --width 60mm --format svg,pdf"));
  EXPECT_THAT(read_file(folder + "/side.pdf"), StartsWith("%PDF-"));
  EXPECT_THAT(read_file(folder + "/z.svg"), HasSubstr("width=\"170."));  // 60 mm are 170.08 points
  EXPECT_THAT(read_file(folder + "/tables.json"), StartsWith("{\"format\":\"ar3d tables 1\""));
  const std::string before = read_file(folder + "/side.pdf");
  expect_one_line(run(figures + " --format pdf"), "side.pdf");
  expect_exit(0, run(figures + " --quantity side,z --families cubic --width 60mm --format svg,pdf "
                               "--force"));
  EXPECT_EQ(read_file(folder + "/side.pdf"), before) << "equal tables give equal bytes";
  expect_exit(0, run(figures + " --quantity side,volume --grid --format png --force"));
  EXPECT_THAT(read_file(folder + "/side-volume.png"), StartsWith("\x89PNG"));
}

TEST(FiguresProgram, RefusesInOneLine) {
  const ScratchDirectory scratch;
  const std::string figures =
      "{} figures " + results_file(scratch) + " -o " + scratch.path("none") + " ";
  const std::pair<const char*, const char*> kRefused[] = {
      {"--quantity depth", "'depth' is none of side"},
      {"--quantity time", "timed_repetitions"},
      {"--quantity trade", "no two of these settings have times"},
      {"--quantity profile", "no collection"},
      {"--algorithms unknown", "--algorithms unknown: the study has"},
      {"--families 'no<such'", "--families no<such: the study has"},
      {"--width 3km", "'3km' is no width"},
      {"--font-size 0", "'0' is no font size"},
      {"--format gif", "'gif' is none of pdf"},
      {"--style /no/such", "--style /no/such"}};
  for (const auto& [words, message] : kRefused) {
    expect_one_line(run(figures + words), message);
  }
  EXPECT_FALSE(fs::exists(scratch.path("none/side.pdf")));
  EXPECT_FALSE(fs::exists(scratch.path("none/tables.json")));
}

TEST(FiguresProgram, SaysWhatToInstall) {
  const ScratchDirectory scratch;
  const std::string words =
      " {} figures " + results_file(scratch) + " -o " + scratch.path("figures");
  scratch.write("matplotlib.py", "raise ImportError('none')\n");
  expect_one_line(run("PYTHONPATH=" + scratch.path("") + words), "apt install python3-matplotlib");
}

/// What is wrong with a results file, by a change with h5py, and what is said about it.
struct BadResults {
  const char* name;
  const char* change;
  const char* message;
};
std::ostream& operator<<(std::ostream& out, const BadResults& bad) { return out << bad.name; }

class BadResultsTest : public ::testing::TestWithParam<BadResults> {};

TEST_P(BadResultsTest, OneLineAndExitTwo) {
  const ScratchDirectory scratch;
  const std::string path = results_file(scratch);
  const std::string script = scratch.write(
      "change.py", "import h5py\nf = h5py.File('" + path + "', 'a')\n" + GetParam().change);
  must("/usr/bin/python3 " + script);
  renew_checksum(path);
  for (const char* verb : {"check", "report"}) {
    const Outcome outcome = run(std::string("{} ") + verb + " " + path);
    expect_one_line(outcome, GetParam().message);
    EXPECT_THAT(outcome.err, HasSubstr(path));
  }
  EXPECT_FALSE(fs::exists(scratch.path("results.html")));
}

INSTANTIATE_TEST_SUITE_P(
    Program, BadResultsTest,
    ::testing::Values(BadResults{"other_version", "f.attrs['format_version'] = 1",
                                 "format version 1"},
                      BadResults{"missing_table", "del f['runs']", "/runs is missing"},
                      BadResults{"missing_column",
                                 "d = f['runs'][:]\ndel f['runs']\n"
                                 "f['runs'] = d[[n for n in d.dtype.names if n != 'seed']]",
                                 "no field 'seed'"},
                      BadResults{"mixed_studies",
                                 "d = f['runs'][:]\nd['seed'][1] = 7\nd['instance_index'][1] = 0\n"
                                 "f['runs'][:] = d",
                                 "rows 0 and 1 are of different studies"}),
    [](const auto& info) { return std::string(info.param.name); });

struct SeededRow {
  const char* name;
  const char* fault;
  const char* algorithm;
};
std::ostream& operator<<(std::ostream& out, const SeededRow& row) { return out << row.name; }

class SeededFaultTest : public ::testing::TestWithParam<SeededRow> {};

TEST_P(SeededFaultTest, IsHuntedShrunkAndShown) {
  const ScratchDirectory scratch;
  const std::string subject =
      std::string(" --algorithm ") + GetParam().algorithm + " --seeded-fault " + GetParam().fault;
  const std::string big = scratch.path("big"), small = scratch.path("small");
  expect_output(run("{} hunt -n 60" + subject + " -o " + big), "VIOLATED: ", 4);
  expect_exit(4, run("{} verify " + big + ".jsonl --graphs " + big + ".s6"));

  const Outcome shrink = expect_exit(4, run("{} shrink " + big + ".s6" + subject + " -o " + small));
  std::istringstream line(shrink.out);
  unsigned vertices = 0;
  line >> vertices;
  EXPECT_GT(vertices, 0u);
  EXPECT_LE(vertices, 12u) << shrink.out;
  EXPECT_THAT(shrink.out, HasSubstr("none can go"));
  // The first line of the text shows the violation again; without the fault there is none.
  EXPECT_THAT(read_file(small + ".txt"), HasSubstr("ar3d verify " + small + ".jsonl"));
  expect_exit(4, run("{} verify " + small + ".jsonl --graphs " + small + ".s6"));
  expect_exit(
      0, run("{} draw " + small + ".s6 --algorithm " + GetParam().algorithm + " | {} verify -"));
  EXPECT_THAT(read_file(small + ".svg"), HasSubstr("<svg"));
}

INSTANTIATE_TEST_SUITE_P(
    Program, SeededFaultTest,
    ::testing::Values(SeededRow{"wrong_drawing_by_diamond", "wrong-bend", "diamond"},
                      SeededRow{"wrong_drawing_by_grid", "wrong-bend", "grid"},
                      SeededRow{"wrong_drawing_by_two_bend", "wrong-bend", "two-bend"},
                      SeededRow{"passed_bound_by_diamond", "passed-bound", "diamond"},
                      SeededRow{"passed_bound_by_grid", "passed-bound", "grid"},
                      SeededRow{"passed_bound_by_two_bend", "passed-bound", "two-bend"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(HuntProgram, FindsAnExtremeGraphAndShrinkKeepsItSo) {
  const ScratchDirectory scratch;
  const std::string hunt =
      "{} hunt --algorithm diamond --family random-4-regular -n 30 --evaluations 200 --measure z "
      "-o ";
  expect_exit(0, run(hunt + scratch.path("a")));
  expect_exit(0, run(hunt + scratch.path("b")));
  EXPECT_EQ(read_file(scratch.path("a.s6")), read_file(scratch.path("b.s6"))) << "a pure function";
  expect_exit(0, run("{} shrink " + scratch.path("a.s6") +
                     " --algorithm diamond --measure z --ratio 0.1 -o " + scratch.path("c")));
  EXPECT_LT(read_file(scratch.path("c.s6")).size(), read_file(scratch.path("a.s6")).size());
  EXPECT_THAT(read_file(scratch.path("c.txt")), HasSubstr("z is 0."));
}

struct BadCall {
  const char* name;
  std::string command;  // @ stands for a file with two graphs, % for one with a path
  const char* message;
};
std::ostream& operator<<(std::ostream& out, const BadCall& bad) { return out << bad.name; }

class BadCallTest : public ::testing::TestWithParam<BadCall> {};

TEST_P(BadCallTest, OneLineAndExitTwo) {
  const ScratchDirectory scratch;
  const std::string two = scratch.write("two", "Dhc\nDhc\n"), one = scratch.write("one", "Dhc\n");
  std::string command;
  for (const char c : GetParam().command)
    command += c == '@' ? two : c == '%' ? one : std::string(1, c);
  expect_one_line(run(command + " -o " + scratch.path("out")), GetParam().message);
  EXPECT_FALSE(fs::exists(scratch.path("out.s6")));
}

INSTANTIATE_TEST_SUITE_P(
    Program, BadCallTest,
    ::testing::Values(
        BadCall{"hunt_unknown_algorithm", "{} hunt --algorithm unknown", "unknown"},
        BadCall{"hunt_unknown_family", "{} hunt --algorithm diamond --family unknown", "unknown"},
        BadCall{"hunt_unknown_fault", "{} hunt --algorithm diamond --seeded-fault nothing",
                "nothing"},
        BadCall{"hunt_degree", "{} hunt --algorithm grid --family random-4-regular", "degree"},
        BadCall{"hunt_nan", "{} hunt --algorithm diamond --seconds nan", "--seconds"},
        BadCall{"hunt_no_instance_bound",
                "{} hunt --algorithm lattice-109 --family path --bound instance --evaluations 5",
                "no bound for the instance"},
        BadCall{"shrink_two_graphs", "{} shrink @ --algorithm diamond", "a second graph"},
        BadCall{"shrink_nothing_wrong", "{} shrink % --algorithm diamond", "proved right"},
        BadCall{"shrink_ratio", "{} shrink % --algorithm diamond --ratio 0.99", "less than 0.99"},
        BadCall{"shrink_nan", "{} shrink % --algorithm diamond --ratio nan", "--ratio"},
        BadCall{"shrink_missing", "{} shrink /no/such/file --algorithm diamond", "/no/such/file"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace ar3d::testing
