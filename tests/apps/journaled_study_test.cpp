// Studies that are interrupted, refused, divided and put together again, through the program.
#include <fstream>
#include <map>

#include "ar3d/bench/run/session.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

// A study that can be met while it runs.
const char* const kSlow = R"(study = "slow"
[[sweep]]
families = "random-cubic"
sizes = 10000
algorithms = "grid"
instances = 60
)";

class JournaledStudy : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_.path(name); }
  Outcome study(const std::string& arguments) const { return run("{} study " + arguments); }
  // Runs `slow` on one thread, and when some rows are there: `then`, with the process as $writer.
  Outcome meet_while_running(const std::string& results, const std::string& then) const {
    const std::string spec = scratch_.write("slow.toml", kSlow);
    return run("{} study run --threads 1 -q " + spec + " -o " + results +
               " & writer=$!; until [ \"$(stat -c %s " + results +
               ".journal 2> /dev/null || echo 0)\" -gt 8000 ]; do sleep 0.01; done; " + then +
               "; wait $writer");
  }
  void run_and_kill(const std::string& results) const {
    expect_exit(137, meet_while_running(results, "kill -KILL $writer"));
    ASSERT_TRUE(fs::exists(results + ".journal"));
    ASSERT_FALSE(fs::exists(results));
  }
  void make_shards(int count) const {
    for (int i = 1; i <= count; ++i) {
      const std::string shard = std::to_string(i) + "/" + std::to_string(count);
      expect_exit(0, study("run smoke -q --shard " + shard + " -o " + shard_path(i)));
    }
  }
  std::string shard_path(int i) const { return path(std::to_string(i) + ".h5"); }

  ScratchDirectory scratch_;
};

TEST_F(JournaledStudy, LeavesNoJournalBehind) {
  expect_exit(0, study("run smoke -q -o " + path("s.h5")));
  EXPECT_FALSE(fs::exists(path("s.h5.journal")));
  expect_output(study("status " + path("s.h5")), "complete");
  expect_exit(0, study("resume -q " + path("s.h5")));  // nothing is left to do
}

TEST_F(JournaledStudy, ResumesAfterAKillWithTheRowsItHad) {
  const std::string results = path("slow.h5");
  run_and_kill(results);
  const Outcome status = expect_exit(5, study("status " + results));
  EXPECT_THAT(status.out, HasSubstr(" of 60 rows, stopped"));
  EXPECT_THAT(status.out, HasSubstr("ar3d study resume " + results));
  expect_exit(5, study("status " + results + " --snapshot " + path("before.h5")));

  expect_error(study("run -q " + path("slow.toml") + " -o " + results), "ar3d study resume");
  expect_exit(0, study("resume -q --threads 1 " + results + ".journal"));
  expect_exit(0, study("run -q " + path("slow.toml") + " -o " + path("whole.h5")));
  expect_same_rows(results, path("whole.h5"));

  const Results before = read_results(path("before.h5"));
  const Results after = read_results(results);
  ASSERT_GT(before.runs.size(), 0u);
  std::map<std::string, std::string> kept;
  for (const ar3d::RunRecord& row : after.runs) kept[row.row_key] = all_bytes(row);
  for (const ar3d::RunRecord& row : before.runs) {
    EXPECT_EQ(kept[row.row_key], all_bytes(row)) << "rows never change";
  }
  EXPECT_EQ(after.runs.back().session + 1, 2);
}

TEST_F(JournaledStudy, ResumesFromAnInterruptedResultsFileAlone) {
  const std::string results = path("slow.h5");
  expect_error(meet_while_running(results, "kill -INT $writer"),
               "go on with `ar3d study resume " + results, 130);
  fs::remove(results + ".journal");
  expect_exit(5, study("status " + results));
  expect_exit(5, run("{} check " + results));  // what is missing is no pass
  const Results before = read_results(results);
  expect_exit(0, study("resume -q " + results));
  const Results after = read_results(results);
  EXPECT_EQ(after.runs.size(), 60u);
  EXPECT_EQ(after.created, before.created);
  ASSERT_GT(before.runs.size(), 0u);
  EXPECT_LT(before.runs.size(), 60u);
}

