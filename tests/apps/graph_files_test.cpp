// Studies of the graphs of files, as a user runs them.
#include <fmt/format.h>

#include <map>
#include <set>

#include "ar3d/bench/measure/environment.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

class GraphFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* command : {"generate random-cubic -n 40 --count 150",
                                "generate random-4-regular -n 30 --count 60"}) {
      const bool cubic = std::string(command).find("cubic") != std::string::npos;
      must(fmt::format("{{}} {} -o {}", command, path(cubic ? "cubic.s6" : "four.g6")));
    }
  }
  std::string path(const std::string& name) const { return scratch_.path(name); }
  // A study of both files in a folder of its own choice.
  std::string study(const std::string& rest) const {
    return "cd " + scratch_.path("") + " && {} study " + rest;
  }
  std::string both(const std::string& rest) const {
    return study("run -q --graphs cubic.s6 --graphs four.g6 --algorithm diamond --algorithm grid " +
                 rest);
  }
  static std::map<std::string, int> counts(const std::string& results) {
    std::map<std::string, int> counts;
    for (const RunRecord& row : read_results(results).runs) {
      ++counts[fmt::format("{} {} {}", row.family, row.algorithm, to_string(row.status))];
    }
    return counts;
  }
  // Waits until there are rows, then kills the study.
  std::string begun_and_killed(const std::string& command, const std::string& results) const {
    return fmt::format(
        "({} & p=$!; for i in $(seq 500); do [ $(stat -c %s {}.journal 2>/dev/null || echo 0) -gt "
        "60000 ] && break; sleep 0.01; done; pkill -9 -P $p; kill -9 $p; wait $p) 2>/dev/null",
        command, results);
  }

  ScratchDirectory scratch_;
};

TEST_F(GraphFiles, EveryGraphOfEveryFormatIsAnInstance) {
  must("gzip -k " + path("cubic.s6") + " && xz -k " + path("four.g6"));
  const Outcome plain = expect_exit(0, run(both("-o plain.h5")));
  EXPECT_THAT(plain.out, HasSubstr("420 rows, 360 proved, 0 violated, 0 incomplete, 60 refused"));
  EXPECT_THAT(
      counts(path("plain.h5")),
      ElementsAre(std::pair("cubic.s6 diamond ok", 150), std::pair("cubic.s6 grid ok", 150),
                  std::pair("four.g6 diamond ok", 60), std::pair("four.g6 grid refused", 60)));
  for (const RunRecord& row : read_results(path("plain.h5")).runs) {
    if (row.status == RunStatus::refused) {
      EXPECT_THAT(row.message, HasSubstr("vertex 0 has degree 4"));
    }
  }
  const Outcome packed = expect_exit(
      0,
      run(study("run -q --graphs cubic.s6.gz --graphs four.g6.xz --algorithm diamond --algorithm "
                "grid -o packed.h5")));
  const Results a = read_results(path("plain.h5"));
  const Results b = read_results(path("packed.h5"));
  ASSERT_EQ(a.runs.size(), b.runs.size());
  for (std::size_t i = 0; i < a.runs.size(); ++i) {
    EXPECT_EQ(differing_columns(a.runs[i], b.runs[i]), std::vector<std::string>{"family"});
  }
}

TEST_F(GraphFiles, ASpecificationFindsThemBesideItself) {
  fs::create_directory(path("nets"));
  fs::rename(path("cubic.s6"), path("nets/cubic.s6"));
  scratch_.write("s.toml", R"(study = "mine"
[[sweep]]
graphs = ["nets/*.s6", { file = "four.g6", name = "four", sample = 10 }]
families = "cycle"
sizes = 10
algorithms = "diamond"
)");
  expect_exit(0, run("{} study run -q " + path("s.toml") + " -o " + path("s.h5")));
  EXPECT_THAT(counts(path("s.h5")),
              ElementsAre(std::pair("cubic.s6 diamond ok", 150), std::pair("cycle diamond ok", 1),
                          std::pair("four diamond ok", 10)));
  for (const char* verb : {"report", "check"}) {
    expect_exit(0, run(fmt::format("{{}} {} {}", verb, path("s.h5"))));
  }
  expect_exit(0, run("{} compare " + path("s.h5") + " " + path("s.h5")));
  EXPECT_THAT(run("{} study plan " + path("s.toml")).out,
              HasSubstr("3 cells, 161 instances, 161 rows"));
}

