// The columns of /runs, one line each, and what is made of a row by them.
#include "ar3d/store/columns/run_columns.h"

#include <fmt/format.h>

#include <type_traits>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

// True if a column of so many bytes holds the text as it is.
bool fits(const std::string& text, std::size_t size) {
  return text.size() <= size && all_printable(text);
}

void require_fits(const std::string& text, const std::string& column, std::size_t size) {
  if (fits(text, size)) return;
  throw InputError(fmt::format("{} '{}' is not {} bytes of printable text", column, text, size));
}

std::string loaded_text(const char* from, std::size_t size) {
  return std::string(from, strnlen(from, size));
}

void store_text(const std::string& text, char* to, std::size_t size) {
  std::memcpy(to, text.data(), text.size());
  std::memset(to + text.size(), 0, size - text.size());
}

template <class T>
constexpr FieldType kTypeOf = std::is_same_v<T, double>         ? FieldType::float64
                              : std::is_same_v<T, std::int64_t> ? FieldType::int64
                                                                : FieldType::uint64;

// Columns that are added one after the other, all of `kind`.
struct ColumnList {
  ColumnKind kind = ColumnKind::run;
  std::vector<Column> columns;

  // What is returned stays where it is until the next column is added.
  Column& add(const std::string& name, const char* unit, const char* meaning, FieldType type,
              std::size_t size) {
    Column& column = columns.emplace_back();
    column.name = name;
    column.unit = unit;
    column.meaning = meaning;
    column.kind = kind;
    column.type = type;
    column.size = size;
    column.required = kind == ColumnKind::instance || kind == ColumnKind::run;
    return column;
  }

  // Text that identifies something: refused, never cut, if it does not fit.
  Column& text(const char* name, std::size_t size, std::string RunRecord::*member,
               const char* meaning) {
    Column& column = add(name, "", meaning, FieldType::text, size);
    column.store = [member, size, name = column.name](const RunRecord& run, char* to) {
      require_fits(run.*member, name, size);
      store_text(run.*member, to, size);
    };
    column.load = [member, size](const char* from, RunRecord& run) {
      run.*member = loaded_text(from, size);
    };
    return column;
  }

  // Text for people, cut to fit.
  void message(const char* name, std::size_t size, std::string RunRecord::*member,
               const char* meaning) {
    Column& column = text(name, size, member, meaning);
    column.store = [member, size](const RunRecord& run, char* to) {
      const std::string& value = run.*member;
      store_text(fits(value, size) ? value : fitted_text(value, size), to, size);
    };
  }

  // One of a few names.
  template <class Enum>
  void choice(const char* name, std::size_t size, Enum RunRecord::*member,
              Enum (*parse)(std::string_view), const char* meaning) {
    Column& column = add(name, "", meaning, FieldType::text, size);
    column.store = [member, size](const RunRecord& run, char* to) {
      store_text(to_string(run.*member), to, size);
    };
    column.load = [member, parse, size](const char* from, RunRecord& run) {
      run.*member = parse(loaded_text(from, size));
    };
  }

  // A number where `at` says, of a row that is written or read.
  template <class T, class At>
  void number_at(const std::string& name, const char* unit, const char* meaning, const At& at) {
    Column& column = add(name, unit, meaning, kTypeOf<T>, sizeof(T));
    column.store = [at](const RunRecord& run, char* to) { std::memcpy(to, &at(run), sizeof(T)); };
    column.load = [at](const char* from, RunRecord& run) {
      std::memcpy(&at(run), from, sizeof(T));
    };
  }
  template <class T>
  void number(const char* name, const char* unit, T RunRecord::*member, const char* meaning) {
    number_at<T>(
        name, unit, meaning, [member](auto& run) -> auto& { return run.*member; });
  }
  // One column for each entry of an array, named by `suffixes`.
  template <class T, std::size_t N>
  void array(const char* name, const char* unit, std::array<T, N> RunRecord::*member,
             const std::array<const char*, N>& suffixes, const char* meaning) {
    for (std::size_t i = 0; i < N; ++i) {
      number_at<T>(
          std::string(name) + suffixes[i], unit, meaning,
          [ member, i ](auto& run) -> auto& { return (run.*member)[i]; });
    }
  }
};

constexpr std::array<const char*, 3> kAxes = {"_x", "_y", "_z"};
constexpr std::array<const char*, 3> kYardstickColumns = {
    "yardstick_cached_s", "yardstick_memory_s", "yardstick_arithmetic_s"};
constexpr std::array<const char*, 8> kBends = {"_0", "_1", "_2", "_3", "_4", "_5", "_6", "_7"};

