// The rows of a study, bit for bit, whatever compiler and machine have made them.
#include <gtest/gtest.h>

#include <map>

#include "ar3d/bench/run_study.h"
#include "ar3d/results/columns.h"
#include "ar3d/results/sha256.h"

namespace ar3d {
namespace {

// SHA-256 of all columns of smoke's rows but the measured ones, by algorithm. They change when
// graphs, drawings, metrics, bounds or columns do; then a change of them belongs to that commit.
const std::map<std::string, std::string> kSmoke = {
    {"diamond", "f19a001351d003c4c1cb6117d26d678df6893fc1ff593756bef70cf3bac585c3"},
    {"grid", "b079e0251f85582ef96e51baabaa85cba54d76dfa69a67078e529a8a1516427f"},
    {"two-bend", "32d7b2e9cee38921b77e94f5e0c3ddc408b66aaa0447d5c36be52c6437a17fe2"},
};

TEST(Golden, RowsOfSmoke) {
  std::map<std::string, std::string> bytes;
  std::string record(run_record_size(), '\0');
  for (const ar3d::Run& run : run_study(load_study("smoke"), {.threads = 2}).runs) {
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
