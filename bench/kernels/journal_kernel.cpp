// What keeping a row costs, nanoseconds per row, without fsync on either side:
//   journal/append          a row into a journal: one write(2), acknowledged
//   journal/sqlite_wal      the same row into SQLite (WAL, synchronous = OFF), one transaction
//   each:
//                           the same promise
//   journal/sqlite_wal_1000 a thousand rows per transaction: up to a thousand rows may be lost
//   study/bare_loop/N       random cubic graphs of N vertices, 500 per iteration: generated,
//   hashed,
//                           drawn with grid, hashed, certified and measured in a plain loop on one
//                           thread
//   study/bare_loop_unhashed/N  the same without the two hashes
//                           (N = 4: K4, whose drawing costs next to nothing, so that the time is
//                           what a row costs besides)
//   study/journaled/N/T     the same as rows of a study on T threads with its journal
//     besides (of both)     what a row's thread does beside generating, drawing and certifying: two
//                           hashes, metrics, and whatever else it costs; a difference of 1 % of
//                           the row is far clearer in it than in the time
//   journal/status          looking how far a study with so many rows is (parameter)

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <malloc.h>
#include <sqlite3.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/journal/journal_reader.h"
#include "ar3d/store/journal/journal_writer.h"
#include "ar3d/store/run_storage.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/metrics/metrics.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

