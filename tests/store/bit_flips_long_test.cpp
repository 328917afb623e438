// Every single bit of a journal, and of every 17th byte of a results file, flipped: nothing is
// accepted with another value, nothing crashes and nothing hangs (docs/study.md, Nothing is lost).
#include <fmt/format.h>

#include <fstream>

#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/rows.h"
#include "store/forged.h"
#include "store/sample_runs.h"
#include "support/program.h"
#include "support/results.h"

namespace ar3d::testing {
namespace {

constexpr std::int64_t kRows = 3;

struct Counts {
  std::size_t refused = 0;
  std::size_t cut = 0;  // fewer rows, as after a crash
};

// Flips every bit of every `step`-th byte in turn. `rows` gives the rows' bytes, or refuses it.
template <class Rows>
Counts flip_every_bit(const std::string& path, std::size_t step, const Rows& rows) {
  const std::string whole = read_file(path);
  const std::vector<std::string> right = rows();
  Counts counts;
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += bit % 8 == 7 ? 8 * step - 7 : 1) {
    std::string flipped = whole;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    std::ofstream(path, std::ios::binary | std::ios::trunc) << flipped;
    std::vector<std::string> read;
    if (!problem([&] { read = rows(); }).empty()) {
      ++counts.refused;
      continue;
    }
    EXPECT_LT(read.size(), right.size()) << "bit " << bit << " is accepted";
    for (std::size_t i = 0; i < read.size(); ++i) EXPECT_EQ(read[i], right[i]) << bit;
    ++counts.cut;
  }
  fmt::print("{} flips, {} refused, {} with fewer rows\n", counts.refused + counts.cut,
             counts.refused, counts.cut);
  return counts;
}

TEST(BitFlips, OfAResultsFileAreRefused) {
  const ScratchDirectory scratch;
  const std::string path = scratch.path("r.h5");
  write_results(sample_results(kRows), path);
  const Counts counts = flip_every_bit(path, 17, [&] {
    std::vector<std::string> rows;
    for (const RunRecord& run : read_results(path).runs) rows.push_back(all_bytes(run));
    return rows;
  });
  EXPECT_EQ(counts.cut, 0u);
}

TEST(BitFlips, OfAJournalAreRefusedOrCutTheLastRow) {
  const ScratchDirectory scratch;
  const std::string path = scratch.path("r.h5.journal");
  {
    JournalWriter journal(path, sample_identity());
    journal.begin_session({{"cpu", "abacus"}});
    for (std::int64_t i = 0; i < kRows; ++i) journal.append(sample_run(i));
  }
  flip_every_bit(path, 1, [&] {
    const JournalReader reader(path);
    std::vector<std::string> rows(reader.size(), std::string(run_record_size(), '\0'));
    for (std::size_t i = 0; i < rows.size(); ++i) reader.read(i, rows[i].data());
    return rows;
  });
}

// Forged files have a right checksum, so HDF5 sees them, and crashes on some.
TEST(ForgedFiles, CrashNothing) {
  const ForgedReads reads = read_forged_files(2400, 2);
  fmt::print("{} read, {} refused, {} of them by a crash of their own process\n", reads.read,
             reads.refused, reads.crashed);
  EXPECT_EQ(reads.read + reads.refused, 2400);
}

}  // namespace
}  // namespace ar3d::testing
