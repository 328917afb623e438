#include "ar3d/store/run_storage.h"

#include <fmt/format.h>

#include <cstring>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/former_formula.h"
#include "ar3d/store/columns/graph_file_table.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

std::size_t place_of(std::string_view name) {
  return static_cast<std::size_t>(&run_column(name) - run_columns().data());
}

std::string text_at(const Field& field, const char* record) {
  const char* from = record + field.offset;
  return std::string(from, strnlen(from, field.size));
}

// Is there a record of the row's algorithm and options? They are the first two fields.
bool is_kept(const char* record, const StudyIdentity& identity) {
  static const Column& algorithm = run_column("algorithm");
  static const Column& options = run_column("options");
  const StoredTable* table = find_table(identity, algorithms_spec().name);
  for (std::size_t i = 0; table != nullptr && i < table->size(); ++i) {
    const char* kept = table->record(i);
    if (std::memcmp(kept, record + algorithm.offset, algorithm.size) == 0 &&
        std::memcmp(kept + algorithm.size, record + options.offset, options.size) == 0) {
      return true;
    }
  }
  return false;
}

// Files of version 2 have the bounds of algorithm and options in every row: they become a record of
// /algorithms. Rows without a drawing have none.
void keep_bounds(const std::vector<Field>& former, const char* record, StudyIdentity& identity) {
  if (is_kept(record, identity)) return;
  RunRecord run;
  run.algorithm = text_at(run_column("algorithm"), record);
  run.options = text_at(run_column("options"), record);
  const std::string theorem = text_at(former[0], record);
  const std::string published = text_at(former[1], record);
  if (theorem.empty()) return;
  std::vector<AlgorithmRecord> records = algorithm_records(identity);
  records.push_back({run.algorithm, run.options, parse_formula(theorem), std::nullopt});
  if (!published.empty()) records.back().published = parse_formula(published);
  identity.tables = {algorithm_table(records)};
}

std::vector<Field> former_fields() {
  std::vector<Field> fields = {
      {"theorem_bound_formula", "", "the theorem's bound by axis", FieldType::text, 128},
      {"published_bound_formula", "", "the published bound by axis", FieldType::text, 128}};
  pack_fields(fields);
  for (Field& field : fields) field.offset += run_record_size();
  return fields;
}

RowFormat make_run_format() {
  RowFormat format;
  format.rows = {"runs",
                 "instance x algorithm x options x repetition",
                 {run_columns().begin(), run_columns().end()}};
  format.key = place_of("row_key");
  format.status = place_of("status");
  format.session = place_of("session");
  format.extract = {"instances", "one record per graph", {}, {}};
  for (const Column& column : columns_of_kind(ColumnKind::instance)) {
    format.extract.fields.push_back(place_of(column.name));
  }
  format.extract.key = {place_of("family"), place_of("parameters"), place_of("requested_n"),
                        place_of("instance_index")};
  format.tables = {algorithms_spec(), graph_files_spec()};
  format.former_fields = former_fields();
  format.keep_of_former = [former = format.former_fields](const char* record,
                                                          StudyIdentity& identity) {
    keep_bounds(former, record, identity);
  };
  return format;
}

}  // namespace

const RowFormat& run_format() {
  static const RowFormat format = make_run_format();
  return format;
}

void append_run(JournalWriter& journal, const RunRecord& run) {
  journal.append([&run](char* record) { store_record(run, record); });
}

RunReader::RunReader(const std::string& path)
    : path_(path),
      reader_(path, run_format()),
      algorithms_(algorithm_records(reader_.identity())) {}

RunRecord RunReader::read(std::size_t i) {
  const char* record = reader_.read(i);
  try {
    RunRecord run = load_record(record);
    set_bounds(find_algorithm_record(algorithms_, run.algorithm, run.options), run);
    return run;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: row {}: {}", path_, i, error.what()));
  }
}

void write_results(const Results& results, const std::string& path) {
  const auto read = [&](std::size_t i, char* record) { store_record(results.runs[i], record); };
  write_results(results, results.environment, run_format(), {results.runs.size(), read}, path);
}

Results read_results(const std::string& path) {
  RunReader reader(path);
  Results results;
  static_cast<StudyIdentity&>(results) = reader.identity();
  results.environment = reader.environment();
  results.runs.reserve(reader.size());
  for (std::size_t i = 0; i < reader.size(); ++i) results.runs.push_back(reader.read(i));
  return results;
}

}  // namespace ar3d
