// Programs that draw: what they are asked, and what hostile ones do.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/bench/external/external_drawer.h"
#include "ar3d/bench/run/row_maker.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/examination.h"
#include "bench/in_memory.h"
#include "support/graphs.h"
#include "support/problem.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

// Programs in Python, each a main loop over the graphs that it reads as edge lists.
class Programs : public ::testing::Test {
 protected:
  std::string program(const std::string& name, const std::string& answer) const {
    return scratch_.write(name, R"(import sys, os, json, time, signal
def graphs():
    for header in sys.stdin:
        n, m = map(int, header.split())
        yield n, [tuple(map(int, sys.stdin.readline().split())) for _ in range(m)]
def say(text):
    sys.stdout.write(text); sys.stdout.flush()
served = 0
for n, edges in graphs():
    served += 1
)" + answer);
  }
  StudySpec study(const std::string& path, const std::string& more = "",
                  const std::string& sweep = "", const std::string& algorithms = "'mine'",
                  const std::string& words = "") const {
    return parse_study(fmt::format(R"(study = "t"
[[algorithm]]
name = "mine"
command = ["/usr/bin/python3", "{}"{}]
time_limit_s = 2
{}
[[sweep]]
families = "cycle"
sizes = [5, 6, 7]
algorithms = {}
{}
)",
                                   path, words, more, algorithms, sweep),
                       "t.toml");
  }
  static std::vector<RunRecord> rows(const StudySpec& spec) {
    return run_study(spec, {.workers = 1}).runs;
  }

  ScratchDirectory scratch_;
};

const char* const kRound = R"(
    import math
    p = [[round(math.cos(2*math.pi*i/n), 6), round(math.sin(2*math.pi*i/n), 6), 0] for i in range(n)]
    say(json.dumps({"vertices": p, "seconds": 0.25}) + "\n"))";

TEST_F(Programs, GoodOnesAreMeasured) {
  const std::vector<RunRecord> runs = rows(study(program("round.py", kRound)));
  ASSERT_EQ(runs.size(), 3u);
  for (const RunRecord& run : runs) {
    EXPECT_EQ(run.status, RunStatus::measured) << run.message;
    EXPECT_EQ(run.algorithm, "mine");
    EXPECT_EQ(run.violations, -1);
    EXPECT_EQ(run.cpu_s, 0.25);
    EXPECT_GT(run.wall_s, 0);
    EXPECT_EQ(run.counters, "decimals=6");
    EXPECT_EQ(metric_of(run, "crossings"), 0);
    const double angle = 180 - 360.0 / static_cast<double>(run.n);
    EXPECT_NEAR(metric_of(run, "smallest_vertex_angle"), angle, 1e-3);
    EXPECT_GT(metric_of(run, "log2_relative_volume"), 1);
    if (run.n == 6) continue;  // 120 degrees up to the seventh decimal: decided exactly
    EXPECT_EQ(metric_of(run, "optimal_edges"), run.n == 5 ? 0 : 7);
  }
}

TEST_F(Programs, CoordinatesAreJudgedInARealType) {
  const std::string path = program("round.py", kRound);
  for (const char* type : {"float", "double"}) {
    const auto runs = rows(study(path, fmt::format("coordinates = \"{}\"", type)));
    ASSERT_EQ(runs.size(), 3u);
    for (const RunRecord& run : runs) {
      EXPECT_EQ(run.status, RunStatus::measured) << run.message;
      const auto number = [&](const char* column) { return metric_of(run, column); };
      EXPECT_NEAR(number("angle_miss"), run.n == 5 ? 12 : 0, 1e-3) << "at least 120 are wanted";
      EXPECT_EQ(number("angle_miss") > 1e-8, run.n < 7) << "six decimals miss 120 degrees";
      const double angle = 180 - 360.0 / static_cast<double>(run.n);
      EXPECT_NEAR(number("smallest_vertex_angle"), angle, 1e-3) << "compare judges it";
      EXPECT_TRUE(std::isnan(number("smallest_bend_angle")));
      EXPECT_EQ(number("crossings"), 0);
    }
  }
}

