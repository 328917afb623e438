// Studies with programs of others as algorithms: those of examples/peers, and hostile ones.
#include <fmt/format.h>

#include <map>

#include "support/program.h"
#include "support/results.h"
#include "support/tables.h"

namespace ar3d::testing {
namespace {

TEST(Peers, AreMeasuredBesideOurs) {
  const ScratchDirectory scratch;
  const std::string folder = AR3D_SOURCE_DIR "/examples/peers/";
  const std::string spec = scratch.write("p.toml", fmt::format(R"(study = "p"
[[algorithm]]
name = "neato"
command = ["{0}graphviz.py", "neato"]
[[algorithm]]
name = "sfdp"
command = ["{0}graphviz.py", "sfdp"]
[[algorithm]]
name = "fr"
command = ["{0}igraph3d.py", "fr", "{{iterations}}"]
iterations = [5, 50]
[[algorithm]]
name = "kk"
command = ["{0}igraph3d.py", "kk", "{{iterations}}"]
iterations = 50
[[sweep]]
families = ["random-cubic", "cycle"]
sizes = 16
algorithms = ["grid", "neato", "sfdp", "fr", "kk"]
)",
                                                               folder));
  const std::string results = scratch.path("p.h5");
  expect_output(run("{} study run -q --threads 1 " + spec + " -o " + results),
                "PASS: 12 rows, 2 proved, 0 violated, 0 incomplete, 0 refused, "
                "10 measured without a guarantee");
  for (const RunRecord& row : read_results(results).runs) {
    const bool ours = row.algorithm == "grid";
    EXPECT_EQ(to_string(row.status), std::string(ours ? "ok" : "measured")) << row.message;
    EXPECT_GE(metric_of(row, "crossings"), 0);
    EXPECT_GT(metric_of(row, "smallest_vertex_angle"), ours ? 119.99 : 0);
    EXPECT_GT(metric_of(row, "log2_relative_volume"), 0);
  }
  const Outcome table = expect_exit(0, run(folder + "table.py " + results));
  EXPECT_THAT(table.out, HasSubstr("| random-cubic | 16 | grid | 120.0 | 100 % | 0 |"));
  EXPECT_THAT(table.out, HasSubstr("| fr (iterations=50) |"));
  for (const char* bad : {" many", "none"}) {
    const Outcome refused = expect_exit(1, run(folder + "table.py " + results + bad));
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
  expect_exit(0, run("{} report " + results + " -o " + scratch.path("p.html")));
  const auto tables = tables_in(read_file(scratch.path("p.html")));
  EXPECT_GT(tables["verdict"][0]["measured"], 0);
  EXPECT_GE(tables["groups"][0]["settings"], 2) << "side by side";
  EXPECT_EQ(tables["groups"][0]["unit"], "cubes of the smallest vertex distance");
}

// Time after time the same study of good and hostile programs, in threads, in workers and killed.
TEST(HostilePrograms, NeverStopOrCorruptAStudy) {
  const ScratchDirectory scratch;
  const auto program = [&](const std::string& name, const std::string& body) {
    scratch.write(name + ".py", R"(import sys, os, time
while True:
    n, m = map(int, sys.stdin.readline().split())
    for _ in range(m): sys.stdin.readline()
    )" + body + "\n");
    return fmt::format(
        "[[algorithm]]\nname = \"{0}\"\ncommand = [\"/usr/bin/python3\", \"{1}\"]\n"
        "time_limit_s = 1\n",
        name, scratch.path(name + ".py"));
  };
  const std::string good =
      "print('{\"vertices\":' + str([[i, i * i, i ** 3] for i in range(n)]) + '}', flush=True)";
  const std::string spec = scratch.write(
      "h.toml",
      "study = \"h\"\n" + program("good", good) + program("silent", "time.sleep(1000)") +
          program("flood",
                  "os.write(1, b'x' * 10000000)\n    while True: os.write(1, b'x' * 10000000)") +
          program("forker", "os.fork(); os.fork(); time.sleep(1000)") +
          program("leaver", "if os.fork() == 0: os.setsid(); os.fork()\n    time.sleep(1000)") +
          program("quitter", "sys.exit(3)") +
          program("moody", "if n == 7: os.abort()\n    " + good) +
          "[[sweep]]\nfamilies = \"cycle\"\nsizes = [6, 7]\nalgorithms = [\"grid\", \"good\", "
          "\"silent\", \"flood\", \"forker\", \"leaver\", \"quitter\", \"moody\"]\n");
  for (const char* how : {"--threads 1", "--threads 2", "--threads 2 --isolate"}) {
    const std::string results = scratch.path("h.h5");
    expect_exit(5, run(fmt::format("{{}} study run -q --force {} {} -o {}", how, spec, results)));
    std::map<std::string, std::string> told;
    for (const RunRecord& row : read_results(results).runs) {
      told[fmt::format("{} {}", row.algorithm, row.n)] = to_string(row.status);
    }
    EXPECT_THAT(told,
                ElementsAre(std::pair("flood 6", "crashed"), std::pair("flood 7", "crashed"),
                            std::pair("forker 6", "timeout"), std::pair("forker 7", "timeout"),
                            std::pair("good 6", "measured"), std::pair("good 7", "measured"),
                            std::pair("grid 6", "ok"), std::pair("grid 7", "ok"),
                            std::pair("leaver 6", "timeout"), std::pair("leaver 7", "timeout"),
                            std::pair("moody 6", "measured"), std::pair("moody 7", "crashed"),
                            std::pair("quitter 6", "crashed"), std::pair("quitter 7", "crashed"),
                            std::pair("silent 6", "timeout"), std::pair("silent 7", "timeout")))
        << how;
  }
  EXPECT_EQ(run("pgrep -f '^/usr/bin/python3 " + scratch.path("") + "'").out, "")
      << "nothing of them is left";
}

/// A program that draws, in a study of four rows.
class OwnProgram : public ::testing::Test {
 protected:
  static constexpr const char* kBody = R"(import sys
while True:
    n, m = map(int, sys.stdin.readline().split())
    for _ in range(m): sys.stdin.readline()
    print('{"vertices":' + str([[i, i * i, i ** 3] for i in range(n)]) + '}', flush=True)
)";
  static constexpr const char* kGuarantee =
      "guarantee = { max_degree = 4, max_bends = 0, cosine = [1, 1] }\n";
  /// @param more  further lines of the program's entry.
  std::string spec(const std::string& command = "", const std::string& more = "") const {
    return scratch_.write(
        "s.toml",
        "study = \"s\"\n[[algorithm]]\nname = \"mine\"\ncommand = [" +
            (command.empty() ? "\"/usr/bin/python3\", \"" + path("mine.py") + "\"" : command) +
            "]\n" + more +
            "[[sweep]]\nfamilies = \"cycle\"\nsizes = [5, 6, 7, 8]\nalgorithms = \"mine\"\n");
  }
  std::string path(const std::string& name) const { return scratch_.path(name); }

