// A study is killed at every call that changes a file, one after the other: in all phases, in
// worker processes, and over MPI.
#include <fmt/format.h>

#include <fstream>

#include "apps/failing_rank.h"
#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

const char* const kPhases = R"(study = "phases"
[[sweep]]
families = "random-cubic"
sizes = [10, 20]
algorithms = "grid"
instances = 2
timed_repetitions = 2
strong = { threads = 1, drawings = 2 }
)";

class KilledEverywhere : public ::testing::Test {
 protected:
  // Kills `program` at every step-th call before, in the middle of and after it; returns how often.
  int kill_everywhere(const std::string& program, const std::string& options, int step) {
    const std::string spec = scratch_.write("s.toml", kPhases);
    expect_exit(0, run("{} study run -q --force-timing " + spec + " -o " + scratch_.path("w.h5")));
    int kills = 0;
    for (const char* kind : {"before", "half", "after"}) {
      for (int call = 1;; call += step) {
        const std::string results = scratch_.path("r.h5");
        for (const auto& entry : fs::directory_iterator(scratch_.path(""))) {
          if (entry.path().filename().string().starts_with("r.")) fs::remove(entry.path());
        }
        const std::string witness = scratch_.path("witness");
        std::ofstream(witness, std::ios::binary).write("\0\0\0\0\0\0\0\0", 8);
        const std::string fault =
            with_fault(fmt::format("{}:{}", kind, call)) + "AR3D_ACKNOWLEDGED=" + witness + " ";
        std::string command = program;
        command.replace(command.find("FAULT"), 5, fault);
        const Outcome outcome = run(command + " study run -q --force-timing " + options + " " +
                                    spec + " -o " + results);
        if (outcome.exit_code == 0) break;
        ++kills;
        expect_acknowledged(results + ".journal", witness);
        // Over MPI the journal of the second rank may be there before that of the first.
        const bool begun = fs::exists(results + ".journal") || fs::exists(results) ||
                           fs::exists(results + ".rank-1.journal");
        expect_exit(
            0, run("{} study " + (begun ? "resume " + results : "run " + spec + " -o " + results) +
                   " -q --force-timing"));
        expect_same_rows(results, scratch_.path("w.h5"));
        if (HasFailure()) {
          ADD_FAILURE() << kind << ' ' << call;
          return kills;
        }
      }
    }
    fmt::print("{} kills\n", kills);
    return kills;
  }

 private:
  static void expect_acknowledged(const std::string& journal, const std::string& witness) {
    long acknowledged = 0;
    std::ifstream(witness, std::ios::binary).read(reinterpret_cast<char*>(&acknowledged), 8);
    if (!fs::exists(journal)) return;  // not made yet, or the results file has the rows
    const auto whole =
        scan_journal(open_input(journal).get(), journal, [](const JournalRecord&) { return true; });
    EXPECT_GE(static_cast<long>(whole), acknowledged);
  }
  ScratchDirectory scratch_;
};

TEST_F(KilledEverywhere, InThreads) { EXPECT_GE(kill_everywhere("FAULT{}", "--threads 2", 1), 60); }

TEST_F(KilledEverywhere, InWorkers) {
  EXPECT_GE(kill_everywhere("FAULT{}", "--threads 2 --isolate", 1), 60);
}

TEST_F(KilledEverywhere, OverMpi) {
  EXPECT_GE(kill_everywhere(std::string("mpirun --allow-run-as-root --oversubscribe -n 2 FAULT") +
                                AR3D_MPI_PROGRAM,
                            "", 4),
            20);
}

// No call of one rank can fail so that the other waits for it.
TEST(FailingRank, EndsAllAtEveryCall) {
  const ScratchDirectory scratch;
  must("{} study run smoke -q -o " + scratch.path("whole.h5"));
  for (const int rank : {0, 1}) {
    int call = 1;
    while (expect_failure_ends_all(scratch, scratch.path("whole.h5"), rank, call)) ++call;
    EXPECT_GT(call, 10);
  }
}

}  // namespace
}  // namespace ar3d::testing
