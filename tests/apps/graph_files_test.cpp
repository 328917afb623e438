// Studies of the graphs of files, as a user runs them.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
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
  ASSERT_EQ(side_records<SkippedFile>(results).size(), 1u);
  EXPECT_EQ(side_records<SkippedFile>(results)[0].file, "notes.txt");
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

TEST_F(GraphFiles, AKilledStudyIsResumedWithoutItsFile) {
  must("{} generate random-cubic -n 300 --count 900 -o " + path("many.s6"));
  const std::string options = "run -q --graphs many.s6 --algorithm grid --threads 1 -o ";
  must(study(options + path("whole.h5")));
  run("cd " + path("") + " && " +
      begun_and_killed("{} study " + options + path("cut.h5"), path("cut.h5")));
  ASSERT_TRUE(fs::exists(path("cut.h5.journal")));
  fs::remove(path("many.s6"));
  expect_exit(0, run("{} study resume -q " + path("cut.h5")));
  expect_same_rows(path("whole.h5"), path("cut.h5"));
}

TEST_F(GraphFiles, RowsAreMadeAgainWithoutTheFileOrFromAnother) {
  must(study("run -q --graphs cubic.s6 --shuffle --algorithm compact -o a.h5"));
  const std::string replay = "{} replay " + path("a.h5") + " 77";
  fs::rename(path("cubic.s6"), path("moved.s6"));
  EXPECT_THAT(run(replay).out, HasSubstr("every non-timing column is equal, bit for bit"));
  expect_exit(0, run("{} replay --all " + path("a.h5")));
  expect_exit(0, run(replay + " --graphs " + path("moved.s6") + " -o " + path("d.jsonl")));
  EXPECT_TRUE(fs::exists(path("d.jsonl")));
  expect_error(run(replay + " --graphs " + path("four.g6")),
               "its graphs are not those that the study began with");
}

// Beyond `graphs_bytes` the results hold no graphs: the files have to be as they were.
TEST_F(GraphFiles, AChangedFileThatIsNotHeldIsRefusedAndNamed) {
  scratch_.write("s.toml", R"(study = "mine"
graphs_bytes = 100
[[sweep]]
graphs = { files = "*.?6", name = "nets" }
algorithms = "diamond"
)");
  must(study("run -q s.toml -o a.h5"));
  fs::copy_file(path("four.g6"), path("cubic.s6"), fs::copy_options::overwrite_existing);
  for (const char* verb : {"replay --keep all ", "study resume "}) {
    expect_one_line(run(fmt::format("{{}} {}{}", verb, path("a.h5"))),
                    "; 1 file is gone or changed, cubic.s6 is the first)");
  }
  EXPECT_FALSE(fs::exists(path("a.drawings.jsonl")));
}

class LivingCollection : public GraphFiles {
 protected:
  void SetUp() override {
    for (const char* folder : {"coll", "coll/C2", "coll/C10", "coll/δελτα"}) {
      fs::create_directory(path(folder));
    }
    make("cycle -n 5", "C2/größe.s6");
    make("cycle -n 6", "C10/six.g6");
    make("cycle -n 7", "δελτα/seven.gml");
    make("petersen", "top.dot");
    scratch_.write("coll/C2/weighted.edgelist", "0 1 0.5\n1 2 3\n");
    scratch_.write("coll/C2/notes.txt", "no graph\n");
  }
  void make(const std::string& family, const std::string& file) const {
    must(fmt::format("{{}} generate {} -o {}", family, path("coll/" + file)));
  }
  /// "group/graph_name" of every row.
  std::set<std::string> rows() const {
    std::set<std::string> found;
    for (const RunRecord& row : read_results(path("r.h5")).runs) {
      EXPECT_EQ(row.status, RunStatus::ok) << row.message;
      found.insert(row.group + "/" + row.graph_name);
    }
    return found;
  }
};

