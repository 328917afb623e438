// The columns of /runs, one line each, and what is made of a row by them.
#include "ar3d/store/columns/run_columns.h"

#include <fmt/format.h>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr std::array<const char*, 3> kAxes = {"_x", "_y", "_z"};
constexpr std::array<const char*, 3> kYardstickColumns = {
    "yardstick_cached_s", "yardstick_memory_s", "yardstick_arithmetic_s"};

// In a row that is written all are constant.
template <class Run>
void identity_columns(RecordPass& c, Run& r) {
  c.next_are(ColumnKind::run, true);
  c.text("row_key", 32, r.row_key,
         "hash of study seed, instance, algorithm, options and repetition");
  c.next_are(ColumnKind::instance, true);
  c.text("family", 48, r.family, "family of graphs");
  c.text("parameters", 128, r.parameters, "the family's parameters, complete, in catalogue order");
  c.number("requested_n", "1", r.requested_n, "vertices that the study asked for");
  c.number("n", "1", r.n, "vertices");
  c.number("m", "1", r.m, "edges");
  c.number("instance_index", "1", r.instance_index,
           "0, 1, ...: which instance of (family, parameters, requested_n)");
  c.number("seed", "", r.seed, "the generator's seed of this instance");
  c.text("graph_hash", 32, r.graph_hash, "128-bit hash of the graph");
  c.next_are(ColumnKind::instance, false);
  c.message("graph_name", 96, r.graph_name,
            "of a graph of files: its file in the collection, #3 behind it if that holds several");
  c.text("group", 48, r.group, "of a graph of a collection: sub-folder, or as a table says");
  c.number("max_degree", "1", r.max_degree, "largest degree of a vertex");
  c.next_are(ColumnKind::run, true);
  c.text("algorithm", 48, r.algorithm, "drawing algorithm");
  c.text("options", 96, r.options, "the algorithm's options, complete, in catalogue order");
  c.choice("phase", 8, r.phase, parse_run_phase,
           "what the row was made for: metrics, timing, strong, weak, strong_r, weak_r");
  c.number("scale", "1", r.workers, "threads (strong, weak) or ranks (_r) that share the batch");
  c.number("repetition", "1", r.repetition, "0, 1, ...: which one within its phase and scale");
  c.text("level", 16, r.level,
         "what was stored of the drawing: extents (nothing), positions, full");
}

template <class Run>
void result_columns(RecordPass& c, Run& r) {
  c.next_are(ColumnKind::result, false);
  c.choice("status", 16, r.status, parse_run_status,
           "ok, timeout, out_of_memory, refused, violated, crashed or measured");
  c.message("message", 240, r.message, "first violation or error, cut to fit; else empty");
  c.text("drawing_hash", 32, r.drawing_hash, "128-bit hash of positions, edges and bends");
  c.number("violations", "1", r.violations,
           "violations of the guarantee that the certificate lists; 0 is proved right");
  c.text("certificate", 16, r.certificate,
         "empty if it is a proof; measured or none: not proved; in results of 0.2.0 also filtered, "
         "double and sample=K");
  c.array("instance_bound", "lattice units", r.instance_bound, kAxes,
          "extent that the proof promises for this instance");
  c.text("counters", 512, r.counters, "what the algorithm tells about its run, name=value;...");
}

// The metrics that code reasons with have a member of a row, integers first.
constexpr std::array kMembers = {"extent_x",
                                 "extent_y",
                                 "extent_z",
                                 "bends_0",
                                 "bends_1",
                                 "bends_2",
                                 "bends_3",
                                 "bends_4",
                                 "bends_5",
                                 "bends_6",
                                 "bends_7",
                                 "log2_volume",
                                 "total_edge_length",
                                 "longest_edge_length",
                                 "smallest_vertex_distance"};