void add_identity(ColumnList& c) {
  using R = RunRecord;
  c.kind = ColumnKind::run;
  c.text("row_key", 32, &R::row_key,
         "hash of study seed, instance, algorithm, options and repetition");
  c.kind = ColumnKind::instance;
  c.text("family", 48, &R::family, "family of graphs");
  c.text("parameters", 128, &R::parameters,
         "the family's parameters, complete, in catalogue order");
  c.number("requested_n", "1", &R::requested_n, "number of vertices that the study asked for");
  c.number("n", "1", &R::n, "number of vertices");
  c.number("m", "1", &R::m, "number of edges");
  c.number("instance_index", "1", &R::instance_index,
           "0, 1, ...: which instance of (family, parameters, requested_n)");
  c.number("seed", "", &R::seed, "the generator's seed of this instance");
  c.text("graph_hash", 32, &R::graph_hash, "128-bit hash of the graph");
  c.message("graph_name", 96, &R::graph_name,
            "of a graph of files: its file in the collection, #3 behind it if that holds several");
  c.text("group", 48, &R::group, "of a graph of a collection: sub-folder, or as a table says");
  c.number("max_degree", "1", &R::max_degree, "largest degree of a vertex");
  for (auto added = c.columns.end() - 3; added != c.columns.end(); ++added) added->required = false;
  c.kind = ColumnKind::run;
  c.text("algorithm", 48, &R::algorithm, "drawing algorithm");
  c.text("options", 96, &R::options, "the algorithm's options, complete, in catalogue order");
  c.choice("phase", 8, &R::phase, parse_run_phase,
           "what the row was made for: metrics, timing, strong, weak, strong_r, weak_r");
  c.number("scale", "1", &R::scale, "threads (strong, weak) or ranks (_r) that share the batch");
  c.number("repetition", "1", &R::repetition, "0, 1, ...: which one within its phase and scale");
  c.text("level", 16, &R::level,
         "what was stored of the drawing: extents (nothing), positions, full");
}

void add_results(ColumnList& c) {
  using R = RunRecord;
  c.kind = ColumnKind::result;
  c.choice("status", 16, &R::status, parse_run_status,
           "ok, timeout, out_of_memory, refused, violated, crashed or measured");
  c.message("message", 240, &R::message, "first violation or error, cut to fit; else empty");
  c.text("drawing_hash", 32, &R::drawing_hash, "128-bit hash of positions, edges and bends");
  c.number("violations", "1", &R::violations,
           "violations of the guarantee that the certificate lists; 0 is proved right");
  c.text("certificate", 16, &R::certificate,
         "how it was judged: empty for exact (a proof), else measured or none: not proved; in "
         "results of 0.2.0 also filtered, double and sample=K");
  c.array("instance_bound", "lattice units", &R::instance_bound, kAxes,
          "extent that the proof promises for this very instance");
  c.text("counters", 512, &R::counters, "what the algorithm tells about its run, name=value;...");
}

// The metrics that have a member; unit and meaning come from their table.
std::vector<Column> metrics_with_member() {
  using R = RunRecord;
  ColumnList c{ColumnKind::metric, {}};
  c.array("extent", "", &R::extents, kAxes, "");
  c.number("log2_volume", "", &R::log2_volume, "");
  c.array("bends", "", &R::bends, kBends, "");
  c.number("total_edge_length", "", &R::total_edge_length, "");
  c.number("longest_edge_length", "", &R::longest_edge_length, "");
  c.number("smallest_vertex_distance", "", &R::smallest_vertex_distance, "");
  return std::move(c.columns);
}

// A metric without a member: other_metrics[index].
Column other_metric(const Metric& metric, std::size_t index) {
  const bool is_integer = metric.type == MetricType::int64;
  ColumnList list{ColumnKind::metric, {}};
  Column& column = list.add(metric.name, "", "", is_integer ? FieldType::int64 : FieldType::float64,
                            sizeof(double));
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
  return std::move(column);
}

void add_metrics(ColumnList& list) {
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
    list.columns.push_back(std::move(column));
  }
  expect(with_member.empty(), "every metric with a member is in the table of metrics");
}

void add_times(ColumnList& c) {
  using R = RunRecord;
  c.kind = ColumnKind::measured;
  c.number("generate_s", "s", &R::generate_s, "wall time of generating the graph");
  c.number("wall_s", "s", &R::wall_s, "wall time of drawing, nothing else");
  c.number("cpu_s", "s", &R::cpu_s, "CPU time of the drawing thread, drawing only");
  c.number("store_s", "s", &R::store_s,
           "wall time of storing positions or bends; missing at level extents");
  c.number("certify_s", "s", &R::certify_s,
           "wall time of certifying the drawing, with its metrics and hash");
  c.number("write_s", "s", &R::write_s, "wall time of formatting the drawing as JSON lines");
  c.number("concurrency", "1", &R::concurrency, "rows that this study makes at the same time");
  c.number("core", "1", &R::core, "core that the row was pinned to; missing if none");
  c.number("warm_ups", "1", &R::warm_ups, "drawings of the graph just before, thrown away");
  c.array("", "s", &R::yardsticks_s, kYardstickColumns,
          "CPU time of a yardstick near the row, which tells how fast the machine was");
  c.text("build_kind", 16, &R::build_kind,
         "why times are worth little: debug or sanitised; else empty");
}

