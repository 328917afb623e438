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

/// Takes over the metrics of a drawing: all of them, in one go.
void set_metrics(const DrawingSummary& summary, RunRecord& run);
/// Returns the values of metrics(), in that order.
std::vector<MetricValue> metrics_of(const RunRecord& run);
/// Returns the value as a number; NaN: missing.
double number_of(const MetricValue& value);
/// Returns the number of the metric of that name. @throws InternalError if there is none.
double metric_of(const RunRecord& run, std::string_view name);

/// Returns the columns that are not measured and differ in their bits. Empty: the same result.
std::vector<std::string> differing_columns(const RunRecord& a, const RunRecord& b);

}  // namespace ar3d