TEST_F(Programs, AreAlgorithms) {
  const StudySpec spec = study(program("step.py", R"(
    say(json.dumps({"vertices": [[i * served, i * i, 0] for i in range(n)]}) + "\n"))"),
                               "guarantee = { max_degree = 2, max_bends = 0, cosine = [1, 1] }");
  const Algorithm& mine = spec.programs.front()->row;
  const auto width = [&] { return bounding_box(draw(mine, cycle(5))).extents()[0]; };
  EXPECT_EQ(width(), 2 * 4) << "the first graph of a process is an edge";
  EXPECT_EQ(width(), 2 * 4) << "each drawing has a process of its own";
  ExternalDrawer one_process;
  EXPECT_FALSE(one_process.take_times());
  EXPECT_EQ(width(), 2 * 4);
  EXPECT_EQ(width(), 3 * 4);
  EXPECT_GT(one_process.take_times().value().wall_s, 0);
  EXPECT_FALSE(one_process.take_times());
  EXPECT_THROW(draw(mine, complete(4)), InputError);
}

TEST_F(Programs, AGuaranteeIsJudged) {
  const std::string path = program("round.py", kRound);
  const std::vector<RunRecord> kept =
      rows(study(path, "guarantee = { max_degree = 2, max_bends = 0, cosine = [-3, 10] }"));
  for (const RunRecord& run : kept) EXPECT_EQ(run.status, RunStatus::ok) << run.message;
  const std::vector<RunRecord> broken =
      rows(study(path, "guarantee = { max_degree = 2, max_bends = 0, cosine = [-1, 2] }"));
  EXPECT_EQ(broken[0].status, RunStatus::violated);  // 108 degrees
  EXPECT_EQ(broken[2].status, RunStatus::ok);
  const std::vector<RunRecord> refused = rows(study(
      path, "guarantee = { max_degree = 1, max_bends = 0, cosine = [0, 1] }",
      "include = { to = 4 }\n[[sweep]]\nfamilies = \"path\"\nsizes = 2\nalgorithms = \"mine\"\n"));
  EXPECT_EQ(refused.size(), 1u) << "cycles are left out, their degree is 2";
}

TEST_F(Programs, OptionsGoIntoTheCommand) {
  const std::string path = program("options.py", R"(
    say(json.dumps({"vertices": [[i * int(sys.argv[1]), i * i, 0] for i in range(n)]}) + "\n"))");
  const StudySpec spec = study(path, "step = [2, 30]", "include = { to = 5 }",
                               "['mine', { algorithm = 'mine', step = 7 }, 'grid']", ", '{step}'");
  std::vector<std::string> told;
  for (const RunRecord& run : rows(spec)) {
    told.push_back(fmt::format("{} {} {}", run.algorithm, run.options, run.extents[0]));
  }
  EXPECT_THAT(told, ElementsAre("mine step=2 8", "mine step=30 120", "mine step=7 28",
                                StartsWith("grid effort=1")));
}

TEST_F(Programs, HostileOnesCostTheirRowsOnly) {
  const struct {
    const char* name;
    const char* answer;
    RunStatus status;
    const char* message;
  } cases[] = {
      {"silent", "\n    time.sleep(1000)", RunStatus::timeout, "no answer within 2 s"},
      {"deaf", "\n    signal.signal(signal.SIGTERM, signal.SIG_IGN)\n    while True: pass",
       RunStatus::timeout, "no answer within 2 s"},
      {"endless", "\n    while True: say('x' * 1000000)", RunStatus::crashed, "answered more than"},
      {"lines", "\n    while True: say('{}\\n' * 1000)", RunStatus::crashed,
       "answered more than one line"},
      {"few", "\n    say('{\"vertices\":[[0,0,0]]}\\n')", RunStatus::crashed,
       "1 vertices are drawn, the graph has"},
      {"nan", "\n    say('{\"vertices\":[[NaN,0,0]]}\\n')", RunStatus::crashed,
       "its answer is no drawing: column"},
      {"exits", "\n    sys.stderr.write('out of ideas\\n'); sys.exit(7)", RunStatus::crashed,
       "ended with code 7 before it answered: out of ideas"},
      {"dies", "\n    os.kill(os.getpid(), signal.SIGSEGV)", RunStatus::crashed,
       "was killed by signal 11"},
      {"forks", "\n    os.fork(); os.fork(); time.sleep(1000)", RunStatus::timeout, "no answer"},
      {"shy", "\n    say('{\"error\":\"too round\"}\\n')", RunStatus::refused, "mine: too round"},
      {"noisy", "\n    sys.stderr.write('y' * 10000000)\n    say('{\"error\":\"noise\"}\\n')",
       RunStatus::refused, "mine: noise"},
  };
  for (const auto& [name, answer, status, message] : cases) {
    const std::vector<RunRecord> runs =
        rows(study(program(std::string(name) + ".py", answer), "", "include = { to = 5 }"));
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(to_string(runs[0].status), std::string(to_string(status))) << name << runs[0].message;
    EXPECT_THAT(runs[0].message, HasSubstr(message)) << name;
  }
  EXPECT_THAT(rows(study("/none.py", "", "include = { to = 5 }"))[0].message,
              HasSubstr("ended with code 2 before it answered"));
}

