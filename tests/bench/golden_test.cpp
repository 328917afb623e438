// The rows of a study, bit for bit, whatever compiler and machine have made them.
#include <gtest/gtest.h>

#include <map>

#include "ar3d/results/columns.h"
#include "ar3d/results/sha256.h"
#include "bench/in_memory.h"

namespace ar3d {
namespace {

// SHA-256 of all columns of smoke's rows but the measured ones, by algorithm. They change when
// graphs, drawings, metrics, bounds or columns do; then a change of them belongs to that commit.
const std::map<std::string, std::string> kSmoke = {
    {"compact", "097ca7aba299eedd231d22e5949cdb3e74c226a96d811e66f0dc3e2b637a55dd"},
    {"diamond", "16363cdc7a6b69e8400d7b3df6a097911041bd61bc409208adf7465aa0e7d8bb"},
    {"grid", "1ef346bb4f553044e76a76cda49649d4bbbe79eec0e1829020666c2927889fab"},
    {"two-bend", "1784f00ca0579186a3f78265ea9095ff42bc8f1076169ad4cb8c1ca09d25372c"},
};

TEST(Golden, RowsOfSmoke) {
  std::map<std::string, std::string> bytes;
  std::string record(run_record_size(), '\0');
  for (const ar3d::RunRecord& run : testing::run_study(load_study("smoke"), {.workers = 2}).runs) {
    store_record(run, record.data());
    for (const Column& column : run_columns()) {
      if (column.kind == ColumnKind::measured) continue;
      bytes[run.algorithm].append(record, column.offset, column.size);
    }
  }
  std::map<std::string, std::string> digests;
  for (const auto& [algorithm, all] : bytes) digests[algorithm] = sha256(all);
  EXPECT_EQ(digests, kSmoke);
}

}  // namespace
}  // namespace ar3d
