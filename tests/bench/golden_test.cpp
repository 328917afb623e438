// The rows of a study, bit for bit, whatever compiler and machine have made them.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "ar3d/records/run_columns.h"
#include "bench/in_memory.h"

namespace ar3d {
namespace {

using Digests = std::map<std::string, std::string>;

// XXH3-128 of the columns of smoke's rows, by group of columns and algorithm. A digest changes with
// what it is of: `instance` with the families, `run` with plan and keys, `result` with drawings,
// verdicts and counters, `metric` with the table of metrics; then the change belongs to that
// commit.
const std::map<std::string, Digests> kSmoke = {};

const char* name_of(ColumnKind kind) {
  switch (kind) {
    case ColumnKind::instance:
      return "instance";
    case ColumnKind::run:
      return "run";
    case ColumnKind::result:
      return "result";
    case ColumnKind::metric:
      return "metric";
    case ColumnKind::measured:
      break;
  }
  return "measured";
}

TEST(Golden, RowsOfSmoke) {
  std::map<std::string, Digests> bytes;
  std::string record(run_record_size(), '\0');
  for (const ar3d::RunRecord& run : testing::run_study(load_study("smoke"), {.workers = 2}).runs) {
    store_record(run, record.data());
    for (const Column& column : run_columns()) {
      if (column.kind == ColumnKind::measured) continue;
      bytes[name_of(column.kind)][run.algorithm].append(record, column.offset, column.size);
    }
  }
  for (auto& [group, of_algorithms] : bytes) {
    for (auto& [algorithm, all] : of_algorithms) all = content_hash(all);
  }
  EXPECT_EQ(bytes, kSmoke);
}

}  // namespace
}  // namespace ar3d
