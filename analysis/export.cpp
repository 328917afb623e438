#include "ar3d/analysis/export.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "ar3d/analysis/replay.h"
#include "ar3d/analysis/text.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

using nlohmann::ordered_json;

/// A field, quoted where RFC 4180 asks for it.
std::string field(const std::string& raw) {
  std::string text = valid_utf8(raw);
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::string field(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

std::string line(const std::vector<std::string>& fields) {
  return fmt::format("{}\r\n", fmt::join(fields, ","));
}

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json key_json(const CurveKey& key) {
  return {{"algorithm", valid_utf8(key.algorithm)},
          {"options", valid_utf8(options_and_level(key))},
          {"family", valid_utf8(key.family)},
          {"parameters", valid_utf8(key.parameters)}};
}

ordered_json axis_json(const CurveKey& key, const AxisBounds& axis, const ShowCommand& show) {
  ordered_json json = {{"measured", axis.measured},
                       {"worst_slack", number(axis.worst_slack)},
                       {"median_slack", number(axis.median_slack)},
                       {"worst_instance_slack", number(axis.worst_instance_slack)},
                       {"median_instance_slack", number(axis.median_instance_slack)},
                       {"worst_published_slack", number(axis.worst_published_slack)},
                       {"median_published_slack", number(axis.median_published_slack)},
                       {"worst_row", nullptr},
                       {"worst_command", nullptr}};
  if (axis.worst_row) {
    json["worst_row"] = *axis.worst_row;
    json["worst_command"] = valid_utf8(show(key, axis.worst));
  }
  return json;
}

ordered_json bounds_json(const BoundsEntry& entry, const ShowCommand& show) {
  ordered_json json = key_json(entry.key);
  json["smallest_n"] = entry.smallest_n;
  json["largest_n"] = entry.largest_n;
  json["rows"] = entry.rows;
  json["instances"] = entry.instances;
  json["violations"] = entry.violations;
  json["unproved"] = entry.unproved;
  json["edges_with_bends"] = entry.bends;
  json["theorem_bound"] = valid_utf8(entry.theorem_formula);
  json["published_bound"] = valid_utf8(entry.published_formula);
  json["volume"] = {{"n", entry.volume.n},
                    {"log2_volume", number(entry.volume.log2_volume)},
                    {"share", number(entry.volume.share)}};
  for (const AxisBounds& axis : entry.axes)
    json["axes"].push_back(axis_json(entry.key, axis, show));
  return json;
}

ordered_json interval_json(const Interval& interval) {
  return {number(interval.low), number(interval.high)};
}

ordered_json scaling_json(const ScalingEntry& entry) {
  ordered_json json = key_json(entry.key);
  json["quantity"] = name_of(entry.quantity);
  json["unit"] = unit_of(entry.quantity);
  json["decided"] = entry.decided;
  json["exponent"] = entry.power.fitted ? number(entry.power.exponent) : nullptr;
  json["exponent_interval"] = interval_json(entry.power.exponent_interval);
  json["law_interval"] = interval_json(entry.law_interval);
  json["growth"] = to_string(entry.growth);
  json["log_exponent"] = entry.with_log.fitted ? number(entry.with_log.log_exponent) : nullptr;
  json["log_exponent_interval"] = interval_json(entry.with_log.log_exponent_interval);
  json["log_weight"] = number(entry.log_weight);
  json["reason"] = entry.reason;
  json["next"] = entry.next;
  json["next_sizes"] = entry.next_study.sizes;
  json["next_seeds"] = entry.next_study.seeds;
  json["unfinished_rows"] = entry.censored.size();
  json["left_out"] = entry.sizes.left_out;
  json["sizes"] = ordered_json::array();
  for (const SizeSample& size : entry.sizes.used) json["sizes"].push_back(size.n);
  return json;
}

std::vector<std::string> key_fields(const CurveKey& key) {
  return {field(key.algorithm), field(options_and_level(key)), field(key.family),
          field(key.parameters)};
}

std::string bounds_line(const BoundsEntry& entry, const ShowCommand& show) {
  std::vector<std::string> fields = key_fields(entry.key);
  for (const std::int64_t n : {entry.smallest_n, entry.largest_n})
    fields.push_back(std::to_string(n));
  for (const std::size_t count : {entry.rows, entry.instances, entry.violations, entry.unproved}) {
    fields.push_back(std::to_string(count));
  }
  for (const AxisBounds& axis : entry.axes) {
    for (const double slack :
         {axis.worst_slack, axis.median_slack, axis.worst_instance_slack,
          axis.median_instance_slack, axis.worst_published_slack, axis.median_published_slack}) {
      fields.push_back(field(slack));
    }
  }
  fields.push_back(field(entry.volume.log2_volume));
  fields.push_back(field(entry.volume.share));
  const auto axis = worst_axis(entry);
  fields.push_back(axis ? field(show(entry.key, entry.axes[*axis].worst)) : "");
  return line(fields);
}

}  // namespace

std::string bounds_csv(const StudyAnalysis& analysis) {
  std::string csv =
      "algorithm,options,family,parameters,smallest_n,largest_n,rows,instances,violations,"
      "unproved";
  for (const char axis : {'x', 'y', 'z'}) {
    for (const char* column :
         {"worst_slack", "median_slack", "worst_instance_slack", "median_instance_slack",
          "worst_published_slack", "median_published_slack"}) {
      csv += fmt::format(",{}_{}", column, axis);
    }
  }
  csv += ",log2_volume,volume_share,worst_command\r\n";
  const ShowCommand show(analysis.rows);
  for (const BoundsEntry& entry : analysis.bounds) csv += bounds_line(entry, show);
  return csv;
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
    std::vector<std::string> fields = {
        std::to_string(row),   field(run.algorithm),     field(options_and_level(curve_of(run))),
        field(run.family),     field(run.parameters),    integer(run.n),
        integer(run.m),        std::to_string(run.seed), to_string(run.status),
        field(run.certificate)};
    for (const Column& metric : metrics) {
      const bool is_missing = std::isnan(column_number(metric, run));
      fields.push_back(is_missing ? "" : column_text(metric, run));
    }
    for (const std::int64_t bound : run.instance_bound) fields.push_back(integer(bound));
    for (const auto& values : {run.theorem_bound, run.published_bound, run.slack}) {
      for (const double value : values) fields.push_back(field(value));
    }
    write(line(fields));
  }
}

