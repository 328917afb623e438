#include "ar3d/store/columns/run_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <variant>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/printable_ascii.h"

namespace ar3d {
namespace {

struct Description {
  const char* name;
  const char* unit;
  const char* meaning;
  ColumnKind kind;
};

Column described(const Description& d, FieldType type, std::size_t size) {
  Column column;
  column.name = d.name;
  column.unit = d.unit;
  column.meaning = d.meaning;
  column.kind = d.kind;
  column.type = type;
  column.size = size;
  column.required = d.kind == ColumnKind::instance || d.kind == ColumnKind::run;
  return column;
}

void require_fits(const std::string& text, const std::string& column, std::size_t size) {
  if (fits(text, size)) return;
  throw InputError(fmt::format("{} '{}' is not {} bytes of ASCII", column, text, size));
}

std::string loaded_text(const char* from, std::size_t size) {
  return std::string(from, strnlen(from, size));
}

void store_text(const std::string& text, char* to, std::size_t size) {
  std::memcpy(to, text.data(), text.size());
  std::memset(to + text.size(), 0, size - text.size());
}

// Text that identifies something: refused, never cut, if it does not fit.
Column text(const Description& d, std::string RunRecord::*member, std::size_t size) {
  Column column = described(d, FieldType::text, size);
  column.store = [member, size, name = column.name](const RunRecord& run, char* to) {
    require_fits(run.*member, name, size);
    store_text(run.*member, to, size);
  };
  column.exact_text = member;
  column.load = [member, size](const char* from, RunRecord& run) {
    run.*member = loaded_text(from, size);
  };
  return column;
}

// Text for people, cut to fit.
Column message(const Description& d, std::string RunRecord::*member, std::size_t size) {
  Column column = text(d, member, size);
  column.exact_text = nullptr;
  column.store = [member, size](const RunRecord& run, char* to) {
    const std::string& value = run.*member;
    store_text(fits(value, size) ? value : fitted_text(value, size), to, size);
  };
  return column;
}

// One of a few names.
template <class Enum>
Column choice(const Description& d, Enum RunRecord::*member, Enum (*parse)(std::string_view),
              std::size_t size) {
  Column column = described(d, FieldType::text, size);
  column.store = [member, size](const RunRecord& run, char* to) {
    store_text(to_string(run.*member), to, size);
  };
  column.load = [member, parse, size](const char* from, RunRecord& run) {
    run.*member = parse(loaded_text(from, size));
  };
  return column;
}

template <class T>
constexpr FieldType kTypeOf = std::is_same_v<T, double>         ? FieldType::float64
                              : std::is_same_v<T, std::int64_t> ? FieldType::int64
                                                                : FieldType::uint64;

template <class T>
Column number(const Description& d, T RunRecord::*member) {
  Column column = described(d, kTypeOf<T>, sizeof(T));
  column.store = [member](const RunRecord& run, char* to) {
    std::memcpy(to, &(run.*member), sizeof(T));
  };
  column.load = [member](const char* from, RunRecord& run) {
    std::memcpy(&(run.*member), from, sizeof(T));
  };
  return column;
}

// One column for each entry of an array, named by `suffixes`.
template <class T, std::size_t N>
void add_array(std::vector<Column>& columns, const Description& d,
               std::array<T, N> RunRecord::*member, const std::array<const char*, N>& suffixes) {
  for (std::size_t i = 0; i < N; ++i) {
    Column column = described(d, kTypeOf<T>, sizeof(T));
    column.name += suffixes[i];
    column.store = [member, i](const RunRecord& run, char* to) {
      std::memcpy(to, &(run.*member)[i], sizeof(T));
    };
    column.load = [member, i](const char* from, RunRecord& run) {
      std::memcpy(&(run.*member)[i], from, sizeof(T));
    };
    columns.push_back(std::move(column));
  }
}

constexpr std::array<const char*, 3> kAxes = {"_x", "_y", "_z"};
constexpr std::array<const char*, 8> kBends = {"_0", "_1", "_2", "_3", "_4", "_5", "_6", "_7"};

void add_identity(std::vector<Column>& c) {
  const auto instance = ColumnKind::instance;
  const auto run = ColumnKind::run;
  c.push_back(
      text({"row_key", "", "hash of study seed, instance, algorithm, options and repetition", run},
           &RunRecord::row_key, 32));
  c.push_back(text({"family", "", "family of graphs", instance}, &RunRecord::family, 48));
  c.push_back(
      text({"parameters", "", "the family's parameters, complete, in catalogue order", instance},
           &RunRecord::parameters, 128));
  c.push_back(number({"requested_n", "1", "number of vertices that the study asked for", instance},
                     &RunRecord::requested_n));
  c.back().former_name = "wanted_n";
  c.push_back(number({"n", "1", "number of vertices", instance}, &RunRecord::n));
  c.push_back(number({"m", "1", "number of edges", instance}, &RunRecord::m));
  c.push_back(number({"instance_index", "1",
                      "0, 1, ...: which instance of (family, parameters, requested_n)", instance},
                     &RunRecord::instance_index));
  c.push_back(
      number({"seed", "", "the generator's seed of this instance", instance}, &RunRecord::seed));
  c.push_back(
      text({"graph_hash", "", "128-bit hash of the graph", instance}, &RunRecord::graph_hash, 32));
  c.push_back(text({"algorithm", "", "drawing algorithm", run}, &RunRecord::algorithm, 48));
  c.push_back(text({"options", "", "the algorithm's options, complete, in catalogue order", run},
                   &RunRecord::options, 96));
  c.push_back(
      choice({"phase", "",
              "what the row was made for: metrics, timing, strong, weak, strong_r, weak_r", run},
             &RunRecord::phase, parse_run_phase, 8));
  c.push_back(
      number({"scale", "1", "threads (strong, weak) or ranks (_r) that share the batch", run},
             &RunRecord::scale));
  c.push_back(number({"repetition", "1", "0, 1, ...: which one within its phase and scale", run},
                     &RunRecord::repetition));
  c.push_back(
      text({"level", "", "what was stored of the drawing: extents (nothing), positions, full", run},
           &RunRecord::level, 16));
  c.back().required = false;  // files of 0.2.0 have none: all their rows are of level extents
}

void add_results(std::vector<Column>& c) {
  const auto kind = ColumnKind::result;
  c.push_back(choice(
      {"status", "", "ok, timeout, out_of_memory, refused, violated, crashed or measured", kind},
      &RunRecord::status, parse_run_status, 16));
  c.push_back(message({"message", "",
                       "first violation or error, what a sample leaves open, or which certificate "
                       "did not accept the drawing, cut to fit; else empty",
                       kind},
                      &RunRecord::message, 240));
  c.push_back(text({"drawing_hash", "", "128-bit hash of positions, edges and bends", kind},
                   &RunRecord::drawing_hash, 32));
  c.push_back(
      number({"violations", "1",
              "violations of the guarantee that the certificate lists; 0 is proved right", kind},
             &RunRecord::violations));
  c.push_back(text({"certificate", "",
                    "how it was judged: empty for exact (a proof), else measured, filtered, "
                    "double, sample=K or none: not proved",
                    kind},
                   &RunRecord::certificate, 16));
  add_array(c,
            {"instance_bound", "lattice units",
             "extent that the proof promises for this very instance", kind},
            &RunRecord::instance_bound, kAxes);
  c.push_back(text({"counters", "", "what the algorithm tells about its run, name=value;...", kind},
                   &RunRecord::counters, 512));
}

// The metrics that have a member; unit and meaning come from their table.
std::vector<Column> metrics_with_member() {
  const auto kind = ColumnKind::metric;
  std::vector<Column> c;
  add_array(c, {"extent", "", "", kind}, &RunRecord::extents, kAxes);
  c.push_back(number({"log2_volume", "", "", kind}, &RunRecord::log2_volume));
  add_array(c, {"bends", "", "", kind}, &RunRecord::bends, kBends);
  c.push_back(number({"total_edge_length", "", "", kind}, &RunRecord::total_edge_length));
  c.push_back(number({"longest_edge_length", "", "", kind}, &RunRecord::longest_edge_length));
  c.push_back(
      number({"smallest_vertex_distance", "", "", kind}, &RunRecord::smallest_vertex_distance));
  return c;
}

// A metric without a member: other_metrics[index].
Column other_metric(const Metric& metric, std::size_t index) {
  const bool is_integer = metric.type == MetricType::int64;
  Column column = described({metric.name.c_str(), "", "", ColumnKind::metric},
                            is_integer ? FieldType::int64 : FieldType::float64, sizeof(double));
  const Field field = static_cast<const Field&>(column);
  column.store = [index, field](const RunRecord& run, char* to) {
    if (index >= run.other_metrics.size()) return store_missing(field, to);
    std::visit([to](auto value) { std::memcpy(to, &value, sizeof(value)); },
               run.other_metrics[index]);
  };
  column.load = [index, is_integer](const char* from, RunRecord& run) {
    if (index >= run.other_metrics.size()) run.other_metrics.resize(index + 1);
    std::int64_t integer = 0;
    double number = 0;
    std::memcpy(&integer, from, sizeof(integer));
    std::memcpy(&number, from, sizeof(number));
    run.other_metrics[index] = is_integer ? MetricValue(integer) : MetricValue(number);
  };
  return column;
}

void add_metrics(std::vector<Column>& c) {
  std::vector<Column> with_member = metrics_with_member();
  std::size_t others = 0;
  for (const Metric& metric : metrics()) {
    const auto at = std::find_if(with_member.begin(), with_member.end(),
                                 [&](const Column& m) { return m.name == metric.name; });
    const bool has_member = at != with_member.end();
    Column column = has_member ? *at : other_metric(metric, others++);
    if (has_member) with_member.erase(at);
    column.unit = metric.unit;
    column.meaning = metric.definition;
    expect((column.type == FieldType::int64) == (metric.type == MetricType::int64),
           "a metric has its member's type");
    c.push_back(std::move(column));
  }
  expect(with_member.empty(), "every metric with a member is in the table of metrics");
}

void add_measurements(std::vector<Column>& c) {
  const auto kind = ColumnKind::measured;
  c.push_back(number({"generate_s", "s", "wall time of generating the graph", kind},
                     &RunRecord::generate_s));
  c.push_back(
      number({"wall_s", "s", "wall time of drawing, nothing else", kind}, &RunRecord::wall_s));
  c.push_back(number({"cpu_s", "s", "CPU time of the drawing thread, drawing only", kind},
                     &RunRecord::cpu_s));
  c.push_back(number(
      {"store_s", "s", "wall time of storing positions or bends; missing at level extents", kind},
      &RunRecord::store_s));
  c.push_back(number(
      {"certify_s", "s", "wall time of certifying the drawing, with its metrics and hash", kind},
      &RunRecord::certify_s));
  c.push_back(number({"write_s", "s", "wall time of formatting the drawing as JSON lines", kind},
                     &RunRecord::write_s));
}

void add_circumstances(std::vector<Column>& c) {
  const auto kind = ColumnKind::measured;
  c.push_back(number({"concurrency", "1", "rows that this study makes at the same time", kind},
                     &RunRecord::concurrency));
  c.push_back(number({"core", "1", "core that the row was pinned to; missing if none", kind},
                     &RunRecord::core));
  c.push_back(number({"warm_ups", "1", "drawings of the graph just before, thrown away", kind},
                     &RunRecord::warm_ups));
  c.push_back(
      text({"build_kind", "", "why times are worth little: debug or sanitised; else empty", kind},
           &RunRecord::build_kind, 16));
  c.back().former_name = "timing_mark";
}

void add_counters(std::vector<Column>& c) {
  const auto kind = ColumnKind::measured;
  c.push_back(number({"instructions", "1", "of drawing, user space, by a hardware counter", kind},
                     &RunRecord::instructions));
  c.push_back(number({"cycles", "1", "of drawing, user space, by a hardware counter", kind},
                     &RunRecord::cycles));
  c.push_back(number({"cache_misses", "1", "of drawing, user space, by a hardware counter", kind},
                     &RunRecord::cache_misses));
  c.push_back(number({"counted_instructions", "1", "of drawing, counted by callgrind", kind},
                     &RunRecord::counted_instructions));
}

void add_memory(std::vector<Column>& c) {
  const auto kind = ColumnKind::measured;
  c.push_back(number({"base_bytes", "bytes", "resident memory when the row began", kind},
                     &RunRecord::base_bytes));
  c.push_back(number({"draw_peak_bytes", "bytes", "peak resident memory while drawing", kind},
                     &RunRecord::draw_peak_bytes));
  c.push_back(number({"peak_bytes", "bytes", "peak resident memory, as peak_scope says", kind},
                     &RunRecord::peak_bytes));
  c.push_back(text(
      {"peak_scope", "",
       "of this row alone (row, worker: in a process of its own) or of the process so far", kind},
      &RunRecord::peak_scope, 8));
}

void add_scaling(std::vector<Column>& c) {
  const auto kind = ColumnKind::measured;
  c.push_back(
      number({"batch_s", "s", "wall time of the whole batch; only in phases with batches", kind},
             &RunRecord::batch_s));
  c.push_back(
      number({"ideal_batch_s", "s", "batch_s of one thread or rank if scaling were perfect", kind},
             &RunRecord::ideal_batch_s));
  c.push_back(number({"efficiency", "1", "ideal_batch_s / batch_s", kind}, &RunRecord::efficiency));
  c.push_back(number({"session", "1", "the session of /environments that made the row", kind},
                     &RunRecord::session));
}

std::vector<Column> make_run_columns() {
  std::vector<Column> columns;
  add_identity(columns);
  add_results(columns);
  add_metrics(columns);
  add_measurements(columns);
  add_circumstances(columns);
  add_counters(columns);
  add_memory(columns);
  add_scaling(columns);
  pack_fields(columns);
  return columns;
}

}  // namespace

const std::vector<Column>& run_columns() {
  static const std::vector<Column> columns = make_run_columns();
  return columns;
}

const Column& run_column(std::string_view name) {
  for (const Column& column : run_columns()) {
    if (column.name == name) return column;
  }
  throw InternalError(fmt::format("internal error: no column '{}'", name));
}

std::size_t run_record_size() {
  static const std::size_t size = record_size(run_columns());
  return size;
}

void require_storable(const RunRecord& run) {
  for (const Column& column : run_columns()) {
    if (column.exact_text != nullptr)
      require_fits(run.*column.exact_text, column.name, column.size);
  }
}

void store_record(const RunRecord& run, char* record) {
  for (const Column& column : run_columns()) column.store(run, record + column.offset);
}

RunRecord load_record(const char* record) {
  RunRecord run;
  for (const Column& column : run_columns()) column.load(record + column.offset, run);
  return run;
}

std::vector<Column> columns_of_kind(ColumnKind kind) {
  std::vector<Column> chosen;
  for (const Column& column : run_columns()) {
    if (column.kind == kind) chosen.push_back(column);
  }
  return chosen;
}

void set_metrics(const DrawingSummary& summary, RunRecord& run) {
  static const std::vector<Column> columns = columns_of_kind(ColumnKind::metric);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    char bytes[sizeof(double)];
    std::visit([&](auto value) { std::memcpy(bytes, &value, sizeof(value)); },
               metrics()[i].value(summary));
    columns[i].load(bytes, run);
  }
}

}  // namespace ar3d