void add_counts(ColumnList& c) {
  using R = RunRecord;
  constexpr const char* kCounted = "of drawing, user space, by a hardware counter";
  c.number("instructions", "1", &R::instructions, kCounted);
  c.number("cycles", "1", &R::cycles, kCounted);
  c.number("cache_misses", "1", &R::cache_misses, kCounted);
  c.number("counted_instructions", "1", &R::counted_instructions,
           "of drawing, counted by callgrind");
  c.number("estimated_cycles", "1", &R::estimated_cycles,
           "instructions + 10 first-level + 100 last-level misses of callgrind's simulated cache");
  c.number("base_bytes", "bytes", &R::base_bytes, "resident memory when the row began");
  c.number("draw_peak_bytes", "bytes", &R::draw_peak_bytes, "peak resident memory while drawing");
  c.number("peak_bytes", "bytes", &R::peak_bytes, "peak resident memory, as peak_scope says");
  c.text("peak_scope", 8, &R::peak_scope,
         "of this row alone (row, worker: in a process of its own) or of the process so far");
  c.number("batch_s", "s", &R::batch_s,
           "wall time of the whole batch; only in phases with batches");
  c.number("ideal_batch_s", "s", &R::ideal_batch_s,
           "batch_s of one thread or rank if scaling were perfect");
  c.number("efficiency", "1", &R::efficiency, "ideal_batch_s / batch_s");
  c.number("session", "1", &R::session, "the session of /environments that made the row");
}

std::vector<Column> make_run_columns() {
  ColumnList list;
  add_identity(list);
  add_results(list);
  add_metrics(list);
  add_times(list);
  add_counts(list);
  pack_fields(list.columns);
  return std::move(list.columns);
}

// What a run has in a column.
std::string bytes_of(const Column& column, const RunRecord& run) {
  std::string bytes(column.size, '\0');
  column.store(run, bytes.data());
  return bytes;
}

template <class T>
T loaded(const std::string& bytes) {
  T value{};
  std::memcpy(&value, bytes.data(), sizeof(T));
  return value;
}

}  // namespace

const std::vector<Column>& run_columns() {
  static const std::vector<Column> columns = make_run_columns();
  return columns;
}

const TableSpec& runs_spec() {
  static const TableSpec spec = {"runs",
                                 "instance x algorithm x options x repetition",
                                 {run_columns().begin(), run_columns().end()}};
  return spec;
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
  std::vector<char> record(run_record_size());
  store_record(run, record.data());
}

void store_record(const RunRecord& run, char* record) {
  for (const Column& column : run_columns()) column.store(run, record + column.offset);
}

RunRecord load_record(const char* record) {
  RunRecord run;
  for (const Column& column : run_columns()) column.load(record + column.offset, run);
  return run;
}

RowKey key_of_record(const char* record) {
  static const Column& column = run_column("row_key");
  return parse_row_key({record + column.offset, column.size});
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

std::string column_text(const Column& column, const RunRecord& run) {
  const std::string bytes = bytes_of(column, run);
  switch (column.type) {
    case FieldType::text:
      return bytes.substr(0, bytes.find('\0'));
    case FieldType::int64:
      return fmt::format("{}", loaded<std::int64_t>(bytes));
    case FieldType::uint64:
      return fmt::format("{}", loaded<std::uint64_t>(bytes));
    case FieldType::float64:
      return fmt::format("{}", loaded<double>(bytes));
  }
  throw InternalError("internal error: unknown column type");
}

double column_number(const Column& column, const RunRecord& run) {
  expect(column.type == FieldType::int64 || column.type == FieldType::float64,
         "a column with a number");
  const std::string bytes = bytes_of(column, run);
  if (column.type == FieldType::float64) return loaded<double>(bytes);
  const auto integer = loaded<std::int64_t>(bytes);
  return integer < 0 ? kMissing : static_cast<double>(integer);
}

std::vector<std::string> differing_columns(const RunRecord& a, const RunRecord& b) {
  std::vector<std::string> names;
  for (const Column& column : run_columns()) {
    if (column.kind == ColumnKind::measured) continue;
    if (bytes_of(column, a) != bytes_of(column, b)) names.push_back(column.name);
  }
  return names;
}

}  // namespace ar3d