TEST_F(JournaledStudy, IsReadWhileItRuns) {
  const std::string results = path("slow.h5");
  const Outcome outcome = expect_exit(
      130,
      meet_while_running(results, "{} study status " + results + "; {} study status " + results +
                                      " --snapshot " + path("live.h5") + "; {} study resume -q " +
                                      results + "; echo second=$?; kill -INT $writer"));
  EXPECT_THAT(outcome.out, HasSubstr("1 process at work"));
  EXPECT_THAT(outcome.out, HasSubstr("second=2"));
  EXPECT_THAT(outcome.err, HasSubstr("slow.h5.journal is being written by another process"));
  const Outcome python = run("/usr/bin/python3 -c 'import h5py; f = h5py.File(\"" +
                             path("live.h5") + "\"); print(len(f[\"runs\"]) > 0)'");
  EXPECT_EQ(python.out, "True\n") << python.err;
}

TEST_F(JournaledStudy, IsWatchedToItsEnd) {
  const std::string results = path("slow.h5");
  expect_output(
      meet_while_running(results, "{} study status --watch " + results + "; echo watched=$?"),
      {" of 60 rows, 1 process at work\n", "study slow: 60 of 60 rows, complete\n", "watched=0"});
}

TEST_F(JournaledStudy, WatchingAStoppedStudyEndsAtOnce) {
  const std::string results = path("slow.h5");
  run_and_kill(results);
  expect_output(study("status --watch " + results), " of 60 rows, stopped", 5);
}

TEST_F(JournaledStudy, AFullDiskLeavesNoHalfResultsFile) {
  const std::string results = path("slow.h5");
  run_and_kill(results);
  expect_error(run("trap '' XFSZ; ulimit -f 4; {} study status " + results + " --snapshot " +
                   path("live.h5")),
               "cannot write " + path("live.h5") + ": File too large");
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(path(""))) {
    files += entry.path().string().find("live.h5") == std::string::npos ? 0 : 1;
  }
  EXPECT_EQ(files, 0u);
}

// Its rows are in an open file without a name: it is put back.
TEST_F(JournaledStudy, ADeletedJournalComesBackWithItsRows) {
  const std::string results = path("slow.h5");
  const Outcome ended = expect_exit(5, meet_while_running(results, "rm " + results + ".journal"));
  EXPECT_THAT(ended.err,
              HasSubstr("slow.h5.journal was deleted while rows went there; it is back"));
  expect_exit(0, study("resume -q " + results));
  EXPECT_EQ(read_results(results).runs.size(), 60u);
}

TEST_F(JournaledStudy, ResumeRefusesTheImpossibleToo) {
  const std::string spec =
      "study = \"tight\"\nbudget = { row_time_s = 1e-9 }\n[[sweep]]\nfamilies = \"cycle\"\n"
      "sizes = 1000\nalgorithms = \"diamond\"\n";
  const std::string journal = path("tight.h5.journal");
  { const JournalWriter begun(journal, describe_study(parse_study(spec, "tight.toml"), 1)); }
  expect_error(study("resume -q " + journal), "but budget.row_time_s gives");
}

TEST_F(JournaledStudy, AFullDiskEndsItResumably) {
  const std::string results = path("slow.h5");
  const std::string spec = scratch_.write("slow.toml", kSlow);
  expect_error(run("ulimit -f 16; {} study run -q " + spec + " -o " + results),
               {"slow.h5.journal: File too large", "go on with `ar3d study resume " + results}, 5);
  expect_exit(0, study("resume -q " + results));
  EXPECT_EQ(read_results(results).runs.size(), 60u);
}

TEST_F(JournaledStudy, RefusesPlacesThatCannotBeWrittenBeforeAnyWork) {
  for (const char* path : {"/proc/s.h5", "/sys/s.h5", "/no/such/folder/s.h5"}) {
    expect_error(study(std::string("run quick -q -o ") + path),
                 std::string("cannot write ") + path);
  }
}