TEST_F(LivingCollection, GrowsAndKeepsWhatIsGone) {
  expect_output(run(study("run -q --graphs coll --skip --algorithm diamond -o r.h5")),
                {"5 rows, 5 proved", "files    5 of 6 were read"});
  const std::set<std::string> begun = {"C2/größe.s6", "C10/six.g6", "δελτα/seven.gml", "./top.dot",
                                       "C2/weighted.edgelist"};
  EXPECT_EQ(rows(), begun);
  const Results before = read_results(path("r.h5"));
  make("cycle -n 9", "C10/nine.s6");
  make("cycle -n 8", "C10/six.g6 --force");
  fs::remove(path("coll/top.dot"));
  const Outcome resumed = expect_exit(0, run(study("resume -q r.h5")));
  EXPECT_THAT(resumed.err, AllOf(HasSubstr("coll: 1 file new, to be drawn: C10/nine.s6"),
                                 HasSubstr("1 file changed, to be drawn beside the rows that are "
                                           "there: C10/six.g6"),
                                 HasSubstr("1 file gone, whose rows and graphs stay in the "
                                           "results: top.dot")));
  const Results after = read_results(path("r.h5"));
  ASSERT_EQ(after.runs.size(), 7u);
  std::map<std::string, RunRecord> by_key;
  for (const RunRecord& row : after.runs) by_key[row.row_key] = row;
  for (const RunRecord& row : before.runs) {
    EXPECT_EQ(differing_columns(row, by_key.at(row.row_key)), std::vector<std::string>());
    EXPECT_EQ(row.wall_s, by_key.at(row.row_key).wall_s) << "it is kept, not made again";
  }
  fs::remove_all(path("coll"));
  expect_output(run(study("resume -q r.h5")), "7 rows, 7 proved");
  for (const RunRecord& row : after.runs) {  // the graphs of the results are enough
    const std::string of_row = path("r.h5 ") + row.row_key + " --evaluations 1 --json";
    const auto hunted = nlohmann::json::parse(run("{} hunt -q " + of_row).out);
    EXPECT_EQ(hunted.at("n"), row.n);
    EXPECT_EQ(hunted.at("extents")[0], row.extents[0]);
  }
  expect_output(run("{} shrink " + path("r.h5 0 --measure x --ratio 0.01 -o ") + path("small")),
                "none can go");
  expect_error(run("{} hunt " + path("r.h5 7")), "no row '7'; rows are 0..6 or row keys");
  expect_output(run("{} replay --all " + path("r.h5")), "7 of 7 rows made again: 7 equal");
  expect_output(run("{} replay --keep all " + path("r.h5")), "");
  expect_exit(0, run("{} verify " + path("r.drawings.jsonl")));
}

TEST_F(LivingCollection, ItsOwnFilesAreNoGraphs) {
  must(study("run -q --graphs coll --skip --algorithm diamond -o coll/r.h5"));
  for (const char* again : {"resume coll/r.h5", "run --force --graphs coll --skip -o coll/r.h5"}) {
    const Outcome outcome = expect_exit(0, run(study(again)));
    EXPECT_THAT(outcome.out, HasSubstr("files    5 of 6 were read")) << again;
    EXPECT_THAT(outcome.err, Not(HasSubstr(" new"))) << again;
  }
  must("{} replay --keep all " + path("coll/r.h5"));
  must("{} replay --keep all --force " + path("coll/r.h5"));
  expect_output(run(study("resume coll/r.h5")), "files    5 of 6 were read");
  EXPECT_EQ(fs::exists(path("coll/r.drawings.jsonl")), true);
}

TEST_F(LivingCollection, WhatWasLeftOutIsSaidEverywhere) {
  must(study("run -q --graphs coll --skip --algorithm diamond -o r.h5"));
  for (const char* verb : {"check", "study status"}) {
    expect_output(run(fmt::format("{{}} {} {}", verb, path("r.h5"))), "files    5 of 6 were read");
  }
  const auto json = nlohmann::json::parse(run("{} check --json " + path("r.h5")).out);
  EXPECT_EQ(json["files_given"], 6);
  EXPECT_EQ(json["skipped_files"][0]["file"], "C2/notes.txt");
  EXPECT_THAT(json["skipped_files"][0]["reason"].get<std::string>(),
              AllOf(StartsWith("C2/notes.txt:1"), Not(HasSubstr(path("")))));
  must("{} report " + path("r.h5") + " -o " + path("r.html") + " --rows " + path("rows.csv") +
       " --json " + path("r.json"));
  const auto tables = nlohmann::json::parse(read_file(path("r.json")))["tables"];
  EXPECT_EQ(tables["study"]["rows"][0].back(), 6);
  EXPECT_EQ(tables["skipped_files"]["rows"].size(), 1u);
  EXPECT_THAT(read_file(path("rows.csv")),
              AllOf(StartsWith("row,key,algorithm,options,family,parameters,graph_name,group,"),
                    HasSubstr(",größe.s6,C2,")));
}

