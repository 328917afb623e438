// The small tables that stand beside the rows: what holds for all rows of an algorithm, and the
// files whose graphs were drawn.
#include "ar3d/store/columns/side_tables.h"

#include <fmt/format.h>

#include <set>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/side_texts.h"

namespace ar3d {
namespace {

constexpr std::array<const char*, 3> kBoundAxes = {"_x", "_y", "_z"};
constexpr unsigned kLargestHalfPower = 18;  // of AxisBound
constexpr std::size_t kSkippedFileBytes = 96;
constexpr std::size_t kFieldsOfBound = 3 + 3 * 4;

constexpr auto kInt = FieldType::int64;
constexpr auto kFloat = FieldType::float64;

Field text_field(const std::string& name, const char* meaning, std::size_t size) {
  Field field{name, "", meaning, FieldType::text, size};
  field.required = false;
  return field;
}

void add_bound(std::vector<Field>& fields, const std::string& whose) {
  fields.push_back(text_field(whose + "_name", "whose bound it is", 48));
  fields.push_back(text_field(whose + "_source", "where it is proved or stands", 96));
  fields.push_back(text_field(whose + "_formula", "the bound by axis, for people", 256));
  for (const char* axis : kBoundAxes) {
    const std::string bound = "extent <= numerator / denominator * n^exponent + constant";
    const auto add = [&](const char* part, FieldType type) {
      fields.push_back({whose + part + axis, "1", bound, type, sizeof(double)});
    };
    add("_numerator", kInt);
    add("_denominator", kInt);
    add("_exponent", kFloat);
    add("_constant", kInt);
  }
}

TableSpec make_algorithms_spec() {
  TableSpec spec{"algorithms", "what follows from algorithm and options", {}};
  spec.fields = {text_field("algorithm", "drawing algorithm", 48),
                 text_field("options", "its options, complete, in catalogue order", 96),
                 {"volume_order", "1", "exponent of n in the product of the theorem's bounds",
                  kFloat, sizeof(double)}};
  add_bound(spec.fields, "theorem");
  add_bound(spec.fields, "published");
  pack_fields(spec.fields);
  for (Field& field : spec.fields) field.required = false;
  return spec;
}

TableSpec make_graph_files_spec() {
  TableSpec spec{"graph_files", "files whose graphs are instances", {}};
  spec.fields = {
      {"name", "", "family of its rows", FieldType::text, 48},
      {"entry", "1", "which entry of the specification's graphs, from 0", FieldType::int64, 8},
      {"graphs", "1", "graphs in the file", FieldType::int64, 8},
      {"hash", "", "XXH3-128 of its graphs in order", FieldType::text, 32},
      {"path", "", "absolute path; %XX for bytes that are no printable ASCII", FieldType::text,
       1024},
      {"groups", "", "absolute path of a collection's table of groups, as path", FieldType::text,
       1024}};
  spec.fields.back().required = false;
  pack_fields(spec.fields);
  return spec;
}

TableSpec make_skipped_files_spec() {
  TableSpec spec{"skipped_files",
                 "files of collections that could not be read",
                 {text_field("name", "of the collection", 48),
                  text_field("file", "path within it", kSkippedFileBytes),
                  text_field("reason", "why it could not be read", 240)}};
  pack_fields(spec.fields);
  return spec;
}

TableSpec make_collected_files_spec() {
  TableSpec spec{"collected_files",
                 "files whose graphs are instances, as they were read",
                 {{"name", "", "family of their rows", FieldType::text, 48},
                  text_field("file", "path within the collection, %XX as in graph_files", 512),
                  text_field("group", "in rows", 48),
                  {"hash", "", "XXH3-128 of its graphs in order", FieldType::text, 32},
                  {"first", "1", "place of its first graph", kInt, sizeof(std::int64_t)},
                  {"graphs", "1", "graphs in it", kInt, sizeof(std::int64_t)}}};
  pack_fields(spec.fields);
  return spec;
}

constexpr std::size_t kPieceBytes = 1000;

TableSpec make_graphs_spec() {
  TableSpec spec{
      "graphs",
      "graphs of files, as one text in pieces",
      {text_field("text", "words: #FAMILY, @PLACE, :SPARSE6, =NUMBER of an earlier :SPARSE6",
                  kPieceBytes)}};
  pack_fields(spec.fields);
  return spec;
}

// A record of a table, whose fields are written or read one after the other.
class FieldCursor {
 public:
  FieldCursor(const TableSpec& spec, char* record) : spec_(spec), record_(record) {}

  void put(const std::string& text) {
    const Field& field = next();
    if (text != fitted_text(text, field.size)) {
      throw InputError(fmt::format("/{}: a {} is no printable text of at most {} bytes: {}",
                                   spec_.name, field.name, field.size, text));
    }
    text.copy(record_ + field.offset, text.size());
  }
  template <class Number>
  void put(Number value) {
    std::memcpy(record_ + next().offset, &value, sizeof(value));
  }
  void put_missing() {
    const Field& field = next();
    store_missing(field, record_ + field.offset);
  }

