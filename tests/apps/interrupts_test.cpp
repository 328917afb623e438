// Ctrl-C once, twice and three times; a folder that is moved while a study writes into it.
#include <sstream>

#include "ar3d/bench/measure/environment.h"
#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

/// 120 rows of some ten milliseconds.
constexpr const char* kInterruptedStudy =
    "study = 's'\n[[sweep]]\nfamilies = 'random-cubic'\nsizes = 2000\nalgorithms = 'grid'\n"
    "instances = 120\n";

/// Begins the study in the background and waits until it has some rows.
std::string begun(const std::string& spec, const std::string& file, const std::string& options) {
  return "{} study run -q " + spec + " --threads 2 " + options + " -o " + file + " > " + file +
         ".out 2>&1 & p=$!; until {} study status " + file +
         " 2>/dev/null | grep -q ': [1-9]'; do sleep 0.05; done; ";
}

TEST(Interrupts, TwoAndThreeOfThemLoseNoAcknowledgedRow) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("s.toml", kInterruptedStudy),
                    whole = scratch.path("whole.h5");
  must("{} study run -q " + spec + " -o " + whole);
  for (const std::string options : {"", "--isolate"}) {
    for (const std::string signals : {"2", "3"}) {
      const std::string file = scratch.path("r" + options + signals + ".h5");
      const Outcome outcome = run(
          begun(spec, file, options) + "{} study status " + file +
          " | sed -n 's/.*: \\([0-9]*\\) of.*/\\1/p'; s=$(date +%s%N); for i in $(seq " + signals +
          "); do kill -INT $p; sleep 0.01; done; wait $p; echo $?; "
          "echo $((($(date +%s%N) - s) / 1000000)); {} study status " +
          file + " | sed -n 's/.*: \\([0-9]*\\) of.*/\\1/p'");
      std::istringstream said(outcome.out);
      int acknowledged = -1, code = -1, milliseconds = -1, kept = -1;
      said >> acknowledged >> code >> milliseconds >> kept;
      EXPECT_EQ(code, 130) << outcome.out << outcome.err;
      EXPECT_GT(acknowledged, 0) << outcome.out;
      EXPECT_GE(kept, acknowledged) << outcome.out;
      EXPECT_LT(milliseconds, 10000) << "it ends soon";
      expect_exit(0, run("{} study resume -q " + file));
      expect_same_rows(file, whole);
    }
  }
}

/// Runs `{} command` and sends it SIGINT so many times, 3 ms apart, after the first seconds.
Outcome interrupted(const ScratchDirectory& scratch, const std::string& seconds, int times,
                    const std::string& command) {
  const std::string send = scratch.write("send.py", R"(
import subprocess, sys, time
process = subprocess.Popen(sys.argv[3:])
time.sleep(float(sys.argv[1]))
for _ in range(int(sys.argv[2])):
    process.send_signal(2)
    time.sleep(0.003)
code = process.wait()
sys.exit(130 if code == -2 else code)
)");
  return run("cd " + scratch.path("") + " && /usr/bin/python3 " + send + " " + seconds + " " +
             std::to_string(times) + " {} " + command);
}

TEST(Interrupts, OfMergeReportHuntAndGenerateLeaveWholeFilesOrNone) {
  const ScratchDirectory scratch;
  const std::string cd = "cd " + scratch.path("") + " && ";
  for (const std::string part : {"1", "2"}) {
    ASSERT_LE(run(cd + "{} study run -q smoke --shard " + part + "/2 -o " + part + ".h5").exit_code,
              0);
  }
  must(cd + "{} study merge 1.h5 2.h5 -o all.h5");
  const std::string before = read_file(scratch.path("all.h5"));
  int times = 0;
  for (const std::string seconds : {"0.01", "0.03", "0.06", "0.1", "0.2", "0.3"}) {
    times = times % 3 + 1;
    const auto ends = [&](const std::string& command) {
      const int code = interrupted(scratch, seconds, times, command).exit_code;
      EXPECT_TRUE(code == 130 || code == 0) << command << " ends with " << code;
    };
    ends("study merge 1.h5 2.h5 --force -o all.h5");
    EXPECT_EQ(read_file(scratch.path("all.h5")), before) << seconds << ": old or new, both whole";
    ends("report all.h5 --force -o page.html");
    if (fs::exists(scratch.path("page.html"))) {
      EXPECT_THAT(read_file(scratch.path("page.html")), HasSubstr("</html>")) << seconds;
    }
    ends("hunt --algorithm grid -n 40 --force -o tall");
    ends("generate random-cubic -n 1000 --count 20 -o g.s6 --force");
  }
  for (const auto& entry : fs::directory_iterator(scratch.path(""))) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }
}

