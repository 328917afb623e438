#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ar3d/store/columns/run_record.h"
#include "ar3d/store/columns/study_identity.h"
#include "ar3d/store/columns/table.h"
#include "ar3d/verify/metrics/metrics.h"

namespace ar3d {

/// Returns the table /runs: the single description from which files, their readers, comparisons and
/// the schema page are made. Columns stand in the order of their bytes in a record. Name, unit and
/// meaning of a metric are those of its row in verify/metrics/metrics.h.
const StoredTable& runs_spec();
const std::vector<Column>& run_columns();

/// Returns the column of that name. @throws InternalError if there is none.
const Column& run_column(std::string_view name);

/// Returns bytes of a record: a row as its columns' bytes, one after the other. Records are what
/// journals and results files hold and what merging moves around.
std::size_t run_record_size();

/// Writes run_record_size() bytes. @throws InputError if an identifying text does not fit its
/// column.
void store_record(const RunRecord& run, char* record);
std::vector<char> record_of(const RunRecord& run);
RunRecord load_record(const char* record);

/// Gives the columns of that kind, in the same order. `offset` is their index in a record of /runs.
std::vector<Column> columns_of_kind(ColumnKind kind);

/// Takes over the metrics of a drawing: all of them, in one go.
void set_metrics(const DrawingSummary& summary, RunRecord& run);
/// Takes over another row's results, metrics and bounds: those of the same drawing.
void take_results(const RunRecord& from, RunRecord& run);

/// Returns a record with the metrics of a row and nothing else, whatever its texts are.
std::vector<char> metrics_record(const RunRecord& run);

/// Returns the value for people and CSV files: text, a decimal integer, or the shortest decimal
/// that reads back to the same double; "nan" if missing.
std::string column_text(const Column& column, const char* record);
/// Returns the value of a column of type int64 or float64; missing if it is -1 or NaN.
double column_number(const Column& column, const char* record);
/// Returns a metric of a row. Of many take them from metrics_record().
double column_number(const Column& metric, const RunRecord& run);

/// Returns the columns that are not measured and differ in their bits. Empty: the same result.
std::vector<std::string> differing_columns(const RunRecord& a, const RunRecord& b);

}  // namespace ar3d