TEST_F(GraphFiles, ACollectionOfFilesIsOneFamilyInPlanRowsResumeAndReplay) {
  must(fmt::format("python3 {}/tests/apps/rome_like.py {} 60", AR3D_SOURCE_DIR, path("rome")));
  scratch_.write("rome/notes.txt", "no graph\n");
  const std::string options = "--graphs rome --name rome --algorithm diamond --algorithm grid ";
  expect_one_line(run(study("plan " + options)), "notes.txt:1: ");
  const Outcome plan = expect_exit(0, run(study("plan --skip " + options)));
  EXPECT_THAT(plan.out, AllOf(HasSubstr("rome: 60 graphs, "), HasSubstr(" of degree above 3, "),
                              HasSubstr(", 1 files left out\n  left out: "),
                              HasSubstr("grid (effort=1) on rome n=11..108: 60 rows")));
  must(study("run -q --skip " + options + "-o r.h5"));
  const Results results = read_results(path("r.h5"));
  ASSERT_EQ(results.runs.size(), 120u);
  std::set<std::string> names;
  for (const RunRecord& row : results.runs) {
    EXPECT_EQ(row.family, "rome");
    EXPECT_EQ(row.group, fmt::format("n{}", row.n / 10 * 10));
    EXPECT_EQ(row.status == RunStatus::refused, row.max_degree > (row.algorithm == "grid" ? 3 : 4));
    names.insert(row.graph_name);
  }
  EXPECT_EQ(names.size(), 60u);
  ASSERT_EQ(skipped_file_records(results).size(), 1u);
  EXPECT_EQ(skipped_file_records(results)[0].file, "notes.txt");
  expect_exit(0, run("{} replay --sample 20 " + path("r.h5")));
  fs::rename(path("rome"), path("moved"));
  expect_exit(0, run("{} replay " + path("r.h5") + " 7 --graphs " + path("moved")));
}

TEST_F(GraphFiles, ThreadsWorkersShardsAndRanksMakeTheSameRows) {
  must(both("--threads 1 -o one.h5"));
  must(both("--threads 2 --isolate -o isolated.h5"));
  expect_same_rows(path("one.h5"), path("isolated.h5"));
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    must(both(std::string("--shard ") + shard));
  }
  const Outcome merged = expect_exit(0, run(study("merge ar3d-graphs.shard-*.h5 -o merged.h5")));
  expect_same_rows(path("one.h5"), path("merged.h5"));
  const Outcome ranks =
      expect_exit(0, run("cd " + path("") + " && mpirun --allow-run-as-root --oversubscribe -n 2 " +
                         AR3D_MPI_PROGRAM +
                         " study run -q --graphs cubic.s6 --graphs four.g6 --algorithm diamond "
                         "--algorithm grid -o ranks.h5"));
  expect_same_rows(path("one.h5"), path("ranks.h5"));
}

TEST_F(GraphFiles, AKilledStudyIsResumedFromAnywhereAndAChangedFileIsRefused) {
  must("{} generate random-cubic -n 300 --count 900 -o " + path("many.s6"));
  const std::string options = "run -q --graphs many.s6 --algorithm grid --threads 1 -o ";
  must(study(options + path("whole.h5")));
  run("cd " + path("") + " && " +
      begun_and_killed("{} study " + options + path("cut.h5"), path("cut.h5")));
  ASSERT_TRUE(fs::exists(path("cut.h5.journal")));
  fs::copy_file(path("many.s6"), path("kept"));
  must("{} generate random-cubic -n 300 --count 900 --seed 5 -o " + path("other.s6"));
  fs::copy_file(path("other.s6"), path("many.s6"), fs::copy_options::overwrite_existing);
  expect_one_line(run("{} study resume -q " + path("cut.h5")),
                  "its graphs are not those that the study began with");
  fs::remove(path("many.s6"));
  expect_exit(2, run("{} study resume -q " + path("cut.h5")));
  fs::copy_file(path("kept"), path("many.s6"));
  expect_exit(0, run("{} study resume -q " + path("cut.h5")));
  expect_same_rows(path("whole.h5"), path("cut.h5"));
}

TEST_F(GraphFiles, RowsAreMadeAgainFromTheFileWhereverItIsNow) {
  must(study("run -q --graphs cubic.s6 --shuffle --algorithm compact -o a.h5"));
  const std::string replay = "{} replay " + path("a.h5") + " 77";
  EXPECT_THAT(run(replay).out, HasSubstr("every non-timing column is equal, bit for bit"));
  expect_exit(0, run("{} replay --all " + path("a.h5")));
  fs::rename(path("cubic.s6"), path("moved.s6"));
  expect_exit(2, run(replay));
  expect_exit(0, run(replay + " --graphs " + path("moved.s6") + " -o " + path("d.jsonl")));
  EXPECT_TRUE(fs::exists(path("d.jsonl")));
  expect_error(run(replay + " --graphs " + path("four.g6")),
               "its graphs are not those that the study began with");
}

TEST_F(GraphFiles, AChangedFileIsRefusedOnceByStudyDrawings) {
  must(study("run -q --graphs cubic.s6 --algorithm compact -o a.h5"));
  fs::copy_file(path("four.g6"), path("cubic.s6"), fs::copy_options::overwrite_existing);
  expect_one_line(run("{} replay --keep all " + path("a.h5")),
                  "its graphs are not those that the study began with");
  EXPECT_FALSE(fs::exists(path("a.drawings.jsonl")));
  fs::remove(path("cubic.s6"));
  const Outcome gone = expect_exit(2, run("{} replay --keep all " + path("a.h5")));
  EXPECT_THAT(gone.err, HasSubstr("cannot read " + path("cubic.s6")));
  EXPECT_THAT(gone.err, Not(ContainsRegex("[.]h5:[0-9]"))) << "a line of a text that nobody saw";
}

