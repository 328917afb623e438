// Tables for other programs. A table is a list of named values by row; one writer makes lines of
// CSV of them, JSON takes them as they are.
#include "ar3d/analysis/export.h"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "ar3d/analysis/json.h"
#include "ar3d/analysis/replay.h"
#include "ar3d/base/printable.h"
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

/// The slacks of one axis.
ordered_json slacks_json(const AxisBounds& axis) {
  return {{"worst_slack", json_number(axis.worst_slack)},
          {"median_slack", json_number(axis.median_slack)},
          {"worst_instance_slack", json_number(axis.worst_instance_slack)},
          {"median_instance_slack", json_number(axis.median_instance_slack)},
          {"worst_published_slack", json_number(axis.worst_published_slack)},
          {"median_published_slack", json_number(axis.median_published_slack)}};
}

/// The columns that the bounds table has in CSV and in JSON.
ordered_json bounds_columns(const BoundsEntry& entry) {
  ordered_json json = key_json(entry.key);
  json["smallest_n"] = entry.smallest_n;
  json["largest_n"] = entry.largest_n;
  json["rows"] = entry.rows;
  json["instances"] = entry.instances;
  json["violations"] = entry.violations;
  json["unproved"] = entry.unproved;
  return json;
}

ordered_json bounds_json(const BoundsEntry& entry, const ShowCommand& show) {
  ordered_json json = bounds_columns(entry);
  json["edges_with_bends"] = entry.bends;
  json["theorem_bound"] = valid_utf8(entry.theorem_formula);
  json["published_bound"] = valid_utf8(entry.published_formula);
  json["volume"] = {{"n", entry.volume_n},
                    {"log2_volume", json_number(entry.log2_volume)},
                    {"share", json_number(entry.volume_share)},
                    {"over_least", json_number(entry.volume_over_least)}};
  for (const AxisBounds& axis : entry.axes) {
    ordered_json& one = json["axes"].emplace_back(ordered_json{{"measured", axis.measured}});
    one.update(slacks_json(axis));
    const bool is_bounded = !std::isnan(axis.worst_slack);
    one["worst_row"] = is_bounded ? ordered_json(axis.worst.row) : ordered_json(nullptr);
    one["worst_command"] =
        is_bounded ? ordered_json(valid_utf8(show(entry.key, axis.worst))) : ordered_json(nullptr);
  }
  return json;
}

/// A line of the bounds table in CSV.
ordered_json bounds_line(const BoundsEntry& entry, const ShowCommand& show) {
  ordered_json json = bounds_columns(entry);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const ordered_json slacks = slacks_json(entry.axes[axis]);
    for (const auto& [name, slack] : slacks.items()) {
      json[name + "_" + "xyz"[axis]] = slack;
    }
  }
  json["log2_volume"] = json_number(entry.log2_volume);
  json["volume_share"] = json_number(entry.volume_share);
  json["volume_over_least"] = json_number(entry.volume_over_least);
  const auto worst = worst_axis(entry);
  json["worst_command"] = worst ? show(entry.key, entry.axes[*worst].worst) : "";
  return json;
}

/// A line of the growth table in CSV.
ordered_json scaling_line(const ScalingEntry& entry) {
  const auto& used = entry.sizes.used;
  ordered_json json = key_json(entry.key);
  const auto add_interval = [&](const std::string& name, const Interval& interval) {
    json[name + "_low"] = json_number(interval.low);
    json[name + "_high"] = json_number(interval.high);
  };
  json["quantity"] = name_of(entry.quantity);
  json["sizes"] = used.size();
  json["smallest_n"] = used.empty() ? ordered_json(nullptr) : ordered_json(used.front().n);
  json["largest_n"] = used.empty() ? ordered_json(nullptr) : ordered_json(used.back().n);
  json["exponent"] = entry.power.fitted ? json_number(entry.power.exponent) : nullptr;
  add_interval("exponent", entry.power.exponent_interval);
  add_interval("law", entry.law_interval);
  json["log_exponent"] = entry.with_log.fitted ? json_number(entry.with_log.log_exponent) : nullptr;
  add_interval("log_exponent", entry.with_log.log_exponent_interval);
  json["log_weight"] = json_number(entry.log_weight);
  json["growth"] = to_string(entry.growth);
  json["reason"] = entry.reason;
  json["next"] = entry.next;
  return json;
}

/// The lines of a table below the names of its columns.
template <class Entry, class LineOf>
std::string csv_table(const std::vector<Entry>& entries, const LineOf& line_of) {
  std::vector<std::string> names;
  const ordered_json empty = line_of(Entry());
  for (const auto& [name, value] : empty.items()) names.push_back(name);
  std::string csv = line(names);
  for (const Entry& entry : entries) {
    std::vector<std::string> fields;
    const ordered_json columns = line_of(entry);
    for (const auto& value : columns) {
      fields.push_back(value.is_null()           ? ""
                       : value.is_string()       ? field(value.template get<std::string>())
                       : value.is_number_float() ? field(value.template get<double>())
                                                 : value.dump());
    }
    csv += line(fields);
  }
  return csv;
}

ordered_json interval_json(const Interval& interval) {
  return {json_number(interval.low), json_number(interval.high)};
}

ordered_json scaling_json(const ScalingEntry& entry) {
  ordered_json json = key_json(entry.key);
  json["quantity"] = name_of(entry.quantity);
  json["unit"] = unit_of(entry.quantity);
  json["decided"] = entry.decided;
  json["exponent"] = entry.power.fitted ? json_number(entry.power.exponent) : nullptr;
  json["exponent_interval"] = interval_json(entry.power.exponent_interval);
  json["law_interval"] = interval_json(entry.law_interval);
  json["growth"] = to_string(entry.growth);
  json["log_exponent"] = entry.with_log.fitted ? json_number(entry.with_log.log_exponent) : nullptr;
  json["log_exponent_interval"] = interval_json(entry.with_log.log_exponent_interval);
  json["log_weight"] = json_number(entry.log_weight);
  json["reason"] = entry.reason;
  json["next"] = entry.next;
  json["next_sizes"] = entry.next_sizes;
  json["next_seeds"] = entry.next_seeds;
  json["unfinished_rows"] = entry.censored.size();
  json["left_out"] = entry.sizes.left_out;
  json["sizes"] = ordered_json::array();
  for (const SizeSample& size : entry.sizes.used) json["sizes"].push_back(size.n);
  return json;
}

}  // namespace

std::string bounds_csv(const StudyAnalysis& analysis) {
  const ShowCommand show(analysis.rows);
  return csv_table(analysis.bounds,
                   [&](const BoundsEntry& entry) { return bounds_line(entry, show); });
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
  return csv_table(analysis.scaling, scaling_line);
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