TEST_F(JournaledStudy, ADamagedJournalIsAnErrorThatNamesTheOffset) {
  const std::string results = path("slow.h5");
  run_and_kill(results);
  std::string journal = read_file(results + ".journal");
  journal[journal.size() / 2] = static_cast<char>(journal[journal.size() / 2] ^ 1);
  std::ofstream(results + ".journal", std::ios::binary) << journal;
  expect_error(study("resume -q " + results), "slow.h5.journal: damaged at byte ");
  EXPECT_EQ(read_file(results + ".journal"), journal) << "nothing is changed";
}

TEST_F(JournaledStudy, ShardsMergeToTheSameBytesInAnyOrder) {
  make_shards(3);
  const std::string a = shard_path(1), b = shard_path(2), c = shard_path(3);
  const std::string one = path("one.h5"), two = path("two.h5");
  expect_exit(0, study("merge " + a + " " + b + " " + c + " -o " + one));
  expect_exit(0, study("merge " + c + " " + a + " " + b + " " + a + " -o " + two));
  EXPECT_EQ(read_file(one), read_file(two));
  expect_exit(0, study("run smoke -q -o " + path("whole.h5")));
  expect_same_rows(one, path("whole.h5"));
  expect_exit(0, run("{} check " + one));
}

TEST_F(JournaledStudy, MergeRefusesWhatDoesNotBelongTogether) {
  make_shards(3);
  const std::string a = shard_path(1), b = shard_path(2), c = shard_path(3);
  const auto merge = [&](const std::string& parts) {
    const Outcome outcome = study("merge " + parts + " -o " + path("m.h5"));
    EXPECT_FALSE(fs::exists(path("m.h5"))) << parts;
    return outcome;
  };
  expect_error(merge(a + " " + c), "no file of shard 2", 5);

  fs::copy_file(b, path("cut.h5"));
  fs::resize_file(path("cut.h5"), fs::file_size(b) / 2);
  expect_error(merge(a + " " + path("cut.h5") + " " + c), "cut.h5 is not a readable results file");

  expect_exit(0, study("run smoke -q --shard 2/3 -o " + path("again.h5")));
  expect_error(merge(a + " " + b + " " + c + " " + path("again.h5")), "differs in its ");

  expect_exit(0, study("run smoke -q --shard 1/2 -o " + path("half.h5")));
  expect_exit(2, merge(a + " " + b + " " + c + " " + path("half.h5")));

  const std::string other = scratch_.write("other.toml", kSlow);
  expect_exit(0, study("run -q --shard 1/60 " + other + " -o " + path("other.h5")));
  expect_error(merge(a + " " + b + " " + c + " " + path("other.h5")),
               "differ in their specification");

  Results foreign = read_results(c);
  foreign.source_hash = std::string(40, '0');
  write_results(foreign, path("foreign.h5"));
  const Outcome source = expect_exit(2, merge(a + " " + b + " " + path("foreign.h5")));
  EXPECT_THAT(source.err, HasSubstr("differ in their program's source"));

  Results changed = read_results(c);
  changed.dirty = true;
  changed.dirty_hash = std::string(64, '0');
  write_results(changed, path("changed.h5"));
  expect_error(merge(a + " " + b + " " + path("changed.h5")), "differ in their program's source");
}

// Rows of two programs would stand in one file as if one had made them.
TEST_F(JournaledStudy, DoesNotGoOnWithRowsOfAnotherProgram) {
  expect_exit(0, study("run smoke -q -o " + path("s.h5")));
  Results foreign = read_results(path("s.h5"));
  foreign.source_hash = std::string(40, '0');
  write_results(foreign, path("foreign.h5"));
  const std::string before = read_file(path("foreign.h5"));
  for (const char* again : {"", " --again timeout"}) {
    expect_error(study("resume -q " + path("foreign.h5") + again),
                 "its rows were made by the program of source " + std::string(40, '0'));
    EXPECT_EQ(read_file(path("foreign.h5")), before) << again;
    EXPECT_FALSE(fs::exists(path("foreign.h5.journal"))) << again;
  }
}

TEST_F(JournaledStudy, RefusesShardsThatAreNone) {
  for (const char* shard : {"0/3", "4/3", "1", "1/", "/2", "a/b", "1/2/3", "-1/2"}) {
    expect_error(study(std::string("run smoke --shard=") + shard), "is no shard");
  }
}

}  // namespace
}  // namespace ar3d::testing
