// Commands that the program prints show the same drawing again.
#include <sstream>

#include "ar3d/analysis/tally.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

/// The command with the program that was built with the tests.
std::string runnable(std::string command) {
  for (std::size_t at = 0; (at = command.find("ar3d ", at)) != std::string::npos; at += 3) {
    if (at == 0 || command[at - 1] == ' ') command.replace(at, 5, "{} ");
  }
  return command;
}

std::string hash_of_drawing(const std::string& command, const ScratchDirectory& scratch) {
  expect_exit(0, run(runnable(command) + " > " + scratch.path("drawing")));
  DrawingJsonlReader reader(scratch.path("drawing"));
  const auto line = reader.next();
  EXPECT_TRUE(line.has_value()) << command;
  return line ? drawing_hash(std::get<Drawing>(*line)) : "";
}

/// Every row's own command, whatever format the graph passes through.
TEST(PrintedCommands, OfRowsDrawTheRowsDrawing) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("r.h5");
  const std::string spec = scratch.write(
      "s.toml",
      "study = 's'\n[[sweep]]\nfamilies = ['random-cubic', { family = 'torus', rows = 5 }, "
      "{ family = 'contained-cycles', shuffle = 1 }, 'named', 'union-petersen']\n"
      "sizes = [20, 61]\nalgorithms = ['diamond', 'grid', 'two-bend', 'compact']\ninstances = 2\n");
  ASSERT_LE(run("{} study run " + spec + " -o " + file).exit_code, 5);
  std::size_t drawn = 0;
  for (const RunRecord& run : read_results(file).runs) {
    if (run.status != RunStatus::ok) continue;
    EXPECT_EQ(hash_of_drawing(draw_command(run), scratch), run.drawing_hash) << draw_command(run);
    ++drawn;
  }
  EXPECT_GT(drawn, 20u);
}

/// What `check` prints of rows that are wrong or not done.
TEST(PrintedCommands, OfCheckDrawTheRowsDrawing) {
  const ScratchDirectory scratch;
  const std::string made = scratch.path("made.h5"), file = scratch.path("r.h5");
  const std::string spec = scratch.write(
      "s.toml",
      "study = 's'\n[[sweep]]\nfamilies = ['random-cubic', { family = 'torus', rows = 5 }]\n"
      "sizes = [20, 61]\nalgorithms = [{ algorithm = 'diamond', effort = [0, 2] }, 'compact']\n");
  must("{} study run -q " + spec + " -o " + made);
  Results results = read_results(made);
  std::vector<std::string> hashes;
  for (RunRecord& run : results.runs) {
    hashes.push_back(run.drawing_hash);
    run.extents[1] = 1'000'000;  // passes the theorem's bound
  }
  write_results(results, file);
  const Outcome check = expect_exit(4, run("{} check " + file));
  std::size_t commands = 0;
  std::istringstream lines(check.out);
  for (std::string line, row; std::getline(lines, line);) {
    if (line.starts_with("VIOLATED row ")) row = line.substr(13);
    if (!line.starts_with("    ar3d ")) continue;
    EXPECT_EQ(hash_of_drawing(line.substr(4), scratch), hashes.at(std::stoul(row))) << line;
    ++commands;
  }
  EXPECT_GE(commands, results.runs.size());
}

std::vector<std::string> lines_with(const std::string& text, const std::string& beginning) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(beginning)) found.push_back(line);
  }
  return found;
}

/// What stands between backquotes.
std::vector<std::string> quoted_commands(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t at = 0; (at = text.find("`ar3d ", at)) != std::string::npos;) {
    const std::size_t end = text.find('`', at + 1);
    found.push_back(text.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return found;
}

/// What a study that ends early, `status` and a refused fresh run say of going on.
TEST(PrintedCommands, OfAnUnfinishedStudyRunAsPrinted) {
  const ScratchDirectory scratch;
  const std::string file = scratch.path("it's r.h5");
  const std::string spec =
      scratch.write("s.toml",
                    "study = 's'\nbudget = { study_s = 1e-6 }\n[[sweep]]\nfamilies = 'cycle'\n"
                    "sizes = 20\nalgorithms = 'grid'\ninstances = 3\n");
  const std::string begin = "{} study run -q " + spec + " -o \"" + file + "\"";
  const Outcome begun = expect_exit(5, run(begin));
  const Outcome again = expect_exit(2, run(begin));
  const Outcome status = expect_exit(5, run("{} study status \"" + file + "\""));
  for (const std::string& said : {begun.err, again.err, status.out}) {
    const auto commands = quoted_commands(said);
    ASSERT_EQ(commands.size(), 1u) << said;
    expect_exit(5, run(runnable(commands.front()) + " -q"));
  }
}

/// What `hunt -o` prints runs as printed; `shrink` finds the ratio that `hunt` has found.
TEST(PrintedCommands, OfHuntAndShrinkRunAsPrinted) {
  const ScratchDirectory scratch;
  for (const std::string algorithm : {"diamond", "grid"}) {
    const std::string prefix = scratch.path("it's " + algorithm);
    const Outcome hunt =
        expect_exit(0, run("{} hunt --algorithm " + algorithm +
                           " -n 12 --evaluations 40 --measure z -o \"" + prefix + "\""));
    const auto printed = lines_with(hunt.out, "ar3d ");
    ASSERT_EQ(printed.size(), 3u) << hunt.out;
    for (const std::string& command : printed) {
      expect_exit(0, run(runnable(command)));
    }
    EXPECT_TRUE(fs::exists(prefix + "-small.s6"));
    for (const std::string& command : lines_with(read_file(prefix + "-small.txt"), "ar3d ")) {
      expect_exit(0, run(runnable(command)));
    }
  }
}

}  // namespace
}  // namespace ar3d::testing
