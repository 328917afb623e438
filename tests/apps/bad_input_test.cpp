// Every input is hostile: one line that names file, line and value; the documented exit code;
// nothing half-written.
#include "ar3d/bench/measure/environment.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

struct BadInput {
  const char* name;
  const char* command;               // @ stands for the scratch directory's file
  std::string content;               // of that file
  std::vector<std::string> message;  // parts of the one line on stderr
};

std::ostream& operator<<(std::ostream& out, const BadInput& bad) { return out << bad.name; }

const char* const kDraw = "{} draw @ --algorithm diamond -o @.jsonl";

std::vector<BadInput> bad_inputs() {
  using namespace std::string_literals;
  return {
      {"missing_file",
       "{} draw @.missing --algorithm diamond -o @.jsonl",
       "",
       {".missing", "No such file"}},
      {"unreadable_directory",
       "{} draw /tmp --algorithm diamond -o @.jsonl",
       "",
       {"/tmp", "directory"}},
      {"empty_file", kDraw, "", {"@", "empty"}},
      {"truncated_graph6", kDraw, "Dhc\nI?\n", {"@:2:"}},
      {"non_ascii_graph6", kDraw, "D\xff\xfe\n", {"@:1"}},
      {"sparse6_bad_padding", kDraw, ":Fa@x^@\n", {"@:1:"}},
      {"id_out_of_range",
       "{} draw @ --from edgelist --algorithm diamond -o @.jsonl",
       "# vertices 3\n0 1\n1 7\n",
       {"@:3:", "7"}},
      {"loop",
       "{} draw @ --from edgelist --algorithm diamond -o @.jsonl",
       "0 1\n4 4\n",
       {"@:2:", "loop"}},
      {"parallel_edges",
       "{} draw @ --from edgelist --algorithm diamond -o @.jsonl",
       "0 1\n1 2\n1 0\n",
       {"@:3:", "parallel"}},
      {"not_a_number",
       "{} draw @ --from edgelist --algorithm diamond -o @.jsonl",
       "0 1\n1 two\n",
       {"@:2:", "two"}},
      {"absurd_n_graph6", kDraw, "~~~~~~~~\n", {"@:1:"}},
      {"absurd_n_sparse6", kDraw, ":~~~~~~~~\n", {"@:1:"}},
      {"unknown_family", "{} generate no-such-family -n 10 -o @.out", "", {"no-such-family"}},
      {"unknown_algorithm",
       "{} draw @ --algorithm no-such-algorithm -o @.jsonl",
       "Dhc\n",
       {"no-such-algorithm"}},
      {"unknown_option",
       "{} draw @ --algorithm diamond --set colour=3 -o @.jsonl",
       "Dhc\n",
       {"colour"}},
      {"option_out_of_range",
       "{} draw @ --algorithm diamond --set effort=9 -o @.jsonl",
       "Dhc\n",
       {"effort", "9"}},
      {"unknown_flag",
       "{} draw @ --algorithm diamond --colour red -o @.jsonl",
       "Dhc\n",
       {"--colour"}},
      {"unwritable_output",
       "{} draw @ --algorithm diamond -o /no/such/dir/out",
       "Dhc\n",
       {"/no/such/dir/out"}},
      {"unknown_toml_key",
       "{} study run @ -o @.out",
       "study = 'x'\nfamilys = 'path'\n[[sweep]]\nfamilies = 'path'\nsizes = 9\nalgorithms = "
       "'diamond'\n",
       {"@:2", "familys"}},
      {"broken_toml", "{} study run @ -o @.out", "study = \n", {"@:1"}},
      {"unknown_study", "{} study run no-such-study -o @.out", "", {"no-such-study"}},
      {"results_not_hdf5", "{} check @", "hello\n", {"@"}},
      {"results_missing", "{} report @.missing", "", {".missing"}},
      {"drawing_not_json", "{} verify @", "hello\n", {"@:1"}},
  };
}

class BadInputTest : public ::testing::TestWithParam<BadInput> {};

TEST_P(BadInputTest, OneLineAndExitTwoAndNothingWritten) {
  const BadInput& bad = GetParam();
  const ScratchDirectory scratch;
  const std::string file = scratch.write("input", bad.content);
  const auto fill = [&](std::string text) {
    for (std::size_t at = 0; (at = text.find('@', at)) != std::string::npos; at += file.size()) {
      text.replace(at, 1, file);
    }
    return text;
  };
  const Outcome outcome = expect_exit(2, run(fill(bad.command)));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  for (const std::string& part : bad.message) EXPECT_THAT(outcome.err, HasSubstr(fill(part)));
  for (const char* ending : {".out", ".jsonl"}) {
    EXPECT_FALSE(fs::exists(file + ending)) << "half-written output";
  }
}

INSTANTIATE_TEST_SUITE_P(Program, BadInputTest, ::testing::ValuesIn(bad_inputs()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Program, FullDiskIsAnErrorNotAShortFile) {
  expect_error(run("{} generate path -n 100000 -o - > /dev/full"), "No space left");
}

// 27 million cells of a million rows each: refused at the first few, not when all are in memory.
TEST(Program, AStudyOfTooManyRowsIsRefusedInLittleMemory) {
  if (std::string(build_kind()) == "sanitised") GTEST_SKIP() << "needs all address space";
  std::string jumps = "1";
  for (int k = 2; k <= 3000; ++k) jumps += ", " + std::to_string(k);
  const ScratchDirectory scratch;
  const std::string spec = scratch.write(
      "s.toml", "study = 's'\n[[sweep]]\nfamilies = { family = 'generalised-petersen', k = [" +
                    jumps +
                    "] }\nsizes = { from = 4, to = 4294967294, per_decade = 1000 }\n"
                    "algorithms = 'grid'\nrepetitions = 1000000\n");
  const Outcome outcome = expect_exit(2, run("ulimit -v 1000000; {} study plan " + spec));
  EXPECT_EQ(outcome.err, "ar3d: study s has more than 10000000 rows\n");
}

TEST(Program, DegreeAboveTheGuaranteeNamesTheVertex) {
  const ScratchDirectory scratch;
  const std::string star = scratch.write("star", "0 1\n0 2\n0 3\n0 4\n0 5\n");
  const Outcome outcome =
      expect_exit(2, run("{} draw " + star + " --from edgelist --algorithm diamond"));
  EXPECT_THAT(outcome.err, HasSubstr("vertex 0 has degree 5"));
  EXPECT_THAT(outcome.out,
              HasSubstr("\"error\""));  // its line in the stream of drawings; the others go on
}

TEST(Program, TheGraphWithoutVerticesIsDrawn) {
  expect_exit(0, run("printf '?\\n' | {} draw - --algorithm diamond | {} verify -"));
}

}  // namespace
}  // namespace ar3d::testing
