#include <cmath>
#include <nlohmann/json.hpp>

#include "ar3d/analysis/compare.h"
#include "ar3d/analysis/text.h"

namespace ar3d {
namespace {

using nlohmann::ordered_json;

ordered_json number(double value) {
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json time_json(const TimeVerdict& time) {
  const SignedRankTest& test = time.test;
  return {{"pairs", test.pairs},
          {"ratio", number(std::exp(test.estimate))},
          {"ratio_low", number(std::exp(test.interval.low))},
          {"ratio_high", number(std::exp(test.interval.high))},
          {"p_value", number(test.p_value())},
          {"adjusted_p_value", number(time.adjusted_p)}};
}

ordered_json cell_json(const CellComparison& cell) {
  return {{"algorithm", valid_utf8(cell.key.algorithm)},
          {"options", valid_utf8(options_and_level(cell.key))},
          {"family", valid_utf8(cell.key.family)},
          {"parameters", valid_utf8(cell.key.parameters)},
          {"n", cell.n >= 0 ? ordered_json(cell.n) : ordered_json(nullptr)},
          {"verdict", to_string(cell.verdict)},
          {"reason", valid_utf8(cell.reason)},
          {"measurements", cell.rows},
          {"volume_ratio", number(std::exp2(cell.log2_volume_change))},
          {"time", time_json(cell.time)}};
}

ordered_json environment_json(const Comparison& comparison) {
  ordered_json changes = ordered_json::array();
  for (const EnvironmentChange& change : comparison.environment) {
    changes.push_back({{"name", valid_utf8(change.name)},
                       {"base", valid_utf8(change.base)},
                       {"new", valid_utf8(change.now)}});
  }
  return changes;
}

ordered_json calibration_json(const Calibration& calibration) {
  return {{"cells", calibration.cells},
          {"pairs", calibration.pairs},
          {"false_alarms", calibration.false_alarms},
          {"relabellings", calibration.relabellings},
          {"false_alarm_rate", number(calibration.false_alarm_rate())},
          {"smallest_slowdown_median", number(calibration.smallest_slowdown_median)},
          {"smallest_slowdown_worst", number(calibration.smallest_slowdown_worst)}};
}

}  // namespace

std::string comparison_json(const Comparison& comparison, const CompareOptions& options,
                            const Calibration* calibration) {
  ordered_json json;
  json["verdict"] = comparison.word();
  json["exit_code"] = comparison.exit_code();
  json["judged"] = comparison.judged();
  json["rule"] = {{"threshold", options.time.threshold},
                  {"significance", options.time.significance},
                  {"false_discovery_rate", options.time.false_discovery_rate},
                  {"confidence", options.time.confidence},
                  {"instruction_threshold", options.instruction_threshold},
                  {"drawings_only", options.drawings_only}};
  json["time_judged"] = comparison.time_judged;
  json["environment_changes"] = environment_json(comparison);
  json["measurements"] = comparison.rows;
  for (const Verdict verdict : {Verdict::pass, Verdict::improved, Verdict::unjudged,
                                Verdict::inconclusive, Verdict::regressed, Verdict::violated}) {
    json["counts"][to_string(verdict)] = comparison.count(verdict);
  }
  for (const auto& [name, lines] : {std::pair{"incomplete", &comparison.incomplete},
                                    std::pair{"remarks", &comparison.remarks}}) {
    json[name] = ordered_json::array();
    for (const std::string& line : *lines) json[name].push_back(valid_utf8(line));
  }
  if (calibration != nullptr) json["calibration"] = calibration_json(*calibration);
  json["cells"] = ordered_json::array();
  for (const CellComparison& cell : comparison.cells) json["cells"].push_back(cell_json(cell));
  return json.dump(1) + "\n";
}

}  // namespace ar3d
