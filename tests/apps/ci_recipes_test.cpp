// The recipes of examples/ci as far as a shell can run them.
#include "ar3d/store/rows.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

constexpr const char* kFolder = AR3D_SOURCE_DIR "/examples/ci/";

/// The gate in a folder of its own, with a small study.
Outcome gate(const ScratchDirectory& scratch, const std::string& arguments) {
  const std::string spec = scratch.write(
      "tiny.toml",
      "study = 'tiny'\n[[sweep]]\nfamilies = 'cycle'\nsizes = 20\nalgorithms = 'all'\n");
  return run("AR3D=$(realpath {}) && cd " + scratch.path("") + " && AR3D=$AR3D AR3D_STUDY=" + spec +
             " " + kFolder + "regression-gate " + arguments);
}

TEST(CiRecipes, TheGateStoresJudgesAndFailsByItsExitCode) {
  const ScratchDirectory scratch;
  expect_exit(5, gate(scratch, "judge references"));
  EXPECT_THAT(read_file(scratch.path("verdict.markdown")), HasSubstr("NOTHING TO COMPARE WITH"));
  expect_exit(0, gate(scratch, "store references"));
  expect_exit(0, gate(scratch, "judge references"));
  EXPECT_THAT(read_file(scratch.path("verdict.markdown")),
              HasSubstr("## ar3d compare: DRAWINGS PASS"));

  const std::string reference = scratch.path("references/reference.h5");
  Results smaller = read_results(reference);
  smaller.runs.front().extents[0] -= 1;
  write_results(smaller, reference);
  expect_exit(3, gate(scratch, "judge references"));
  EXPECT_THAT(read_file(scratch.path("verdict.markdown")), HasSubstr("## ar3d compare: REGRESSED"));
}

TEST(CiRecipes, AStudyThatIsViolatedOrIncompleteHasAVerdict) {
  const ScratchDirectory scratch;
  const std::string program = R"(import sys
while True:
    n, m = map(int, sys.stdin.readline().split())
    for _ in range(m): sys.stdin.readline()
    print('{"vertices":' + str([[i, WHAT, 0] for i in range(n)]) + '}', flush=True)
)";
  const auto write_program = [&](const std::string& what) {
    std::string text = program;
    scratch.write("mine.py", text.replace(text.find("WHAT"), 4, what));
  };
  const std::string spec = scratch.write(
      "own.toml", "study = 'own'\n[[algorithm]]\nname = 'mine'\ncommand = ['/usr/bin/python3', '" +
                      scratch.path("mine.py") +
                      "']\nguarantee = { max_degree = 2, max_bends = 0, cosine = [1, 1] }\n"
                      "[[sweep]]\nfamilies = 'cycle'\nsizes = [5, 6]\nalgorithms = 'mine'\n");
  const auto own_gate = [&](const std::string& arguments, const std::string& settings) {
    return run("AR3D=$(realpath {}) && cd " + scratch.path("") + " && AR3D=$AR3D AR3D_STUDY=" +
               spec + " " + settings + " " + kFolder + "regression-gate " + arguments);
  };
  write_program("i * i");
  expect_exit(0, own_gate("store references", ""));
  scratch.write("verdict.markdown", "old");
  write_program("0");  // all on one line: edges on vertices
  expect_exit(4, own_gate("judge references", ""));
  EXPECT_THAT(read_file(scratch.path("verdict.markdown")), HasSubstr("## ar3d compare: VIOLATED"));
  write_program("i * i if n == 5 else sys.exit(3)");
  expect_exit(3, own_gate("judge references", ""));
  EXPECT_THAT(read_file(scratch.path("verdict.markdown")), HasSubstr("REGRESSED"));
  must("cp " + scratch.path("now.h5") + " " + scratch.path("references/reference.h5"));
  expect_exit(5, own_gate("judge references", ""));
  EXPECT_THAT(read_file(scratch.path("verdict.markdown")),
              HasSubstr("came out on neither side: ended with code 3"));
  fs::remove(spec);
  expect_exit(2, own_gate("judge references", ""));
  EXPECT_THAT(read_file(scratch.path("verdict.markdown")), HasSubstr("NOTHING MEASURED"));
}

TEST(CiRecipes, UnknownWordsAreRefused) {
  const ScratchDirectory scratch;
  expect_exit(2, gate(scratch, ""));
  expect_exit(2, gate(scratch, "guess references"));
}

TEST(CiRecipes, TheFilesAreYamlAndRunTheGate) {
  for (const char* file : {"github-actions.yml", "gitlab-ci.yml"}) {
    const Outcome outcome = expect_exit(
        0, run("/usr/bin/python3 -c 'import sys, yaml; tree = yaml.safe_load(open(sys.argv[1]));"
               "texts = []; walk = lambda t: [walk(v) for v in (t.values() if isinstance(t, dict) "
               "else t "
               "if isinstance(t, list) else [])] or texts.append(str(t)); walk(tree);"
               "print(\"\\n\".join(t for t in texts if \"regression-gate\" in t))' " +
               std::string(kFolder) + file));
    EXPECT_EQ(outcome.out,
              "examples/ci/regression-gate judge references\n"
              "examples/ci/regression-gate store references\n");
  }
}

}  // namespace
}  // namespace ar3d::testing