  std::string text() { return text_of(next(), record_); }
  template <class Number>
  Number number() {
    Number value{};
    std::memcpy(&value, record_ + next().offset, sizeof(value));
    return value;
  }

 private:
  const Field& next() { return spec_.fields[next_++]; }

  const TableSpec& spec_;
  char* record_;
  std::size_t next_ = 0;
};

// A table of what `put` writes of every record.
template <class Record, class Put>
StoredTable table_of(const TableSpec& spec, const std::vector<Record>& records, const Put& put) {
  const std::size_t size = record_size(spec.fields);
  StoredTable table{spec, std::vector<char>(records.size() * size, '\0')};
  for (std::size_t i = 0; i < records.size(); ++i) {
    FieldCursor to(spec, table.records.data() + i * size);
    put(to, records[i]);
  }
  return table;
}

// Calls `take` for every record of a study's table, if it has that table.
template <class Take>
void for_each_record(const StudyIdentity& identity, const TableSpec& spec, const Take& take) {
  const StoredTable* table = find_table(identity, spec.name);
  if (table == nullptr) return;
  std::vector<char> bytes = table->records;
  for (std::size_t i = 0; i < table->size(); ++i) {
    FieldCursor from(spec, bytes.data() + i * record_size(spec.fields));
    take(from);
  }
}

void put_bound(FieldCursor& to, const std::optional<SizeBound>& bound) {
  if (!bound) {
    for (std::size_t i = 0; i < kFieldsOfBound; ++i) to.put_missing();
    return;
  }
  to.put(bound->name);
  to.put(bound->source);
  to.put(bound->formula());
  for (const AxisBound& axis : bound->axes) {
    to.put(axis.numerator);
    to.put(axis.denominator);
    to.put(axis.half_power / 2.0);
    to.put(axis.constant);
  }
}

// Nothing if the bound is missing.
std::optional<SizeBound> take_bound(FieldCursor& from) {
  SizeBound bound;
  bound.name = from.text();
  bound.source = from.text();
  from.text();
  bool is_there = true;
  for (AxisBound& axis : bound.axes) {
    axis.numerator = from.number<std::int64_t>();
    axis.denominator = from.number<std::int64_t>();
    const double exponent = from.number<double>();
    axis.constant = from.number<std::int64_t>();
    is_there = is_there && !std::isnan(exponent);
    if (!is_there) continue;
    axis.half_power = static_cast<unsigned>(std::clamp(2 * exponent, 0.0, 100.0));
    if (axis.denominator < 1 || axis.half_power / 2.0 != exponent ||
        axis.half_power > kLargestHalfPower) {
      throw InputError(fmt::format("/algorithms: {}/{} n^{} + {} is no bound", axis.numerator,
                                   axis.denominator, exponent, axis.constant));
    }
  }
  if (!is_there) return std::nullopt;
  return bound;
}

}  // namespace

double AlgorithmRecord::volume_order() const {
  unsigned half_powers = 0;
  for (const AxisBound& axis : theorem.axes) half_powers += axis.half_power;
  return half_powers / 2.0;
}

const TableSpec& algorithms_spec() {
  static const TableSpec spec = make_algorithms_spec();
  return spec;
}

StoredTable algorithm_table(const std::vector<AlgorithmRecord>& records) {
  return table_of(algorithms_spec(), records, [](FieldCursor& to, const AlgorithmRecord& record) {
    to.put(record.algorithm);
    to.put(record.options);
    to.put(record.volume_order());
    put_bound(to, record.theorem);
    put_bound(to, record.published);
  });
}

std::vector<AlgorithmRecord> algorithm_records(const StudyIdentity& identity) {
  std::vector<AlgorithmRecord> records;
  for_each_record(identity, algorithms_spec(), [&](FieldCursor& from) {
    AlgorithmRecord record;
    record.algorithm = from.text();
    record.options = from.text();
    from.number<double>();  // follows from the bound
    const std::optional<SizeBound> theorem = take_bound(from);
    record.published = take_bound(from);
    if (!theorem) return;
    record.theorem = *theorem;
    records.push_back(std::move(record));
  });
  return records;
}

const AlgorithmRecord* find_algorithm_record(const std::vector<AlgorithmRecord>& records,
                                             std::string_view algorithm, std::string_view options) {
  for (const AlgorithmRecord& record : records) {
    if (record.algorithm == algorithm && record.options == options) return &record;
  }
  return nullptr;
}

void set_bounds(const AlgorithmRecord* record, RunRecord& run) {
  const SizeBound* theorem = record == nullptr ? nullptr : &record->theorem;
  set_bounds(theorem, record != nullptr && record->published ? &*record->published : nullptr, run);
}

void set_bounds(const SizeBound* theorem, const SizeBound* published, RunRecord& run) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = [&](const SizeBound* bound) {
      if (bound == nullptr || run.n < 0) return kMissing;
      return bound->axes[axis].value(static_cast<std::uint64_t>(run.n));
    };
    const double proved = value(theorem);
    run.theorem_bound[axis] = proved > 0 || run.n == 0 ? proved : kMissing;
    run.published_bound[axis] = value(published);
    const bool has_slack = proved > 0 && run.extents[axis] >= 0;
    run.slack[axis] = has_slack ? 1 - static_cast<double>(run.extents[axis]) / proved : kMissing;
  }
}