std::string scaling_csv(const StudyAnalysis& analysis) {
  std::string csv =
      "algorithm,options,family,parameters,quantity,sizes,smallest_n,largest_n,exponent,"
      "exponent_low,exponent_high,law_low,law_high,log_exponent,log_exponent_low,"
      "log_exponent_high,log_weight,growth,reason,next\r\n";
  for (const ScalingEntry& entry : analysis.scaling) {
    const auto& used = entry.sizes.used;
    std::vector<std::string> fields = key_fields(entry.key);
    fields.push_back(name_of(entry.quantity));
    fields.push_back(std::to_string(used.size()));
    fields.push_back(used.empty() ? "" : std::to_string(used.front().n));
    fields.push_back(used.empty() ? "" : std::to_string(used.back().n));
    fields.push_back(entry.power.fitted ? field(entry.power.exponent) : "");
    fields.push_back(field(entry.power.exponent_interval.low));
    fields.push_back(field(entry.power.exponent_interval.high));
    fields.push_back(field(entry.law_interval.low));
    fields.push_back(field(entry.law_interval.high));
    fields.push_back(entry.with_log.fitted ? field(entry.with_log.log_exponent) : "");
    fields.push_back(field(entry.with_log.log_exponent_interval.low));
    fields.push_back(field(entry.with_log.log_exponent_interval.high));
    fields.push_back(field(entry.log_weight));
    fields.push_back(to_string(entry.growth));
    fields.push_back(field(entry.reason));
    fields.push_back(field(entry.next));
    csv += line(fields);
  }
  return csv;
}

std::string analysis_json(const StudyAnalysis& analysis) {
  const CheckVerdict& verdict = analysis.verdict;
  ordered_json json;
  json["study_id"] = valid_utf8(analysis.rows.identity->study_id);
  json["verdict"] = {{"word", verdict.word()},
                     {"exit_code", verdict.exit_code()},
                     {"rows", verdict.rows},
                     {"proved", verdict.proved},
                     {"violated", verdict.violated_rows},
                     {"incomplete", verdict.incomplete_rows},
                     {"refused", verdict.refused}};
  json["bounds"] = ordered_json::array();
  const ShowCommand show(analysis.rows);
  for (const BoundsEntry& entry : analysis.bounds) {
    json["bounds"].push_back(bounds_json(entry, show));
  }
  json["scaling"] = ordered_json::array();
  for (const ScalingEntry& entry : analysis.scaling) json["scaling"].push_back(scaling_json(entry));
  return json.dump(1) + "\n";
}

}  // namespace ar3d
