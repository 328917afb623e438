// The rows of a study, bit for bit, whatever compiler and machine have made them.
#include <map>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/store/columns/run_columns.h"
#include "bench/in_memory.h"

namespace ar3d::testing {
namespace {

using Digests = std::map<std::string, std::string>;

// XXH3-128 of the columns of smoke's rows, by group of columns and algorithm. A digest changes with
// what it is of: `instance` with the families, `run` with plan and keys, `result` with drawings,
// verdicts and counters, `metric` with the table of metrics; then the change belongs to that
// commit.
const std::map<std::string, Digests> kSmoke = {
    {"instance",
     {{"compact", "45d3a098b5ce009cd4043fa0391335c8"},
      {"compact-120", "c3a9603608f03bd60b55129f1ef457b9"},
      {"diamond", "45d3a098b5ce009cd4043fa0391335c8"},
      {"grid", "c3a9603608f03bd60b55129f1ef457b9"},
      {"two-bend", "c3a9603608f03bd60b55129f1ef457b9"},
      {"two-bend-109", "45d3a098b5ce009cd4043fa0391335c8"}}},
    {"metric",
     {{"compact", "c95df431b28bf9d8c5d1f7f0f661cfd8"},
      {"compact-120", "4e1f8dabaf66da364cba101afc91103b"},
      {"diamond", "a9f606a00c3c16e1697ab6c7c567240d"},
      {"grid", "f3b280fc923ca3aab0a1428c02acfdc8"},
      {"two-bend", "af4c172924b9738a3a0c455998664d36"},
      {"two-bend-109", "3bd485553671101f9390797dab89556b"}}},
    {"result",
     {{"compact", "53efc76320cea9bcf430ce1b38709118"},
      {"compact-120", "caeee73ab434766588b62cb25d493a1b"},
      {"diamond", "2dbc4b6ca972de526690e9b95523e1ad"},
      {"grid", "0189df81a7ef317311ff22f1d71c6aaf"},
      {"two-bend", "27308f4f505148d1651b453f7da569ba"},
      {"two-bend-109", "2766ce10c6e1ae5915d05e5049098314"}}},
    {"run",
     {{"compact", "fc6eec179e7a064e88acaaeaa3f282d9"},
      {"compact-120", "5fbda53eb559aee05799e103a6131d05"},
      {"diamond", "1273d6bfc58a3ca1578f9ed301979ab6"},
      {"grid", "2a391a9af39b705d020ea9eb3b1f189d"},
      {"two-bend", "12d2a177c046c0bba6099fd12f8af063"},
      {"two-bend-109", "b3f8baf83ded069ae0a9f58eaa905427"}}},
};

const std::map<ColumnKind, const char*> kGroups = {{ColumnKind::instance, "instance"},
                                                   {ColumnKind::run, "run"},
                                                   {ColumnKind::result, "result"},
                                                   {ColumnKind::metric, "metric"}};

/// A column that says something of drawings in real types only; smoke has none.
bool is_of_real_types(const Column& column) {
  return column.name == "certificate" || column.meaning.starts_with("in a real type");
}

TEST(Golden, RowsOfSmoke) {
  std::map<std::string, Digests> bytes;
  std::string record(run_record_size(), '\0');
  for (const RunRecord& run : run_study(load_study("smoke"), {.workers = 2}).runs) {
    EXPECT_EQ(run.status, RunStatus::ok) << run.row_key << ": " << run.message;
    store_record(run, record.data());
    for (const Column& column : run_columns()) {
      if (column.kind == ColumnKind::measured) continue;
      if (is_of_real_types(column)) {
        EXPECT_THAT(column_text(column, run), AnyOf("", "-1", "nan")) << column.name;
        continue;
      }
      if (column.name == "level") {  // of rows that came before levels, too
        EXPECT_EQ(column_text(column, run), "extents");
        continue;
      }
      bytes[kGroups.at(column.kind)][run.algorithm].append(record, column.offset, column.size);
    }
  }
  for (auto& [group, of_algorithms] : bytes) {
    for (auto& [algorithm, all] : of_algorithms) all = content_hash(all);
  }
  EXPECT_EQ(bytes["run"].size(), proved_algorithms().size());
  EXPECT_EQ(bytes, kSmoke);
}

}  // namespace
}  // namespace ar3d::testing
