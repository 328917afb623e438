// A study finds its own files by whatever path it is named, and meets file systems that lack what
// others have.
#include <map>

#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

class StudyFiles : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return scratch_.path(name); }
  Outcome in_folder(const std::string& command) const {
    return run("cd " + path("") + "; " + command);
  }
  ScratchDirectory scratch_;
};

TEST_F(StudyFiles, AreFoundByEveryPathToThem) {
  fs::create_directories(path("sub/deep"));
  fs::create_symlink("sub", path("link"));
  expect_exit(0, in_folder("{} study run smoke -q -o sub/old.h5"));
  for (const char* results :
       {"sub//r.h5", "./sub/./r.h5", "sub/deep/../r.h5", "link/r.h5", "sub/r.h5"}) {
    for (const char* suffix : {".h5", ".html"}) fs::remove(path(std::string("sub/r") + suffix));
    const std::string name = results;
    expect_exit(5, in_folder(with_fault("full:60000") + "{} study run smoke -q -o " + name));
    ASSERT_TRUE(fs::exists(path("sub/r.h5.journal"))) << name;
    for (const char* other : {"sub/r.h5", "sub//r.h5.journal", "link/r.h5"}) {
      expect_output(in_folder(std::string("{} study status ") + other), " of 1080 rows, stopped",
                    5);
    }
    expect_error(in_folder("{} study run smoke -q --force -o " + name),
                 "is the journal of a study that is not finished");
    expect_exit(0, in_folder("{} study resume -q " + name));
    EXPECT_FALSE(fs::exists(path("sub/r.h5.journal"))) << name;
    expect_same_rows(path("sub/r.h5"), path("sub/old.h5"));
  }
}

TEST_F(StudyFiles, ResultsAreNotNamedAsJournalsAre) {
  for (const char* name : {"r.h5.rank-1", "r.journal", "r.h5.partial-7"}) {
    expect_error(in_folder(std::string("{} study run smoke -q -o ") + name),
                 "cannot name a results file");
  }
}

// What a killed program has left goes with the next run; what only looks a little like it stays.
TEST_F(StudyFiles, LeftoversGoAndFilesOfTheUsersStay) {
  const std::string left = ".partial-77-0123456789abcdef";
  const std::string journal = "r.h5.journal" + left, page = "r.html" + left;
  for (const std::string& name : {"r.h5" + left, journal, page, std::string("r.h5.mine.partial-7"),
                                  "r.h5.mine" + left, std::string("r.h5.partial-7")}) {
    scratch_.write(name, "x");
  }
  expect_exit(0, in_folder("{} study run smoke -q -o r.h5"));
  EXPECT_EQ(in_folder("LC_ALL=C ls").out,
            "r.h5\nr.h5.mine.partial-7\nr.h5.mine" + left + "\nr.h5.partial-7\nr.html\n");
}

TEST_F(StudyFiles, AnUnfitEnvironmentIsBadInput) {
  expect_one_line(in_folder("OMP_NUM_THREADS=100000 {} list formats"), "OMP_NUM_THREADS asks for");
  scratch_.write("g.g6", "D~{\n");
  expect_one_line(in_folder("TMPDIR=/nowhere {} study run --graphs g.g6 --algorithm diamond -q"),
                  "cannot create /nowhere/ar3d-graphs-");
  expect_one_line(in_folder("mkfifo pipe; timeout 20 {} study merge pipe -o m.h5"),
                  "pipe is not an HDF5 file");
}

TEST_F(StudyFiles, AFolderThatCannotBeListedIsAnError) {
  expect_error(in_folder(with_fault("list:1") + "{} study run smoke -q -o r.h5"),
               "cannot list .: Permission denied");
  EXPECT_FALSE(fs::exists(path("r.h5.journal")));
  expect_exit(0, in_folder("{} study run smoke -q -o r.h5"));
  expect_error(in_folder(with_fault("list:1") + "{} study status r.h5"),
               "cannot list .: Permission denied");
}

TEST_F(StudyFiles, NeedNoHardLinks) {
  for (const char* fault : {"nolink:1", "nolink:2"}) {
    expect_exit(0, in_folder(with_fault(fault) + "{} study run smoke -q --force -o r.h5"));
    EXPECT_EQ(in_folder("ls").out, "r.h5\nr.html\n") << fault;
  }
}

// Two processes that resume one study where locks are granted to both.
TEST_F(StudyFiles, WhereLocksDoNothingNoAcknowledgedRowIsLost) {
  scratch_.write("slow.toml",
                 "study = \"slow\"\n[[sweep]]\nfamilies = \"random-cubic\"\nsizes = 3000\n"
                 "algorithms = \"grid\"\ninstances = 200\n");
  const std::string study = with_fault("nolock:1") + "{} study ";
  const Outcome both = in_folder(
      study +
      "run -q --threads 1 slow.toml -o r.h5 2> a & until [ \"$(stat -c %s r.h5.journal 2> " +
      "/dev/null || echo 0)\" -gt 20000 ]; do sleep 0.01; done; " + study +
      "resume -q --threads 1 r.h5 2> b; wait; cat a b");
  EXPECT_THAT(both.out, HasSubstr("is being written by another process, too"));
  const JournalReader reader(path("r.h5.journal"));
  std::map<std::string, std::string> rows;
  std::string record(run_record_size(), '\0');
  for (std::size_t i = 0; i < reader.size(); ++i) {
    reader.read(i, record.data());
    rows[to_string(reader.key(i))] = record;
  }
  expect_error(in_folder("{} study resume -q r.h5"), "they are kept in ", 0);
  EXPECT_TRUE(fs::exists(path("r.h5.journal.cut-1")));
  std::map<std::string, std::string> after;
  for (const ar3d::RunRecord& row : read_results(path("r.h5")).runs) {
    after[row.row_key] = all_bytes(row);
  }
  EXPECT_EQ(after.size(), 200u);
  for (const auto& [key, bytes] : rows) EXPECT_EQ(after.at(key), bytes) << key;
}

}  // namespace
}  // namespace ar3d::testing
