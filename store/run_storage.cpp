// Rows of a study as run records, wherever they are kept: one after the other, or all in memory.
#include "ar3d/store/run_storage.h"

#include <fmt/format.h>

#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

std::size_t position_of(std::string_view name) {
  return static_cast<std::size_t>(&run_column(name) - run_columns().data());
}

RowFormat make_run_format() {
  RowFormat format;
  format.rows = {"runs",
                 "instance x algorithm x options x repetition",
                 {run_columns().begin(), run_columns().end()}};
  format.key = position_of("row_key");
  format.status = position_of("status");
  format.session = position_of("session");
  format.extract = {"instances", "one record per graph", {}};
  for (const Column& column : columns_of_kind(ColumnKind::instance)) {
    format.extract.fields.push_back(column);
    format.extract_fields.push_back(position_of(column.name));
  }
  pack_fields(format.extract.fields);
  format.extract_key = {position_of("family"), position_of("parameters"),
                        position_of("requested_n"), position_of("instance_index")};
  format.tables = {algorithms_spec(), graph_files_spec(), skipped_files_spec(),
                   collected_files_spec(), graphs_spec()};
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
    if (!run.row_key.empty()) parse_row_key(run.row_key);
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

RowView view_of(const Results& results) {
  return {&results, &results.environment, results.runs.size(), results.planned_rows,
          [&results](std::size_t row) -> const RunRecord& { return results.runs[row]; }};
}

RowView view_of(RunReader& reader) {
  const auto run = std::make_shared<RunRecord>();
  return {&reader.identity(), &reader.environment(), reader.size(), reader.identity().planned_rows,
          [&reader, run](std::size_t row) -> const RunRecord& {
            *run = reader.read(row);
            return *run;
          }};
}

}  // namespace ar3d