// Of every metric its number among the members, or how many there are.
const std::vector<std::size_t>& members_of_metrics() {
  static const std::vector<std::size_t> members = [] {
    std::vector<std::size_t> found;
    for (const Metric& metric : metrics()) {
      found.push_back(
          static_cast<std::size_t>(std::ranges::find(kMembers, metric.name) - kMembers.begin()));
    }
    const auto others = static_cast<std::size_t>(std::ranges::count(found, kMembers.size()));
    expect(found.size() - others == kMembers.size(), "every member is in the table of metrics");
    return found;
  }();
  return members;
}

// The values of the other metrics, those that stand for none if the row holds none.
template <class Run>
auto& other_metrics(Run& r) {
  static const std::vector<MetricValue> none = [] {
    std::vector<MetricValue> values;
    for (std::size_t i = 0; i < metrics().size(); ++i) {
      if (members_of_metrics()[i] < kMembers.size()) continue;
      const bool is_integer = metrics()[i].type == MetricType::int64;
      values.push_back(is_integer ? MetricValue(std::int64_t{-1}) : MetricValue(kMissing));
    }
    return values;
  }();
  if constexpr (std::is_const_v<Run>) {
    return r.other_metrics.empty() ? none : r.other_metrics;
  } else {
    if (r.other_metrics.empty()) r.other_metrics = none;
    return r.other_metrics;
  }
}

// Calls use(metric, value) for all metrics, in the order of their table.
template <class Run, class Use>
void for_each_metric(Run& r, const Use& use) {
  const std::array doubles = {&r.log2_volume, &r.total_edge_length, &r.longest_edge_length,
                              &r.smallest_vertex_distance};
  auto other = other_metrics(r).begin();
  for (std::size_t i = 0; i < metrics().size(); ++i) {
    const auto take = [&](auto& value) { use(metrics()[i], value); };
    const std::size_t member = members_of_metrics()[i];
    if (member < 3) {
      take(r.extents[member]);
    } else if (member < 11) {
      take(r.bends[member - 3]);
    } else if (member < kMembers.size()) {
      take(*doubles[member - 11]);
    } else {
      std::visit(take, *other++);
    }
  }
}

template <class Run>
void metric_columns(RecordPass& c, Run& r) {
  c.next_are(ColumnKind::metric, false);
  for_each_metric(r, [&c](const Metric& metric, auto& value) {
    c.number(metric.name, metric.unit.c_str(), value, metric.definition.c_str());
  });
}

template <class Run>
void time_columns(RecordPass& c, Run& r) {
  c.next_are(ColumnKind::measured, false);
  c.number("generate_s", "s", r.generate_s, "wall time of generating the graph");
  c.number("wall_s", "s", r.wall_s, "wall time of drawing, nothing else");
  c.number("cpu_s", "s", r.cpu_s, "CPU time of the drawing thread, drawing only");
  c.number("store_s", "s", r.store_s,
           "wall time of storing positions or bends; missing at level extents");
  c.number(
      "certify_s", "s", r.certify_s,
      "wall time of judging the drawing; in files without metrics_s with its metrics and hash");
  c.number("metrics_s", "s", r.metrics_s, "wall time of the drawing's metrics and hash");
  c.number("write_s", "s", r.write_s, "wall time of formatting the drawing as JSON lines");
  c.number("concurrency", "1", r.concurrency, "rows that this study makes at the same time");
  c.number("core", "1", r.core, "core that the row was pinned to");
  c.number("warm_ups", "1", r.warm_ups, "drawings of the graph just before, thrown away");
  c.array("", "s", r.yardsticks_s, kYardstickColumns,
          "CPU time of a yardstick near the row, which tells how fast the machine was");
  c.text("build_kind", 16, r.build_kind,
         "why times are worth little: debug or sanitised; else empty");
}