TEST_F(GraphFiles, AFileUnderAnotherNameIsComparedRowByRow) {
  must(study("run -q --graphs cubic.s6 --algorithm grid -o a.h5"));
  fs::rename(path("cubic.s6"), path("renamed.s6"));
  must(study("run -q --graphs renamed.s6 --algorithm grid -o b.h5"));
  expect_exit(0, run("{} compare --drawings-only " + path("a.h5") + " " + path("b.h5")));
}

TEST_F(GraphFiles, AnyNameOfAFileWillDo) {
  const std::string many(48, 'x');
  for (const std::string& name :
       {std::string(".hid.s6"), std::string("-dash.g6"), std::string("cycle"), many}) {
    const std::string from = name == "-dash.g6" ? "four.g6" : "cubic.s6";
    fs::copy_file(path(from), path(name));
    expect_exit(0, run(study("run -q --force --sample 2 --graphs=" + name +
                             " --algorithm diamond -o a.h5")));
    const std::string family = read_results(path("a.h5")).runs.at(0).family;
    EXPECT_EQ(family, name == many ? name.substr(0, 47) : "_" + name);
  }
  expect_error(run(study("run -q --graphs " + path("") + " --algorithm diamond")),
               "it is a directory");
}

TEST_F(GraphFiles, TheCommandLineSaysHowAnEdgeListIsRead) {
  scratch_.write("h43.edges", "4 3\n0 1\n1 2\n2 3\n");
  scratch_.write("one.edges", "4 3\n1 2\n2 3\n2 4\n");
  const std::string rest = " --algorithm grid -o a.h5 --force --graphs ";
  expect_error(run(study("run -q" + rest + "h43.edges")),
               "--first-line edge or --first-line header says which (in a "
               "study the keys base and first_line)");
  const Outcome from_one = run(study("run -q" + rest + "one.edges"));
  EXPECT_THAT(from_one.err, HasSubstr("--base 1 --first-line header"));
  for (const char* how : {"h43.edges --first-line header", "one.edges --base 1 --first-line header",
                          "one.edges --from edgelist --first-line edge"}) {
    expect_exit(0, run(study("run -q" + rest + how)));
    const bool is_header = std::string(how).find("header") != std::string::npos;
    EXPECT_EQ(read_results(path("a.h5")).runs.at(0).n, is_header ? 4 : 5) << how;
    expect_exit(0, run("{} replay " + path("a.h5") + " 0"));
  }
  expect_exit(2, run(study("run smoke --base 1")));
  const std::string hunt = "{} hunt --algorithm grid --evaluations 3 --graphs " + path("one.edges");
  expect_exit(2, run(hunt));
  expect_exit(0, run(hunt + " --base 1 --first-line header"));
}

TEST_F(GraphFiles, AHuntStartsFromThem) {
  const std::string hunt = "{} hunt --evaluations 60 --graphs ";
  expect_output(run(hunt + path("cubic.s6") + " --algorithm diamond"),
                "the best one comes from " + path("cubic.s6") + " graph ");
  expect_error(run(hunt + path("four.g6") + " --algorithm grid"),
               "no graph has maximum degree 3 or less, as grid needs");
  expect_exit(2, run(hunt + path("cubic.s6") + " --algorithm grid --family cycle"));
}

TEST_F(GraphFiles, CallgrindCountsTheirDrawings) {
  if (std::string(build_kind()) == "sanitised") GTEST_SKIP() << "valgrind cannot run it";
  must(study("run -q --graphs cubic.s6 --sample 2 --algorithm grid -o a.h5"));
  expect_exit(0, run("{} study count " + path("a.h5") + " -o " + path("c.h5")));
  for (const RunRecord& row : read_results(path("c.h5")).runs)
    EXPECT_GT(row.counted_instructions, 1000);
}

TEST_F(GraphFiles, BadCommandsSayWhy) {
  const std::pair<const char*, const char*> cases[] = {
      {"run", "either STUDY or --graphs"},
      {"run smoke --graphs cubic.s6", "either STUDY or --graphs"},
      {"run smoke --algorithm diamond", "--algorithm requires --graphs"},
      {"run --graphs none.s6", "cannot read"},
      {"run --graphs 'none*.s6'", "no file matches 'none*.s6'"},
      {"run --graphs cubic.s6 --algorithm dimond", "--graphs: unknown algorithm 'dimond'"},
      {"run --graphs cubic.s6 --from s7", "--graphs: unknown graph format 's7'"},
      {"run --graphs cubic.s6 --base 2", "--base: '2' is not a whole number from 0 to 1"},
      {"run --graphs cubic.s6 --first-line x", "--first-line: 'x' is"},
      {"run --graphs cubic.s6 --sample 0", "not a whole number"},
      {"run --graphs cubic.s6 -o cubic.s6", "cubic.s6"},
      {"plan --graphs 'a\"b'", "cannot read"},
  };
  for (const auto& [command, message] : cases) {
    expect_one_line(run(study(command)), message);
  }
}

}  // namespace
}  // namespace ar3d::testing