TEST_F(Programs, ALateSecondLineIsNoAnswerToTheNextGraph) {
  const std::string path = scratch_.write("late.py", R"(import sys, time
for line in sys.stdin:
    print("answer to " + line.strip(), flush=True)
    time.sleep(0.02)
    print("late line", flush=True)
)");
  ExternalProcess process({"/usr/bin/python3", path});
  EXPECT_EQ(process.ask("1\n", 10, 1000).line, "answer to 1");
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  try {
    ADD_FAILURE() << process.ask("2\n", 10, 1000).line;
  } catch (const ProgramFailure& failure) {
    EXPECT_EQ(failure.status(), RunStatus::crashed);
    EXPECT_THAT(failure.what(), HasSubstr("answered more than one line to a graph"));
  }
}

TEST_F(Programs, LateSecondLinesCostRowsOfTheSameSizeToo) {
  const std::string path = program("late.py", std::string(kRound) + R"(
    time.sleep(0.02)
    say(json.dumps({"vertices": [[0, 0, 0]] * n}) + "\n")
)");
  const StudySpec spec =
      study(path, "", "repetitions = 3\ninclude = { to = 5 }", "['mine', 'grid']");
  for (const RunRecord& run : rows(spec)) {
    EXPECT_EQ(to_string(run.status), std::string(run.algorithm == "grid" ? "ok" : "crashed"));
  }
}

TEST_F(Programs, CrossingsThatWereNotCountedHaveAReason) {
  const std::string path = program("round.py", kRound);
  const StudySpec exact = study(path);
  const std::vector<RunRecord> runs =
      rows(parse_study("certificate = \"none\"\n" + exact.text, "t.toml"));
  ASSERT_EQ(runs.size(), 3u);
  for (const RunRecord& run : runs) {
    EXPECT_EQ(run.status, RunStatus::measured);
    EXPECT_TRUE(std::isnan(metric_of(run, "crossings")));
    EXPECT_EQ(run.message, "crossings not counted: certificate = \"none\"");
  }
}

TEST_F(Programs, JudgingTheirDrawingsEndsToo) {
  const std::string path = program("zigzag.py", R"(
    side = lambda i: i % 2 * (10**6 + 3 * i)
    bends = [[side(i) * a - i * b, side(i) * b + i * a, 9 * a + b]  # nine directions, a plane each
             for a in range(1, 4) for b in range(1, 4) for i in range(5000 if n > 2 else 0)]
    drawn = [[u, v, bends if e == 0 else []] for e, (u, v) in enumerate(edges)]
    say(json.dumps({"vertices": [[-i, i * i, 7] for i in range(n)], "edges": drawn}) + "\n"))");
  const std::vector<RunRecord> measured = rows(study(path, "", "include = { to = 5 }"));
  EXPECT_EQ(to_string(measured[0].status), std::string("measured")) << measured[0].message;
  EXPECT_TRUE(std::isnan(metric_of(measured[0], "crossings")));
  EXPECT_THAT(measured[0].message, HasSubstr("crossings not counted: it takes more than "));
  const std::vector<RunRecord> promised =
      rows(study(path, "guarantee = { max_degree = 2, max_bends = 100000, cosine = [1, 1] }",
                 "include = { to = 5 }"));
  EXPECT_EQ(to_string(promised[0].status), std::string("timeout")) << promised[0].message;
  EXPECT_THAT(promised[0].message, HasSubstr("drawn, but not judged: it takes more than "));
}

TEST_F(Programs, AfterAFailureTheNextGraphHasANewProcess) {
  const std::string path =
      program("moody.py", std::string("\n    if n == 6: sys.exit(1)") + kRound);
  const std::vector<RunRecord> runs = rows(study(path));
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[0].status, RunStatus::measured);
  EXPECT_EQ(runs[1].status, RunStatus::crashed);
  EXPECT_EQ(runs[2].status, RunStatus::measured);
}

TEST_F(Programs, MayTakeOneGraphEach) {
  const std::string path = program("one.py", std::string(kRound) + "\n    break\n");
  for (const RunRecord& run : rows(study(path, "one_graph_per_process = true"))) {
    EXPECT_EQ(run.status, RunStatus::measured) << run.message;
  }
  EXPECT_EQ(rows(study(path))[0].status, RunStatus::crashed) << "it ends behind the first edge";
}