const TableSpec& graph_files_spec() {
  static const TableSpec spec = make_graph_files_spec();
  return spec;
}

StoredTable graph_file_table(const std::vector<GraphFileRecord>& records) {
  return table_of(graph_files_spec(), records, [](FieldCursor& to, const GraphFileRecord& record) {
    to.put(record.name);
    to.put(record.entry);
    to.put(record.graphs);
    to.put(record.hash);
    to.put(encoded(record.path));
    to.put(encoded(record.groups));
  });
}

const TableSpec& collected_files_spec() {
  static const TableSpec spec = make_collected_files_spec();
  return spec;
}

StoredTable collected_file_table(const std::vector<CollectedFile>& records) {
  return table_of(collected_files_spec(), records,
                  [](FieldCursor& to, const CollectedFile& record) {
                    to.put(record.name);
                    to.put(encoded(record.file));
                    to.put(record.group);
                    to.put(record.hash);
                    to.put(record.first);
                    to.put(record.graphs);
                  });
}

std::vector<CollectedFile> collected_file_records(const StudyIdentity& identity) {
  std::vector<CollectedFile> records;
  for_each_record(identity, collected_files_spec(), [&](FieldCursor& from) {
    CollectedFile& record = records.emplace_back();
    record.name = from.text();
    record.file = decoded(from.text());
    record.group = from.text();
    record.hash = from.text();
    record.first = from.number<std::int64_t>();
    record.graphs = from.number<std::int64_t>();
  });
  return records;
}

FileCounts file_counts(const StudyIdentity& identity) {
  std::set<std::pair<std::string, std::string>> read, given;
  for (const CollectedFile& file : collected_file_records(identity)) {
    if (!file.file.empty()) read.emplace(file.name, fitted_text(file.file, kSkippedFileBytes));
  }
  given = read;
  for (const SkippedFile& file : skipped_file_records(identity))
    given.emplace(file.name, file.file);
  return {read.size(), given.size()};
}

const TableSpec& graphs_spec() {
  static const TableSpec spec = make_graphs_spec();
  return spec;
}

StoredTable graphs_table(const HeldGraphs& graphs) {
  const std::string text = text_of_graphs(graphs);
  std::vector<std::string> pieces;
  for (std::size_t at = 0; at < text.size(); at += kPieceBytes) {
    pieces.push_back(text.substr(at, kPieceBytes));
  }
  return table_of(graphs_spec(), pieces,
                  [](FieldCursor& to, const std::string& piece) { to.put(piece); });
}

HeldGraphs held_graphs(const StudyIdentity& identity) {
  std::string text;
  for_each_record(identity, graphs_spec(), [&](FieldCursor& from) { text += from.text(); });
  return graphs_of_text(text);
}

const TableSpec& skipped_files_spec() {
  static const TableSpec spec = make_skipped_files_spec();
  return spec;
}

StoredTable skipped_file_table(const std::vector<SkippedFile>& records) {
  return table_of(skipped_files_spec(), records, [](FieldCursor& to, const SkippedFile& record) {
    to.put(record.name);
    to.put(fitted_text(record.file, kSkippedFileBytes));
    to.put(fitted_text(record.reason, 240));
  });
}

std::vector<SkippedFile> skipped_file_records(const StudyIdentity& identity) {
  std::vector<SkippedFile> records;
  for_each_record(identity, skipped_files_spec(), [&](FieldCursor& from) {
    SkippedFile& record = records.emplace_back();
    record.name = from.text();
    record.file = from.text();
    record.reason = from.text();
  });
  return records;
}

std::vector<GraphFileRecord> graph_file_records(const StudyIdentity& identity) {
  std::vector<GraphFileRecord> records;
  for_each_record(identity, graph_files_spec(), [&](FieldCursor& from) {
    GraphFileRecord& record = records.emplace_back();
    record.name = from.text();
    record.entry = from.number<std::int64_t>();
    record.graphs = from.number<std::int64_t>();
    record.hash = from.text();
    record.path = decoded(from.text());
    record.groups = decoded(from.text());
  });
  return records;
}

}  // namespace ar3d
