// Tables for other programs: bounds, growth, every row, and all tables of a study.
#include "ar3d/analysis/export.h"

#include <fmt/format.h>

#include "ar3d/analysis/report/sections.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

}  // namespace

std::string bounds_csv(const StudyAnalysis& analysis) {
  return table_csv(report::bounds_table_of(analysis, report::sections(analysis)));
}

std::string scaling_csv(const StudyAnalysis& analysis) {
  return table_csv(report::growth_table_of(analysis, report::sections(analysis)));
}

void rows_csv(const RowView& rows, const TextSink& write) {
  const std::vector<Column> metrics = columns_of_kind(ColumnKind::metric);
  std::string csv = "row,algorithm,options,family,parameters,n,m,seed,status,certificate";
  for (const Column& metric : metrics) csv += "," + metric.name;
  for (const char* box : {"instance_bound", "theorem_bound", "published_bound", "slack"}) {
    for (const char axis : {'x', 'y', 'z'}) csv += fmt::format(",{}_{}", box, axis);
  }
  write(csv + "\r\n");
  const auto integer = [](std::int64_t value) { return value < 0 ? "" : std::to_string(value); };
  for (std::size_t row = 0; row < rows.count; ++row) {
    const RunRecord& run = rows.read(row);
    std::vector<std::string> fields = {std::to_string(row),
                                       csv_field(run.algorithm),
                                       csv_field(options_and_level(curve_of(run))),
                                       csv_field(run.family),
                                       csv_field(run.parameters),
                                       integer(run.n),
                                       integer(run.m),
                                       std::to_string(run.seed),
                                       to_string(run.status),
                                       csv_field(run.certificate)};
    for (const Column& metric : metrics) {
      const bool is_missing = std::isnan(column_number(metric, run));
      fields.push_back(is_missing ? "" : column_text(metric, run));
    }
    for (const std::int64_t bound : run.instance_bound) fields.push_back(integer(bound));
    for (const auto& values : {run.theorem_bound, run.published_bound, run.slack}) {
      for (const double value : values) fields.push_back(field(value));
    }
    write(fmt::format("{}\r\n", fmt::join(fields, ",")));
  }
}

std::string analysis_json(const StudyAnalysis& analysis, const SinceReference& since) {
  return tables_json(report_tables(analysis, since, {}, true));
}

}  // namespace ar3d
