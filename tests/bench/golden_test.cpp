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
     {{"compact", "3a97b18a29908ef8307e26d65689cb97"},
      {"compact-120", "a7e5dcd5ab9a0d72dca9a082c5d9350c"},
      {"diamond", "3a97b18a29908ef8307e26d65689cb97"},
      {"grid", "a7e5dcd5ab9a0d72dca9a082c5d9350c"},
      {"two-bend", "a7e5dcd5ab9a0d72dca9a082c5d9350c"},
      {"two-bend-109", "3a97b18a29908ef8307e26d65689cb97"}}},
    {"metric",
     {{"compact", "b95bdb7f6b56ad602f9387d90abd585d"},
      {"compact-120", "93a0c06b76ed64530527386440b8aee6"},
      {"diamond", "1d9fce23939de82c2c19e17c105b3871"},
      {"grid", "801bcfeeb12bc24bcef39705a0710894"},
      {"two-bend", "febcdc80ece1a6f24a298a833a141720"},
      {"two-bend-109", "90da9e4e5865a7c4cecc9a08617dadf8"}}},
    {"result",
     {{"compact", "7c9d539a8e591c9d4929e54e7ff62abf"},
      {"compact-120", "629150227bd882547a46bef9b68d8da1"},
      {"diamond", "30357c378071c60b71715175a9ffa63f"},
      {"grid", "7176e4d3701dcbb6ae492ead0e507190"},
      {"two-bend", "86e7dd67fd54c8f0c84f902161ebbf44"},
      {"two-bend-109", "af1f9dbb7be9fafa9ffb7f2e925bec37"}}},
    {"run",
     {{"compact", "6dd5ceaddc9f3a4286411463e716f1b9"},
      {"compact-120", "2953b49cb84818c57607973b069389d2"},
      {"diamond", "00edc2c01623ed8ed296b280c4667898"},
      {"grid", "29fc9e470e8edda8c79592e6edff554e"},
      {"two-bend", "a3b55d28bda1ef942ab7cfe942c03f5d"},
      {"two-bend-109", "b6ebcea9fec0bd111058964d8bcd7b9c"}}},
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
        std::string none(column.size, '\0');
        store_missing(column, none.data());
        EXPECT_EQ(record.substr(column.offset, column.size), none) << column.name;
        continue;
      }
      if (column.name == "level") {  // of rows that came before levels, too
        EXPECT_EQ(text_of(column, record.data()), "extents");
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