TEST_F(Programs, InputIsWhatTheyAskFor) {
  for (const auto& [input, first] : {std::pair("graph6", "\"D\""), std::pair("sparse6", "\":\"")}) {
    const std::string path = scratch_.write(std::string(input) + ".py", fmt::format(R"(import sys
for line in sys.stdin:
    n = 2 if "A" in line[:2] else 5
    if n == 5: assert line[0] == {}, line
    print('{{"vertices":' + str([[i, i * i, 0] for i in range(n)]) + '}}', flush=True)
)",
                                                                                    first));
    const std::vector<RunRecord> runs =
        rows(study(path, fmt::format("input = \"{}\"", input), "include = { to = 5 }"));
    EXPECT_EQ(runs[0].status, RunStatus::measured) << runs[0].message;
  }
}

TEST_F(Programs, BadSpecificationsAreRefusedInOneLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"name = \"diamond\"\ncommand = \"x\"", "is an algorithm of the catalogue"},
      {"name = \"a b\"\ncommand = \"x\"", "is no name"},
      {"name = \"m\"", "lacks 'command'"},
      {"command = \"x\"", "lacks 'name'"},
      {"name = \"m\"\ncommand = []", "command is empty"},
      {"name = \"m\"\ncommand = \"\"", "command is empty"},
      {"name = \"m\"\ncommand = [1]", "command is not a string"},
      {"name = \"m\"\ncommand = \"x {y}\"", "names no option of it"},
      {"name = \"m\"\ncommand = \"x {y\"", "names no option of it"},
      {"name = \"m\"\ncommand = \"x\"\ny = 1", "unknown key 'y'"},
      {"name = \"m\"\ncommand = \"x {y}\"\ny = \"1\"", "y is not an integer"},
      {"name = \"m\"\ncommand = \"x {y}\"\ny = []", "y is empty"},
      {"name = \"m\"\ncommand = \"x\"\ninput = \"dot\"", "none of edgelist"},
      {"name = \"m\"\ncommand = \"x\"\ntime_limit_s = 0", "outside"},
      {"name = \"m\"\ncommand = \"x\"\ntime_limit_s_per_vertex = -1", "outside"},
      {"name = \"m\"\ncommand = \"x\"\none_graph_per_process = 1", "neither true nor false"},
      {"name = \"m\"\ncommand = \"x\"\ncoordinates = \"half\"", "none of float, double"},
      {"name = \"m\"\ncommand = \"x\"\ncoordinates = \"float\"\nguarantee = { max_degree = 3, "
       "max_bends = 1, cosine = [-1, 2] }",
       "keep no guarantee"},
      {"name = \"m\"\ncommand = \"x\"\nguarantee = 3", "guarantee is not a table"},
      {"name = \"m\"\ncommand = \"x\"\nguarantee = { max_degree = 3, max_bends = 1 }",
       "lacks 'cosine'"},
      {"name = \"m\"\ncommand = \"x\"\nguarantee = { max_degree = 3, max_bends = 1, cosine = [2, "
       "1] }",
       "cosine is not"},
      {"name = \"m\"\ncommand = \"x\"\n[[algorithm]]\nname = \"m\"\ncommand = \"x\"",
       "a second algorithm 'm'"},
  };
  for (const auto& [program, message] : cases) {
    const std::string text = fmt::format(
        "study = \"t\"\n[[algorithm]]\n{}\n[[sweep]]\nfamilies = \"cycle\"\nsizes = 5\n"
        "algorithms = \"m\"\n",
        program);
    const std::string told = problem([&] { parse_study(text, "t.toml"); });
    EXPECT_THAT(told, HasSubstr(message)) << program;
    EXPECT_THAT(told, StartsWith("t.toml:")) << program;
  }
  EXPECT_THAT(problem([&] {
                parse_study(
                    "study = \"t\"\n[[algorithm]]\nname = \"mine\"\ncommand = \"x\"\n"
                    "[[sweep]]\nfamilies = \"cycle\"\nsizes = 5\nalgorithms = \"mien\"\n",
                    "t.toml");
              }),
              HasSubstr("unknown algorithm 'mien'; did you mean 'mine'? (known: mine, "));
  EXPECT_THAT(problem([&] { study("x", "", "strong = { threads = [1] }"); }),
              HasSubstr("strong and weak batches are of the catalogue's algorithms only"));
}

}  // namespace
}  // namespace ar3d::testing