// A folder of its own on the disk that the program is run on.
class Folder {
 public:
  Folder() : path_(fs::current_path() / "ar3d_journal_kernel") {
    fs::remove_all(path_);
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

StudyIdentity identity() {
  StudyIdentity identity;
  identity.study_id = "kernel";
  identity.spec_hash = std::string(64, 'a');
  return identity;
}

RunRecord typical_run() {
  RunRecord run;
  run.row_key = "0123456789abcdef0123456789abcdef";
  run.family = "random-cubic";
  run.requested_n = run.n = 1000;
  run.m = 1500;
  run.instance_index = 17;
  run.seed = 0x123456789abcdef;
  run.graph_hash = "fedcba9876543210fedcba9876543210";
  run.algorithm = "grid";
  run.options = "effort=1";
  run.repetition = 0;
  run.status = RunStatus::ok;
  run.extents = {50, 5000, 5000};
  run.counters = "bodies=12;flats=3;labels=1000";
  run.wall_s = 7e-4;
  return run;
}

void append_kernel(benchmark::State& state) {
  const Folder folder;
  JournalWriter journal(folder.file("k.journal"), identity(), run_format());
  journal.begin_session({});
  const RunRecord run = typical_run();
  for (auto _ : state) append_run(journal, run);
  state.SetItemsProcessed(state.iterations());
}

class Database {
 public:
  explicit Database(const std::string& path) {
    if (sqlite3_open(path.c_str(), &database_) != SQLITE_OK) throw std::runtime_error("sqlite3");
    execute("PRAGMA journal_mode=WAL");
    execute("PRAGMA synchronous=OFF");
    std::string columns;
    std::string places;
    for (const Column& column : run_columns()) {
      columns += (columns.empty() ? "" : ", ") + column.name;
      places += places.empty() ? "?" : ", ?";
    }
    execute("CREATE TABLE runs (" + columns + ")");
    const std::string insert = "INSERT INTO runs VALUES (" + places + ")";
    sqlite3_prepare_v2(database_, insert.c_str(), -1, &insert_, nullptr);
  }
  ~Database() {
    sqlite3_finalize(insert_);
    sqlite3_close(database_);
  }
  void execute(const std::string& sql) {
    if (sqlite3_exec(database_, sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
      throw std::runtime_error(sqlite3_errmsg(database_));
    }
  }
  void append(const RunRecord& run) {
    store_record(run, record_.data());
    int place = 0;
    for (const Column& column : run_columns()) bind(++place, column);
    if (sqlite3_step(insert_) != SQLITE_DONE) throw std::runtime_error(sqlite3_errmsg(database_));
    sqlite3_reset(insert_);
  }

 private:
  void bind(int place, const Column& column) {
    const char* field = record_.data() + column.offset;
    if (column.type == FieldType::text) {
      const auto length = static_cast<int>(strnlen(field, column.size));
      sqlite3_bind_text(insert_, place, field, length, SQLITE_STATIC);
    } else if (column.type == FieldType::float64) {
      double number = 0;
      std::memcpy(&number, field, sizeof(number));
      sqlite3_bind_double(insert_, place, number);
    } else {
      std::int64_t number = 0;
      std::memcpy(&number, field, sizeof(number));
      sqlite3_bind_int64(insert_, place, number);
    }
  }

  sqlite3* database_ = nullptr;
  sqlite3_stmt* insert_ = nullptr;
  std::vector<char> record_ = std::vector<char>(run_record_size());
};

void sqlite_kernel(benchmark::State& state, std::int64_t rows_a_transaction) {
  const Folder folder;
  Database database(folder.file("k.sqlite"));
  const RunRecord run = typical_run();
  std::int64_t row = 0;
  for (auto _ : state) {
    if (row % rows_a_transaction == 0) database.execute("BEGIN");
    database.append(run);
    if (++row % rows_a_transaction == 0) database.execute("COMMIT");
  }
  if (row % rows_a_transaction != 0) database.execute("COMMIT");
  state.SetItemsProcessed(state.iterations());
}

void status_kernel(benchmark::State& state) {
  const Folder folder;
  {
    JournalWriter journal(folder.file("k.journal"), identity(), run_format());
    journal.begin_session({});
    const RunRecord run = typical_run();
    for (std::int64_t i = 0; i < state.range(0); ++i) append_run(journal, run);
  }
  for (auto _ : state)
    benchmark::DoNotOptimize(journal_status(folder.file("k.journal"), run_format()).rows);
}

constexpr std::int64_t kGraphs = 500;

StudyPlan cubic_plan(std::int64_t n) {
  return plan_study(
      parse_study(fmt::format("study = \"k\"\n[[sweep]]\nfamilies = \"random-cubic\"\n"
                              "sizes = {}\nalgorithms = \"grid\"\ninstances = {}\n",
                              n, kGraphs),
                  "kernel.toml"));
}

// Returning the end of the heap to the system and asking for it again costs up to 2 %, or nothing,
// by the luck of what lies last; so neither loop does.
void keep_heap() {
  mallopt(M_TRIM_THRESHOLD, 256 << 20);
  mallopt(M_TOP_PAD, 16 << 20);
}

// The kernel's counter `besides`, seconds per row.
class Besides {
 public:
  void add(double part_s) { parts_s_ += part_s; }
  void report(benchmark::State& state, std::int64_t threads) {
    const auto rows = static_cast<double>(state.iterations() * kGraphs);
    state.counters["besides"] = (time_.wall_s() * static_cast<double>(threads) - parts_s_) / rows;
  }

 private:
  Stopwatch time_;
  double parts_s_ = 0;
};

void bare_kernel(benchmark::State& state, bool hash) {
  keep_heap();
  const OneThread one_thread;
  const StudyPlan plan = cubic_plan(state.range(0));
  const std::vector<PlannedInstance> instances(plan.instances.begin(), plan.instances.end());
  const Algorithm& grid = find_algorithm("grid");
  Besides besides;
  const auto timed = [&](const auto& step) {
    const Stopwatch time;
    auto result = step();
    besides.add(time.wall_s());
    return result;
  };
  for (auto _ : state) {
    for (const PlannedInstance& instance : instances) {
      const Graph graph = timed([&] {
        return generate(*instance.choice.family, instance.n, instance.seed,
                        instance.choice.parameters);
      });
      if (hash) benchmark::DoNotOptimize(graph_hash(graph).data());
      const Drawing drawing =
          timed([&] { return draw(grid, graph, instance.runs.front().choice.options); });
      if (hash) benchmark::DoNotOptimize(drawing_hash(drawing).data());
      const Certificate certificate =
          timed([&] { return certify(graph, drawing, grid.guarantee); });
      benchmark::DoNotOptimize(certificate.violations.size());
      benchmark::DoNotOptimize(measure(drawing).total_edge_length);
    }
  }
  besides.report(state, 1);
  state.SetItemsProcessed(state.iterations() * kGraphs);
}

class MeasuringSink final : public RowSink {
 public:
  MeasuringSink(JournalWriter& journal, Besides& besides) : journal_(journal), besides_(besides) {}
  void add(std::size_t, const RunRecord& run) override {
    append_run(journal_, run);
    besides_.add(run.generate_s + run.wall_s + run.certify_s);
  }

 private:
  JournalWriter& journal_;
  Besides& besides_;
};

void journaled_kernel(benchmark::State& state) {
  keep_heap();
  const StudyPlan plan = cubic_plan(state.range(0));
  const Folder folder;
  JournalWriter journal(folder.file("k.journal"), identity(), run_format());
  journal.begin_session({});
  Besides besides;
  MeasuringSink sink(journal, besides);
  SessionPolicy policy;
  policy.workers = static_cast<int>(state.range(1));
  for (auto _ : state) run_session(plan, policy, sink);
  besides.report(state, state.range(1));
  state.SetItemsProcessed(state.iterations() * kGraphs);
}

BENCHMARK_CAPTURE(bare_kernel, , true)
    ->Name("study/bare_loop")
    ->Arg(4)
    ->Arg(250)
    ->Arg(300)
    ->Arg(700)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(bare_kernel, , false)
    ->Name("study/bare_loop_unhashed")
    ->Arg(250)
    ->Arg(700)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(journaled_kernel)
    ->Name("study/journaled")
    ->ArgsProduct({{4, 250, 300, 700}, {1, 2}})
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(append_kernel)->Name("journal/append");
BENCHMARK_CAPTURE(sqlite_kernel, 1, 1)->Name("journal/sqlite_wal");
BENCHMARK_CAPTURE(sqlite_kernel, 1000, 1000)->Name("journal/sqlite_wal_1000");
BENCHMARK(status_kernel)->Name("journal/status")->Arg(10)->Arg(1000000);

}  // namespace
}  // namespace ar3d
