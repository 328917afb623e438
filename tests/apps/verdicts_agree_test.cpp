// Verbs that judge a study say the same of the same files: check, report, study status, study
// resume.
#include <fstream>
#include <functional>

#include "ar3d/store/rows.h"
#include "support/program.h"

namespace ar3d::testing {
namespace {

const char* const kJudgedStudy = R"(study = "judged"
[[sweep]]
families = "random-cubic"
sizes = [20, 40, 80]
algorithms = ["grid", "diamond"]
instances = 4
repetitions = 2
)";

// What a folder with a study looks like, and what is said of it.
struct Situation {
  const char* name;
  std::function<void(const ScratchDirectory&)> make;  // r.h5 and its journals, from study.toml
  int exit_code;
  const char* words;  // on standard output; of exit code 2 the last words of the error
};
std::ostream& operator<<(std::ostream& out, const Situation& s) { return out << s.name; }

void make_whole(const ScratchDirectory& scratch) {
  const Outcome outcome =
      expect_exit(0, run("cd " + scratch.path("") + " && {} study run -q study.toml -o r.h5"));
}

std::function<void(const ScratchDirectory&)> changed(std::function<void(Results&)> change) {
  return [change = std::move(change)](const ScratchDirectory& scratch) {
    make_whole(scratch);
    Results results = read_results(scratch.path("r.h5"));
    change(results);
    write_results(results, scratch.path("r.h5"));
  };
}

void flip_bit(const std::string& path, std::uint64_t index) {
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekg(static_cast<std::streamoff>(index));
  const char byte = static_cast<char>(file.get() ^ 4);
  file.seekp(static_cast<std::streamoff>(index));
  file.put(byte);
}

void make_journal(const ScratchDirectory& scratch) {
  const Outcome full =
      expect_exit(5, run("cd " + scratch.path("") + " && " + with_fault("full:20000") +
                         "{} study run -q study.toml -o r.h5"));
  ASSERT_TRUE(fs::exists(scratch.path("r.h5.journal")));
  ASSERT_FALSE(fs::exists(scratch.path("r.h5")));
}

void truncate_results(const ScratchDirectory& scratch) {
  make_whole(scratch);
  fs::resize_file(scratch.path("r.h5"), fs::file_size(scratch.path("r.h5")) / 2);
}

void damage_results(const ScratchDirectory& scratch) {
  make_whole(scratch);
  flip_bit(scratch.path("r.h5"), fs::file_size(scratch.path("r.h5")) / 2);
}

void damage_journal(const ScratchDirectory& scratch) {
  make_journal(scratch);
  flip_bit(scratch.path("r.h5.journal"), 12000);
}

void violate_one(Results& results) {
  results.runs[7].status = RunStatus::violated;
  results.runs[7].violations = 1;
  results.runs[7].message = "crossing: edges 3 and 7";
}

void pass_bounds(Results& results) {
  for (RunRecord& row : results.runs) row.extents[2] *= 1000;
}

void leave_two_unfinished(Results& results) {
  results.runs[5].status = RunStatus::timeout;
  results.runs[9].status = RunStatus::crashed;
}

void refuse_one(Results& results) { results.runs[5].status = RunStatus::refused; }

void refuse_all(Results& results) {
  for (RunRecord& row : results.runs) row.status = RunStatus::refused;
}

class VerdictsAgree : public ::testing::TestWithParam<Situation> {};

TEST_P(VerdictsAgree, InWordsAndExitCodes) {
  const ScratchDirectory scratch;
  scratch.write("study.toml", kJudgedStudy);
  GetParam().make(scratch);
  const std::string in_folder = "cd " + scratch.path("") + " && ";
  const auto expect_said = [&](const std::string& verb, const Outcome& outcome) {
    EXPECT_EQ(outcome.exit_code, GetParam().exit_code) << verb << outcome.out << outcome.err;
    EXPECT_THAT(GetParam().exit_code == 2 ? outcome.err : outcome.out, HasSubstr(GetParam().words))
        << verb;
  };
  std::string problem;
  for (const char* verb :
       {"check r.h5", "report r.h5 -o page.html", "study status r.h5", "study resume -q r.h5"}) {
    const Outcome outcome = run(in_folder + "{} " + verb);
    expect_said(verb, outcome);
    if (problem.empty()) problem = outcome.err;
    if (GetParam().exit_code == 2) {
      EXPECT_EQ(outcome.err, problem) << verb;
    }
  }
  const bool has_page = fs::exists(scratch.path("page.html"));
  EXPECT_EQ(has_page, GetParam().exit_code != 2);
  if (!has_page) return;
  const std::string words = GetParam().words;
  EXPECT_THAT(read_file(scratch.path("page.html")),
              HasSubstr("\n\"rows\":[[\"" + words.substr(0, words.find(':')) + "\","));
}

INSTANTIATE_TEST_SUITE_P(
    Program, VerdictsAgree,
    ::testing::Values(
        Situation{"whole", make_whole, 0, "PASS: 48 rows, 48 proved"},
        Situation{"violated", changed(violate_one), 4, "VIOLATED: 48 rows, 47 proved, 1 violated"},
        Situation{"beyond_the_bound", changed(pass_bounds), 4,
                  "VIOLATED: 48 rows, 0 proved, 48 violated"},
        Situation{"timeouts", changed(leave_two_unfinished), 5,
                  "INCOMPLETE: 48 rows, 46 proved, 0 violated, 2 incomplete"},
        Situation{"refused", changed(refuse_one), 0,
                  "PASS: 48 rows, 47 proved, 0 violated, 0 incomplete, 1 refused"},
        Situation{"all_refused", changed(refuse_all), 5,
                  "INCOMPLETE: 48 rows, 0 proved, 0 violated, 0 incomplete, 48 refused"},
        Situation{"truncated", truncate_results, 2, "r.h5"},
        Situation{"bit_flipped", damage_results, 2, "r.h5"},
        Situation{"journal_bit_flipped", damage_journal, 2, "r.h5.journal"},
        Situation{"absent", [](const ScratchDirectory&) {}, 2, "r.h5"}),
    [](const auto& info) { return std::string(info.param.name); });

// Rows of an unfinished study stand in its results file or in journals; an older results file
// beside a journal is of another study.
class UnfinishedStudy : public ::testing::Test {
 protected:
  void SetUp() override { scratch_.write("study.toml", kJudgedStudy); }
  std::string said(const std::string& verb, const std::string& file) const {
    const Outcome outcome =
        expect_exit(5, run("cd " + scratch_.path("") + " && {} " + verb + " " + file));
    const std::size_t at = outcome.out.find("INCOMPLETE: ");
    return at == std::string::npos ? outcome.out
                                   : outcome.out.substr(at, outcome.out.find('\n', at) - at);
  }
  void expect_agreement() const {
    const std::string first = said("check", "r.h5");
    EXPECT_THAT(first, HasSubstr("INCOMPLETE: "));
    for (const char* verb : {"report -o page.html", "study status"}) {
      EXPECT_EQ(said(verb, "r.h5"), first) << verb;
    }
    EXPECT_THAT(read_file(scratch_.path("page.html")), HasSubstr("\n\"rows\":[[\"INCOMPLETE\","));
    expect_output(run("cd " + scratch_.path("") + " && {} study resume -q r.h5"),
                  "PASS: 48 rows, 48 proved");
    expect_exit(0, run("{} check " + scratch_.path("r.h5")));
  }
  ScratchDirectory scratch_;
};

TEST_F(UnfinishedStudy, WithRowsInItsResultsFile) {
  make_whole(scratch_);
  Results results = read_results(scratch_.path("r.h5"));
  results.runs.resize(30);
  write_results(results, scratch_.path("r.h5"));
  EXPECT_EQ(said("check", "r.h5"),
            "INCOMPLETE: 30 rows, 30 proved, 0 violated, 0 incomplete, 0 refused");
  expect_agreement();
}

TEST_F(UnfinishedStudy, WithRowsInAJournalAlone) {
  make_journal(scratch_);
  EXPECT_EQ(said("check", "r.h5"), said("check", "r.h5.journal"));
  EXPECT_EQ(said("study status", "r.h5"), said("study status", "r.h5.journal"));
  expect_agreement();
}

TEST_F(UnfinishedStudy, WithAnOlderResultsFileBesideItsJournal) {
  make_whole(scratch_);
  fs::rename(scratch_.path("r.h5"), scratch_.path("older.h5"));
  make_journal(scratch_);
  fs::rename(scratch_.path("older.h5"), scratch_.path("r.h5"));
  expect_agreement();
}

}  // namespace
}  // namespace ar3d::testing