/// 16 drawings that take callgrind some ten seconds together.
constexpr const char* kCountedStudy =
    "study = 's'\ncount = true\n[[sweep]]\nfamilies = 'random-cubic'\nsizes = 9000\n"
    "algorithms = 'two-bend'\ninstances = 16\n";

TEST(Interrupts, WhileCountingLeaveNothingButWholeRows) {
  if (std::string(build_kind()) == "sanitised") GTEST_SKIP() << "valgrind cannot run it";
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("s.toml", kCountedStudy), file = scratch.path("r.h5");
  const std::string temporary = scratch.path("temporary");
  fs::create_directory(temporary);
  const auto ends = [&](const std::string& signals, const std::string& words) {
    return run("export TMPDIR=" + temporary + "; {} study " + words + " > " + file +
               ".out 2>&1 & p=$!; until ls " + temporary + "/*/counts* > " + file +
               ".ls 2>&1; do sleep 0.05; kill -0 $p || exit 99; done; "
               "for s in " +
               signals +
               "; do kill -$s $p; done; wait $p; c=$?; sleep 0.5; "
               "pgrep -f callgrind-out-file=" +
               temporary + "/[a]r3d; exit $c");  // processes with a file there, except this shell
  };
  for (const std::string signals : {"INT", "TERM", "INT TERM INT"}) {
    const Outcome outcome =
        expect_exit(130, ends(signals, "run -q --force " + spec + " -o " + file));
    EXPECT_EQ(outcome.out, "") << signals;
    EXPECT_TRUE(fs::is_empty(temporary)) << signals;
    EXPECT_FALSE(fs::exists(file + ".journal")) << signals;
    expect_output(run("{} check " + file), "16 rows, 16 proved");
  }
  const std::string before = read_file(file);
  expect_exit(130, ends("TERM", "count " + file));
  EXPECT_EQ(read_file(file), before);
  EXPECT_EQ(ends("KILL", "count " + file).out, "") << "its child goes with it";
}

TEST(MovedFolder, AStudyEndsInItAndLeavesTheOneThatHasItsNameAlone) {
  const ScratchDirectory scratch;
  const std::string spec = scratch.write("s.toml", kInterruptedStudy),
                    older = scratch.path("older.h5");
  must("{} study run -q " + spec + " -o " + older);
  fs::create_directory(scratch.path("sub"));
  const std::string file = scratch.path("sub/r.h5");
  const Outcome outcome =
      run(begun(spec, file, "") + "cd " + scratch.path("") +
          " && mv sub moved && mkdir sub && cp older.h5 sub/r.h5 && wait $p; echo $?");
  EXPECT_EQ(outcome.out, "0\n") << outcome.err;
  expect_same_rows(scratch.path("moved/r.h5"), older);
  EXPECT_NE(read_file(scratch.path("moved/r.h5")), read_file(older)) << "rows of its own";
  EXPECT_EQ(read_file(file), read_file(older)) << "another study's";
  EXPECT_THAT(read_file(scratch.path("moved/r.h5.out")), HasSubstr("moved/r.h5"));
  EXPECT_FALSE(fs::exists(scratch.path("moved/r.h5.journal")));
  EXPECT_FALSE(fs::exists(scratch.path("sub/r.h5.journal")));
}

}  // namespace
}  // namespace ar3d::testing
