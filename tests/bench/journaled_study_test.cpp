// A study, its journals and its results file: who may write them when, and what is there at the
// end.
#include "ar3d/bench/keep/journaled_study.h"

#include <functional>
#include <map>

#include "ar3d/base/error.h"
#include "ar3d/bench/keep/study_files.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/rows.h"
#include "support/problem.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

// Twelve rows that are needed and ten that precision may ask for.
const char* const kSpec = R"(study = "s"
[[sweep]]
families = "random-cubic"
sizes = 20
algorithms = "grid"
instances = 2
timed_repetitions = { precision = 1e-6, min = 6, max = 11 }
strong = { threads = 1 }
)";
constexpr std::size_t kNeeded = 2 * (1 + 6 + 1);
constexpr std::size_t kAll = 2 * (1 + 11 + 1);

// A process that is alone and does something whenever a step ends.
class Onlooker final : public Ranks {
 public:
  explicit Onlooker(std::function<void()> look) : look_(std::move(look)) {}
  std::string agree(const std::string& failure) override {
    look_();
    return failure;
  }

 private:
  std::function<void()> look_;
};

class JournaledStudyFiles : public ::testing::Test {
 protected:
  JournaledStudy begin() const {
    return new_study(load_study(scratch_.write("s.toml", kSpec)), {}, results());
  }
  std::string results() const { return scratch_.path("s.h5"); }
  StudyOutcome finish(const JournaledStudy& study) const {
    Ranks alone;
    return run_journaled(study, policy(), alone);
  }
  static SessionPolicy policy() {
    SessionPolicy policy;
    policy.force_timing = true;
    return policy;
  }
  // Puts the rows [from, to) of the results file into a journal.
  void put_into_journal(const std::string& path, std::size_t from, std::size_t to) const {
    const Rows rows(results());
    JournalWriter journal(path, rows.identity());
    journal.begin_session(rows.environment());
    for (std::size_t i = from; i < to; ++i) journal.append_record(record_of(rows.run(i)).data());
  }
  std::map<std::string, std::string> rows() const {
    std::map<std::string, std::string> rows;
    for (const RunRecord& row : read_results(results()).runs) rows[row.row_key] = all_bytes(row);
    return rows;
  }

  ScratchDirectory scratch_;
};

TEST_F(JournaledStudyFiles, AreLockedUntilTheResultsAreWritten) {
  std::size_t locked = 0;
  Onlooker ranks([&] {
    if (!fs::exists(journal_path(results()))) return;
    EXPECT_EQ(journal_status(journal_path(results())).writers, 1);
    ++locked;
  });
  const JournaledStudy study = begin();
  EXPECT_TRUE(run_journaled(study, policy(), ranks).complete());
  EXPECT_EQ(locked, 5u) << "journal made, leftovers gone, rows read, session begun and ended";
}

TEST_F(JournaledStudyFiles, AStudyThatAnotherProcessFinishesMeanwhileIsNotMadeAgain) {
  finish(begin());
  const std::string journal = journal_path(results());
  put_into_journal(journal, 0, kNeeded);
  const JournaledStudy late = begun_study(journal);
  ASSERT_TRUE(late.has_journals);
  EXPECT_TRUE(finish(begun_study(journal)).complete());
  const std::string before = read_file(results());
  EXPECT_THAT(problem([&] { finish(late); }), HasSubstr("another process has finished the study"))
      << "two processes have made one study";
  EXPECT_EQ(read_file(results()), before);
}

TEST_F(JournaledStudyFiles, RowsStayAsTheyAreWhereRemovingTheJournalsWasCutShort) {
  finish(begin());
  const auto before = rows();
  EXPECT_EQ(before.size(), kAll);
  put_into_journal(journal_path(results(), 1), 0, 3);
  const JournaledStudy study = begun_study(results());
  EXPECT_TRUE(study.seed_from_results);
  EXPECT_TRUE(outcome_so_far(study).complete());
  EXPECT_TRUE(finish(study).complete());
  EXPECT_EQ(rows(), before);
  EXPECT_TRUE(existing_journals(results()).empty());
}

TEST_F(JournaledStudyFiles, RowsForPrecisionDoNotMakeUpForMissingOnes) {
  finish(begin());
  put_into_journal(journal_path(results()), 0, kAll - 1);
  EXPECT_EQ(outcome_so_far(begun_study(results())).missing, 1u);
  const std::string snapshot = scratch_.path("snapshot.h5");
  EXPECT_EQ(write_snapshot(begun_study(results()), snapshot).missing, 1u);
  const Outcome status = expect_exit(5, run("{} study status " + results()));
  EXPECT_THAT(status.out, HasSubstr("25 of 26 rows, stopped"));
  expect_exit(5, run("{} study status " + snapshot));
  expect_output(run("{} check " + snapshot), "INCOMPLETE: 1 of 26 rows are missing", 5);
}

TEST_F(JournaledStudyFiles, ASnapshotOfAFinishedStudyHasItsRowsAndNeverReplacesIt) {
  finish(begin());
  const std::string before = read_file(results());
  const JournaledStudy study = begun_study(results());
  EXPECT_EQ(write_snapshot(study, scratch_.path("snapshot.h5")).rows, kAll);
  EXPECT_EQ(read_results(scratch_.path("snapshot.h5")).runs.size(), kAll);
  EXPECT_THROW(write_snapshot(study, results()), InputError);
  put_into_journal(journal_path(results()), 0, 1);
  EXPECT_THROW(write_snapshot(begun_study(results()), journal_path(results())), InputError);
  EXPECT_EQ(read_file(results()), before);
}

}  // namespace
}  // namespace ar3d::testing
