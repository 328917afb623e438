// No verb replaces a file that is still needed.
#include <fstream>

#include "support/program.h"

namespace ar3d::testing {
namespace {

class Outputs : public ::testing::Test {
 protected:
  // One small study for all tests of this program.
  static void SetUpTestSuite() {
    shared_folder = new ScratchDirectory;
    must("{} study run smoke -q -o " + shared_folder->path("made.h5"));
  }
  static void TearDownTestSuite() { delete shared_folder; }

  void SetUp() override {
    results_ = scratch_.path("r.h5");
    fs::copy_file(shared_folder->path("made.h5"), results_);
    fs::copy_file(shared_folder->path("made.h5"), scratch_.path("other.h5"));
    bytes_ = read_file(results_);
  }

  void expect_refused(const std::string& command, const std::string& why) {
    expect_error(run("cd " + scratch_.path("") + " && {} " + command), why);
    EXPECT_EQ(read_file(results_), bytes_) << command;
    EXPECT_EQ(read_file(scratch_.path("other.h5")), bytes_) << command;
  }

  ScratchDirectory scratch_;
  std::string results_;
  std::string bytes_;

 private:
  static ScratchDirectory* shared_folder;
};

ScratchDirectory* Outputs::shared_folder = nullptr;

TEST_F(Outputs, AreNotTheVerbsInput) {
  fs::create_directory(scratch_.path("sub"));
  fs::create_symlink("r.h5", scratch_.path("link.h5"));
  fs::create_hard_link(results_, scratch_.path("hard.h5"));
  for (const char* name : {"r.h5", "./r.h5", "sub/../r.h5", "link.h5", "hard.h5"}) {
    const std::string why = std::string(name) + " would be overwritten by what is made from it";
    for (const char* option : {"-o", "--csv", "--json", "--rows", "--growth"}) {
      expect_refused(std::string("report r.h5 ") + option + " " + name, why);
    }
    expect_refused(std::string("replay r.h5 0 -o ") + name, why);
    expect_refused(std::string("compare other.h5 r.h5 --json ") + name, why);
    expect_refused(std::string("study merge r.h5 -o ") + name, why);
    expect_refused(std::string("study count r.h5 -o ") + name, why);
    expect_refused(std::string("study status r.h5 --snapshot ") + name, why);
  }
}

TEST_F(Outputs, AreNotTheFilesThatAStudyReads) {
  const std::string cd = "cd " + scratch_.path("") + " && ";
  must(cd +
       "printf 'D~{\\n' > k5.g6 && {} study run --graphs k5.g6 --algorithm diamond -q -o g.h5");
  const std::string graph = read_file(scratch_.path("k5.g6"));
  for (const char* command :
       {"replay g.h5 0 --format jsonl --force -o k5.g6",
        "replay g.h5 --keep worst --force -o k5.g6", "study count g.h5 --force -o k5.g6"}) {
    expect_refused(command, "k5.g6 would be overwritten by what is made from it");
    EXPECT_EQ(read_file(scratch_.path("k5.g6")), graph) << command;
  }
  must(cd + "{} history add r.h5 --name one --place 1 --folder past");
  const std::string held = run(cd + "ls past/*.h5 | tr -d '\\n'").out;
  for (const char* option : {"-o ", "--json "}) {
    expect_refused("history report --folder past --force " + (option + held),
                   "would be overwritten");
    EXPECT_EQ(read_file(scratch_.path(held)), bytes_) << option;
  }
}

TEST_F(Outputs, AreNoFileNamedLikeStandardOutput) {
  for (const char* command :
       {"report r.h5 -o -", "report r.h5 --rows -", "compare r.h5 other.h5 --json - --markdown -",
        "study run smoke -q -o -", "study merge r.h5 -o -", "study status r.h5 --snapshot -",
        "history report -o -"}) {
    expect_exit(2, run("cd " + scratch_.path("") + " && {} " + command));
    EXPECT_FALSE(fs::exists(scratch_.path("-"))) << command;
  }
}

TEST_F(Outputs, AreNotEachOther) {
  expect_refused("report r.h5 --csv a.csv --json ./a.csv", "./a.csv is named for two outputs");
  expect_refused("study run smoke -q -o new.html", "new.html is named for two outputs");
  EXPECT_FALSE(fs::exists(scratch_.path("new.html")));
}

TEST_F(Outputs, DoNotReplaceResultsUnasked) {
  const std::string why = "other.h5 exists and is a results file; --force replaces it";
  for (const char* command :
       {"study run smoke -q -o other.h5", "study merge r.h5 -o other.h5", "report r.h5 -o other.h5",
        "study status r.h5 --snapshot other.h5", "study count r.h5 -o other.h5",
        "replay r.h5 0 -o other.h5", "report r.h5 --csv other.h5"}) {
    expect_refused(command, why);
  }
  const std::string other = scratch_.path("other.h5");
  expect_exit(0, run("{} study run smoke -q --force -o " + other));
  EXPECT_NE(read_file(other), bytes_);
  expect_exit(0, run("{} study merge --force " + results_ + " -o " + other));
}

/// What every verb that writes files writes.
struct Written {
  const char* command;
  const char* file;
};

TEST_F(Outputs, ThatExistAreReplacedWithForceOnly) {
  must("{} generate k4 -o " + scratch_.path("k4.s6"));
  must("{} draw " + scratch_.path("k4.s6") + " --algorithm grid -o " + scratch_.path("d.jsonl"));
  for (const Written& written :
       std::vector<Written>{{"generate petersen -o out.s6", "out.s6"},
                            {"draw k4.s6 --algorithm diamond -o out.jsonl", "out.jsonl"},
                            {"draw k4.s6 --algorithm diamond -o out.svg", "out.svg"},
                            {"draw k4.s6 --algorithm diamond -o out.stl", "out.stl"},
                            {"replay r.h5 0 -o out.jsonl", "out.jsonl"},
                            {"hunt --algorithm grid -n 8 --evaluations 2 -o out", "out.txt"},
                            {"shrink k4.s6 --algorithm grid --ratio 1e-9 -o out", "out.svg"},
                            {"view d.jsonl -o out.html", "out.html"},
                            {"report r.h5 -o out.html", "out.html"},
                            {"report r.h5 --csv out.csv", "out.csv"},
                            {"report r.h5 --growth out.csv", "out.csv"},
                            {"report r.h5 --rows out.csv", "out.csv"},
                            {"report r.h5 --json out.json", "out.json"},
                            {"figures r.h5 -o .", "side.pdf"},
                            {"compare r.h5 other.h5 --drawings-only --json out.json", "out.json"},
                            {"study run smoke -q -o out.hdf5", "out.hdf5"},
                            {"study merge r.h5 -o out.hdf5", "out.hdf5"},
                            {"study count r.h5 --max-n 4 -o out.stl", "out.stl"},
                            {"study status r.h5 --snapshot out.h5", "out.h5"}}) {
    const std::string file = scratch_.path(written.file);
    fs::create_symlink("gone", file);
    expect_refused(written.command + std::string(" --force"), "a symbolic link to nothing");
    EXPECT_TRUE(fs::is_symlink(file) && !fs::exists(file)) << written.command;
    fs::remove(file);
    std::ofstream(file) << "a year's work\n";
    expect_refused(written.command, std::string(written.file) + " exists; --force replaces it");
    EXPECT_EQ(read_file(file), "a year's work\n") << written.command;
    if (std::string(written.command).starts_with("study count")) continue;  // takes valgrind
    const Outcome forced =
        run("cd " + scratch_.path("") + " && {} " + written.command + " --force");
    EXPECT_LE(forced.exit_code, 0) << written.command << forced.err;
    EXPECT_NE(read_file(file), "a year's work\n") << written.command;
    fs::remove(file);
    fs::remove(scratch_.path("out.s6"));
    fs::remove(scratch_.path("out.jsonl"));
    fs::remove(scratch_.path("out.txt"));
    fs::remove(scratch_.path("out.svg"));
  }
}

TEST_F(Outputs, AnEmptyFileAndADeviceHoldNothingToLose) {
  const std::string k4 = "{} generate k4 --format graph6 ";
  EXPECT_EQ(run("f=$(mktemp) && " + k4 + "-o $f && cat $f; rm $f").out, "C~\n");
  expect_exit(0, run(k4 + "-o /dev/null"));
  EXPECT_EQ(run(k4 + "-o /dev/stdout | cat").out, "C~\n");
}

TEST_F(Outputs, APageThatIsNoReportIsNotReplacedByResume) {
  const std::string spec =
      scratch_.write("s.toml",
                     "study = 's'\nbudget = { study_s = 1e-9 }\n[[sweep]]\nfamilies = 'cycle'\n"
                     "sizes = 20\nalgorithms = 'grid'\ninstances = 3\n");
  expect_exit(5, run("{} study run -q " + spec + " -o " + scratch_.path("index.h5")));
  scratch_.write("index.html", "my pages");
  run("{} study resume -q " + scratch_.path("index.h5"));
  EXPECT_EQ(read_file(scratch_.path("index.html")), "my pages");
}

TEST_F(Outputs, DoNotReplaceAPageThatIsNoReport) {
  scratch_.write("index.html", "<!doctype html><title>my pages</title>");
  const std::string why = "index.html exists and is no report of ar3d";
  expect_refused("study run smoke -q -o index.h5", why);
  EXPECT_FALSE(fs::exists(scratch_.path("index.h5"))) << "said before any work";
  fs::copy_file(results_, scratch_.path("index.h5"));
  expect_refused("report index.h5", why);
  EXPECT_EQ(read_file(scratch_.path("index.html")), "<!doctype html><title>my pages</title>");
  expect_exit(
      0, run("{} report " + results_ + " && {} report " + results_));  // a report is made again
}

TEST_F(Outputs, DoNotReplaceWhatBelongsToAnUnfinishedStudy) {
  scratch_.write("new.h5.journal", "ar3d-journal 2\n");
  const std::string why = "new.h5 is the results file of a study that is not finished";
  expect_refused("study merge r.h5 -o new.h5", why);
  expect_refused("report r.h5 -o new.h5", why);
  expect_refused("report r.h5 -o new.h5.journal", "is a study's journal");
}

}  // namespace
}  // namespace ar3d::testing
