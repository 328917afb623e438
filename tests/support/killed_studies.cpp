#include "support/killed_studies.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "ar3d/base/random.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/rows.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

namespace fs = std::filesystem;

const char* const kStudy = R"(study = "killed"
[[sweep]]
families = ["random-cubic", "generalised-petersen", "random-tree"]
sizes = [50, 120, 300]
algorithms = "all"
instances = 4
repetitions = 2
)";

// A study that is killed again and again, and what is known of it.
class KilledStudy {
 public:
  KilledStudy(const ScratchDirectory& scratch, int number, RandomStream& random)
      : random_(random),
        spec_(scratch.path("killed.toml")),
        results_(scratch.path(fmt::format("{}.h5", number))),
        journal_(results_ + ".journal"),
        witness_(results_ + ".acknowledged") {}

  const std::string& results() const { return results_; }

  /// One attempt to finish it, with a kill on the way. @return its exit code.
  int attempt() {
    const bool begun = fs::exists(journal_) || fs::exists(results_);
    const std::string verb = begun ? "resume " + results_ : "run " + spec_ + " -o " + results_;
    std::ofstream(witness_, std::ios::binary).write("\0\0\0\0\0\0\0\0", 8);
    const Outcome outcome =
        run(fmt::format("{} {{}} study {} -q --threads 2", disturbance(), verb));
    EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 137)
        << outcome.exit_code << ' ' << outcome.err;
    return outcome.exit_code;
  }

  /// After a kill: nothing that was acknowledged is gone or changed.
  void check_journal() {
    if (!fs::exists(journal_)) {
      EXPECT_TRUE(kept_.empty() || fs::exists(results_)) << "the journal is gone before its time";
      return;
    }
    const JournalReader reader(journal_);
    std::map<std::string, std::string> rows;
    std::string record(run_record_size(), '\0');
    for (std::size_t i = 0; i < reader.size(); ++i) {
      reader.read(i, record.data());
      rows[to_string(reader.key(i))] = record;
    }
    EXPECT_EQ(rows.size(), reader.size()) << "no row is there twice";
    for (const auto& [key, bytes] : kept_) {
      const auto now = rows.find(key);
      EXPECT_TRUE(now != rows.end() && now->second == bytes)
          << "row " << key << " is lost or changed";
    }
    long acknowledged = 0;
    std::ifstream(witness_, std::ios::binary).read(reinterpret_cast<char*>(&acknowledged), 8);
    const auto whole = scan_journal(open_input(journal_).get(), journal_,
                                    [](const JournalRecord&) { return true; });
    EXPECT_GE(static_cast<long>(whole), acknowledged) << "acknowledged bytes are lost";
    kept_ = std::move(rows);
  }

  /// Once complete: rows that were acknowledged on the way are the rows of the results.
  void check_results() const {
    std::map<std::string, ar3d::RunRecord> rows;
    for (const ar3d::RunRecord& row : read_results(results_).runs) rows[row.row_key] = row;
    for (const auto& [key, bytes] : kept_) {
      EXPECT_EQ(bytes, all_bytes(rows.at(key))) << key;
    }
  }

 private:
  std::string disturbance() {
    const std::string shim =
        fmt::format("ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD={} AR3D_ACKNOWLEDGED={}",
                    AR3D_FAULT_SHIM, witness_);
    static const char* const kinds[] = {"before", "half", "after"};
    if (random_.below(2) == 0) {
      return fmt::format("timeout --preserve-status -s KILL 0.{:03} env {}", 1 + random_.below(120),
                         shim);
    }
    return fmt::format("env {} AR3D_FAULT={}:{}", shim, kinds[random_.below(3)],
                       1 + random_.below(60));
  }

  RandomStream& random_;
  std::string spec_;
  std::string results_;
  std::string journal_;
  std::string witness_;
  std::map<std::string, std::string> kept_;
};

}  // namespace

void kill_and_resume(int kills, std::uint64_t seed) {
  const ScratchDirectory scratch;
  scratch.write("killed.toml", kStudy);
  const std::string whole = scratch.path("whole.h5");
  ASSERT_EQ(run("{} study run -q " + scratch.path("killed.toml") + " -o " + whole).exit_code, 0);
  RandomStream random(seed);
  int done = 0;
  int finished = 0;
  for (int number = 0; done < kills; ++number) {
    KilledStudy study(scratch, number, random);
    while (study.attempt() != 0) {
      if (::testing::Test::HasFailure()) return;
      ++done;
      study.check_journal();
    }
    expect_same_rows(study.results(), whole);
    study.check_results();
    EXPECT_EQ(run("ls " + scratch.path("*.journal") + " " + scratch.path("*.partial-*")).out, "");
    ++finished;
    if (::testing::Test::HasFailure()) return;
  }
  fmt::print("{} kills, {} studies finished and equal\n", done, finished);
}

}  // namespace ar3d::testing