template <class Run>
void count_columns(RecordPass& c, Run& r) {
  constexpr const char* kCounted = "of drawing, user space, by a hardware counter";
  c.number("instructions", "1", r.instructions, kCounted);
  c.number("cycles", "1", r.cycles, kCounted);
  c.number("cache_misses", "1", r.cache_misses, kCounted);
  c.number("counted_instructions", "1", r.counted_instructions, "of drawing, counted by callgrind");
  c.number("estimated_cycles", "1", r.estimated_cycles,
           "instructions + 10 first-level + 100 last-level misses of callgrind's simulated cache");
  c.number("base_bytes", "bytes", r.base_bytes, "resident memory when the row began");
  c.number("draw_peak_bytes", "bytes", r.draw_peak_bytes, "peak resident memory while drawing");
  c.number("peak_bytes", "bytes", r.peak_bytes, "peak resident memory, as peak_scope says");
  c.text("peak_scope", 8, r.peak_scope,
         "of this row alone (row, worker: in a process of its own) or of the process so far");
  c.number("batch_s", "s", r.batch_s, "wall time of the whole batch; only in phases with batches");
  c.number("ideal_batch_s", "s", r.ideal_batch_s,
           "batch_s of one thread or rank if scaling were perfect");
  c.number("efficiency", "1", r.efficiency, "ideal_batch_s / batch_s");
  c.number("session", "1", r.session, "the session of /environments that made the row");
}

template <class Run>
void columns_of(RecordPass& c, Run& r) {
  c.table("runs", "instance x algorithm x options x repetition");
  identity_columns(c, r);
  result_columns(c, r);
  metric_columns(c, r);
  time_columns(c, r);
  count_columns(c, r);
}

}  // namespace

const StoredTable& runs_spec() {
  static const StoredTable spec = [] {
    StoredTable made;
    RecordPass pass(made);
    const RunRecord none;
    columns_of(pass, none);
    pack_columns(made.columns);
    return made;
  }();
  return spec;
}

const std::vector<Column>& run_columns() { return runs_spec().columns; }

const Column& run_column(std::string_view name) {
  const auto at = std::ranges::find(run_columns(), name, &Column::name);
  expect(at != run_columns().end(), "a column of that name");
  return *at;
}

std::size_t run_record_size() {
  static const std::size_t size = record_size(run_columns());
  return size;
}

void store_record(const RunRecord& run, char* record) {
  std::memset(record, 0, run_record_size());
  RecordPass pass(run_columns(), record);
  columns_of(pass, run);
}

std::vector<char> record_of(const RunRecord& run) {
  std::vector<char> record(run_record_size());
  store_record(run, record.data());
  return record;
}

RunRecord load_record(const char* record) {
  RunRecord run;
  RecordPass pass(run_columns(), record);
  columns_of(pass, run);
  return run;
}

void set_metrics(const DrawingSummary& summary, RunRecord& run) {
  for_each_metric(run, [&summary](const Metric& metric, auto& value) {
    value = std::get<std::remove_reference_t<decltype(value)>>(metric.value(summary));
  });
}

std::vector<MetricValue> metrics_of(const RunRecord& run) {
  std::vector<MetricValue> values;
  for_each_metric(run, [&](const Metric&, const auto& value) { values.emplace_back(value); });
  return values;
}

double number_of(const MetricValue& value) {
  const auto* const integer = std::get_if<std::int64_t>(&value);
  if (integer == nullptr) return std::get<double>(value);
  return *integer < 0 ? kMissing : static_cast<double>(*integer);
}

double metric_of(const RunRecord& run, std::string_view name) {
  std::optional<double> number;
  for_each_metric(run, [&](const Metric& metric, const auto& value) {
    if (metric.name == name) number = number_of(value);
  });
  expect(number.has_value(), "a metric of that name");
  return *number;
}

std::vector<std::string> differing_columns(const RunRecord& a, const RunRecord& b) {
  const std::vector<char> left = record_of(a), right = record_of(b);
  std::vector<std::string> names;
  for (const Column& column : run_columns()) {
    if (column.kind == ColumnKind::measured) continue;
    if (std::memcmp(&left[column.offset], &right[column.offset], column.size) != 0) {
      names.push_back(column.name);
    }
  }
  return names;
}

}  // namespace ar3d
