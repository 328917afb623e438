// The rows of a study, bit for bit, whatever compiler and machine have made them.
#include <gtest/gtest.h>

#include <map>

#include "ar3d/bench/run/run_study.h"
#include "ar3d/results/columns.h"
#include "ar3d/results/sha256.h"

namespace ar3d {
namespace {

// SHA-256 of all columns of smoke's rows but the measured ones, by algorithm. They change when
// graphs, drawings, metrics, bounds or columns do; then a change of them belongs to that commit.
const std::map<std::string, std::string> kSmoke = {
    {"compact", "e91259128ecca7cd40f66e59284da0287ea7d2a0a3d975715b2ae9861182f111"},
    {"diamond", "a89662e4f51f851e76b97763b55257ce5f0ea351b0b4fb069a23ee4c4d807080"},
    {"grid", "dbca280022f97df89d689dce4ab9d4c819d4cb47691f1e9f6b7450e7df368c3b"},
    {"two-bend", "6aff4ccfb4eb80e0ab8b50773182e0bcc2fce200001461734bcb8d78487672ad"},
};

TEST(Golden, RowsOfSmoke) {
  std::map<std::string, std::string> bytes;
  std::string record(run_record_size(), '\0');
  for (const ar3d::RunRecord& run : run_study(load_study("smoke"), {.threads = 2}).runs) {
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