TEST_F(GraphFiles, AFileUnderAnotherNameIsComparedRowByRow) {
  must(study("run -q --graphs cubic.s6 --algorithm grid -o a.h5"));
  fs::rename(path("cubic.s6"), path("renamed.s6"));
  must(study("run -q --graphs renamed.s6 --algorithm grid -o b.h5"));
  expect_exit(0, run("{} compare --drawings-only " + path("a.h5") + " " + path("b.h5")));
}

TEST_F(GraphFiles, AreTimedIfAsked) {
  expect_output(run(study("run -q --graphs cubic.s6 four.g6 --sample 3 --algorithm diamond --timed "
                          "2 --threads 1 --force-timing -o a.h5")),
                "18 rows, 18 proved");
  expect_output(run(study("run --graphs cubic.s6 --sample 3 --algorithm diamond -o b.h5")),
                "times    not measured: --timed N does");
}

TEST_F(GraphFiles, FormatsOfOthersAreConvertedOrRefusedByName) {
  must(
      "/usr/bin/python3 -c \"import networkx as n; g = n.petersen_graph(); d = n.DiGraph(g); "
      "n.write_gexf(g, '" +
      path("p.gexf") + "'); n.write_pajek(g, '" + path("p.net") + "'); n.write_gml(d, '" +
      path("p.gml") + "'); n.write_graphml(d, '" + path("p.graphml") + "')\"");
  for (const char* file : {"p.gexf", "p.net"}) {
    expect_one_line(run("{} draw " + path(file)), "examples/convert.py makes GraphML of it");
    must(fmt::format("/usr/bin/python3 {}/examples/convert.py {} {}", AR3D_SOURCE_DIR, path(file),
                     path("converted.graphml")));
    expect_output(run("{} draw " + path("converted.graphml") + " | {} verify -"), "1 certified");
  }
  for (const char* file : {"p.gml", "p.graphml"}) {
    expect_one_line(run("{} draw " + path(file)), "(--undirected drops directions)");
    expect_output(run("{} draw --undirected --level extents " + path(file)), "\"n\":10,\"m\":15,");
  }
  expect_output(run("echo 'digraph { a -> b -> a; b -> c }' | {} draw - --undirected --level "
                    "extents"),
                "\"n\":3,\"m\":2,");
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
  scratch_.write("notes.txt", "no graph\n");
  expect_output(run(study("run -q --graphs " + path("") + " --skip --algorithm diamond -o b.h5")),
                "files ");
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
                          "one.edges --from edgelist --base 0 --first-line edge"}) {
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

TEST_F(GraphFiles, CallgrindCountsTheirDrawingsAtOnceOrLater) {
  if (std::string(build_kind()) == "sanitised") GTEST_SKIP() << "valgrind cannot run it";
  const std::string command = "run --graphs cubic.s6 --sample 2 --algorithm grid ";
  expect_output(run(study(command + "--count -o a.h5")),
                {"2 rows, 2 proved", "counted  2 drawings"});
  must(study(command + "-q -o b.h5"));
  expect_exit(0, run("{} study count " + path("b.h5") + " -o " + path("c.h5")));
  for (const char* counted : {"a.h5", "c.h5"}) {
    for (const RunRecord& row : read_results(path(counted)).runs)
      EXPECT_GT(row.counted_instructions, 1000);
  }
}

TEST_F(GraphFiles, BadCommandsSayWhy) {
  const std::pair<const char*, const char*> cases[] = {
      {"run", "either STUDY or --graphs"},
      {"run --graphs cubic.s6 four.g6 --name x", "a pattern in quotes, or a folder, is one"},
      {"run --graphs cubic.s6 -o out.csv", "this file is written as .h5, not as .csv"},
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
  for (const auto& [command, message] : cases) expect_one_line(run(study(command)), message);
}

}  // namespace
}  // namespace ar3d::testing