  ScratchDirectory scratch_;
};

TEST_F(OwnProgram, ShardsOfDifferentVersionsAreNotMerged) {
  for (const char* shard : {"1", "2"}) {
    scratch_.write("mine.py", std::string(kBody) + "# version " + shard + "\n");
    const std::string part = path(std::string(shard) + ".h5");
    expect_exit(
        0, run("{} study run -q --threads 1 " + spec() + " --shard " + shard + "/2 -o " + part));
  }
  const std::string merge = "{} study merge " + path("1.h5") + " " + path("2.h5") + " -o ";
  expect_one_line(run(merge + path("m.h5")), "the shards were made with different programs 'mine'");
  expect_exit(
      0, run("{} study run -q --force --threads 1 " + spec() + " --shard 1/2 -o " + path("1.h5")));
  expect_exit(0, run(merge + path("m.h5")));
  EXPECT_EQ(read_results(path("m.h5")).runs.size(), 4u);
}

TEST_F(OwnProgram, ReplayRefusesAnotherProgram) {
  scratch_.write("mine.py", kBody);
  expect_exit(0, run("{} study run -q --threads 1 " + spec() + " -o " + path("s.h5")));
  const std::string replay = "{} replay " + path("s.h5") + " 1";
  expect_exit(0, run(replay));
  scratch_.write("mine.py", std::string(kBody) + "# another\n");
  expect_one_line(run(replay), "program 'mine' is not the one that rows of");
}

// Nothing was asked of it but drawings, and these are there: no failure, and no proof.
TEST_F(OwnProgram, WithoutAGuaranteeItsRowsAreMeasured) {
  scratch_.write("mine.py", kBody);
  const std::string study = "{} study run -q --force --threads 1 " + spec() + " -o " + path("s.h5");
  const std::string verdict =
      "MEASURED: 4 rows, 0 proved, 0 violated, 0 incomplete, 0 refused, "
      "4 measured without a guarantee\n";
  expect_output(run(study), verdict);
  expect_output(run("{} check " + path("s.h5")), verdict);
  scratch_.write("mine.py", "import sys; sys.exit(3)\n");
  expect_output(run(study), "INCOMPLETE: 4 rows", 5);
}

/// Vertex v of the cycle stands at (v, v * v % modulus, v * v * v): with a small modulus edges
/// cross.
std::string body_with(const std::string& y) {
  return R"(import sys
while True:
    n, m = map(int, sys.stdin.readline().split())
    for _ in range(m): sys.stdin.readline()
    print('{"vertices":' + str([[v, )" +
         y + R"(, 0] for v in range(n)]) + '}', flush=True)
)";
}

TEST_F(OwnProgram, CommandsOfItsRowsNeedTheResults) {
  scratch_.write("mine.py", body_with("0"));
  const std::string results = path("r.h5");
  expect_exit(4, run("{} study run -q --threads 1 " + spec("", kGuarantee) + " -o " + results));
  const Outcome check = run("{} check " + results);
  const std::size_t at = check.out.find("    ar3d replay " + results + " ");
  ASSERT_NE(at, std::string::npos) << check.out;
  const std::string command = check.out.substr(at + 9, check.out.find('\n', at) - at - 9);
  expect_exit(4, run("cd " + path("") + " && {} " + command + " -o d.jsonl"));
  EXPECT_THAT(read_file(path("d.jsonl")), HasSubstr("[[0,0,0],[1,0,0],"));
}

TEST_F(OwnProgram, CompareJudgesWhatIsMeasuredAndNamesItsVersions) {
  const auto made = [&](const std::string& body, const std::string& version) {
    scratch_.write("mine.py", body);
    const std::string study = spec("", "version = \"" + version + "\"\n");
    expect_exit(0, run("{} study run -q --threads 1 " + study + " -o " + path(version + ".h5")));
    return path(version + ".h5");
  };
  const std::string good = made(body_with("v * v"), "v1");
  const std::string same = made(body_with("v * v") + "# faster\n", "v2");
  const std::string flat = made(body_with("100 * v * v"), "v3");
  const std::string crossed = made(body_with("(7 * v) % 5"), "v4");
  const std::string compare = "{} compare --drawings-only " + good + " ";
  expect_output(run(compare + same), {"DRAWINGS PASS", "mine: version v1 in BASE, v2 in NEW"});
  expect_output(run(compare + flat), {"REGRESSED", "smallest angle at a vertex: "}, 3);
  expect_output(run(compare + crossed), {"REGRESSED", "crossings: 0 became "}, 3);
  const std::string gate = "AR3D=$(realpath {}) && cd " + path("") +
                           " && AR3D=$AR3D AR3D_STUDY=" + path("s.toml") +
                           " " AR3D_SOURCE_DIR "/examples/ci/regression-gate ";
  scratch_.write("mine.py", body_with("v * v"));
  expect_exit(0, run(gate + "store references"));
  expect_exit(0, run(gate + "judge references"));
  scratch_.write("mine.py", body_with("(7 * v) % 5"));
  expect_exit(3, run(gate + "judge references"));
}

// In the program's own repository, as docs/own-program.md prints it.
TEST_F(OwnProgram, HistoryAndBisectionGoByItsCommits) {
  const std::string git = "git -c user.name=n -c user.email=e ";
  must("cd " + path("") +
       " && git init -q && echo '*.h5*' > .gitignore && echo '*.html' >> "
       ".gitignore && echo ar3d-history >> .gitignore && git add .gitignore");
  scratch_.write("own.toml", read_file(spec()));
  for (const char* y : {"v * v", "v * v + 1", "(7 * v) % 5", "(7 * v) % 5 + 1"}) {
    scratch_.write("mine.py", body_with(y));
    must("cd " + path("") + " && git add mine.py own.toml s.toml && " + git + "commit -qm '" + y +
         "' && {} study run own.toml -q --force -o now.h5 && {} history add now.h5");
  }
  const std::string enter = "cd " + path("") + " && PATH=$(dirname $(realpath {})):$PATH && ";
  const std::string first = run(enter + "git rev-parse HEAD~3").out.substr(0, 12);
  expect_output(run(enter + "ls ar3d-history"), "000001_" + first + "_s_");
  const Outcome report = run(enter + "ar3d history report");
  expect_output(report, "crossings: 4 of 4 lines judged");
  EXPECT_THAT(report.out, HasSubstr(run(enter + "git rev-parse HEAD~1").out.substr(0, 12)));

  const std::string page = read_file(AR3D_SOURCE_DIR "/docs/own-program.md");
  const std::size_t begin = page.find("git bisect run ");
  ASSERT_NE(begin, std::string::npos);
  const std::string printed = page.substr(begin, page.find('\n', begin) - begin);
  must(enter +
       "git checkout -q HEAD~3 && ar3d study run own.toml -q --force -o good.h5 && "
       "git checkout -q - && git bisect start HEAD HEAD~3");
  expect_output(run(enter + printed), "is the first bad commit");
  EXPECT_THAT(run(enter + "git show -s --format=%s refs/bisect/bad").out,
              HasSubstr("(7 * v) % 5\n"));
}

TEST_F(OwnProgram, NobodyKnowsBeforeWhatItCosts) {
  scratch_.write("mine.py", kBody);
  const Outcome plan = expect_exit(0, run("{} study plan " + spec()));
  EXPECT_THAT(plan.out,
              HasSubstr("mine on cycle n=5: 1 instances, 1 rows, time and memory not known\n"));
  EXPECT_THAT(plan.out, HasSubstr("4 rows\nits time and memory are not known\n"));
  const std::string text = read_file(spec());
  const std::string both = scratch_.write(
      "both.toml", text.substr(0, text.rfind("algorithms")) + "algorithms = [\"mine\", \"grid\"]");
  EXPECT_THAT(run("{} study plan " + both).out,
              HasSubstr("for the largest row; of 4 rows time and memory are not known\n"));
}

// Wrong wherever there is a triangle: its vertices are put on one line.
TEST_F(OwnProgram, AWrongDrawingIsHuntedAndShrunk) {
  scratch_.write("mine.py", R"(import sys
while True:
    n, m = map(int, sys.stdin.readline().split())
    edges = [tuple(map(int, sys.stdin.readline().split())) for _ in range(m)]
    near = [set() for _ in range(n)]
    for u, v in edges: near[u].add(v), near[v].add(u)
    at = [[i, i * i, i ** 3] for i in range(n)]
    for u, v in edges:
        for w in near[u] & near[v]: at[u], at[v], at[w] = [-1, 0, 0], [-2, 0, 0], [-3, 0, 0]
    print('{"vertices":' + str(at) + '}', flush=True)
)");
  const std::string of = " --algorithm mine --study " + spec("", kGuarantee);
  const Outcome hunt =
      run("{} hunt --family random-4-regular -n 20 --evaluations 50" + of + " -o " + path("found"));
  expect_output(hunt, "VIOLATED: ", 4);
  expect_output(run("{} shrink " + path("found.s6") + of + " -o " + path("least")), "; none can go",
                4);
  expect_output(run("cd " + path("") + " && $(sed -n 's|^ar3d |{} |p' least.txt)"), "VIOLATED", 4);
}

TEST_F(OwnProgram, AGuaranteePromisesNoBox) {
  scratch_.write("mine.py", kBody);
  expect_exit(0,
              run("{} study run -q --threads 1 " + spec("", kGuarantee) + " -o " + path("s.h5")));
  for (const RunRecord& row : read_results(path("s.h5")).runs) {
    EXPECT_EQ(row.status, RunStatus::ok) << row.message;
  }
  must("{} report " + path("s.h5") + " -o " + path("s.html"));
  const auto tables = tables_in(read_file(path("s.html")));
  for (const auto& setting : tables["settings"]) {
    EXPECT_EQ(setting["theorem"], "");
  }
}

TEST_F(OwnProgram, AnExecutableThatIsNotThereIsRefusedAtTheStart) {
  expect_one_line(run("{} study run " + spec("\"./x --a\"")),
                  "words are a list: command = [\"./x\"");
  for (const char* command : {"\"/nonexistent/x\"", "\"no-such-drawer-anywhere\""}) {
    expect_one_line(run("{} study plan " + spec(command)), "program 'mine' cannot be run: ");
    expect_one_line(run("{} study run -q " + spec(command) + " -o " + path("s.h5")),
                    "program 'mine' cannot be run: ");
    EXPECT_EQ(run("ls " + path("s.h5") + "*").out, "");
  }
}

TEST_F(OwnProgram, ThatChangedSinceRowsWereMadeIsRefused) {
  scratch_.write("mine.py", kBody);
  expect_exit(0, run("{} study run -q --threads 1 " + spec() + " -o " + path("s.h5")));
  const std::string resume = "{} study resume -q " + path("s.h5") + " --again crashed";
  expect_exit(0, run(resume));
  scratch_.write("mine.py", std::string(kBody) + "# another one\n");
  expect_error(run(resume), "program 'mine' is not the one that rows of");
  scratch_.write("mine.py", kBody);  // the former one
  expect_exit(0, run(resume));
  EXPECT_EQ(read_results(path("s.h5")).runs.size(), 4u);
}

}  // namespace
}  // namespace ar3d::testing
