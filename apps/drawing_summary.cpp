// A drawing as one line without its polylines: what --level extents and positions write.
#include "drawing_summary.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/model/real_points.h"
#include "ar3d/verify/metrics/volume_bound.h"

namespace ar3d {
namespace {

using nlohmann::ordered_json;

const char* verdict_of(const Certificate& certificate) {
  if (certificate.violated()) return "violated";
  if (certificate.measured) return "measured";
  if (certificate.mode == CertificateMode::none) return "not judged";
  return "proved";
}

ordered_json point_json(Point p) { return {p.x, p.y, p.z}; }

ordered_json metric_json(const MetricValue& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    return *integer < 0 ? ordered_json(nullptr) : ordered_json(*integer);
  }
  const double number = std::get<double>(value);
  return std::isfinite(number) ? ordered_json(number) : ordered_json(nullptr);
}

}  // namespace

Examination examine_all(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                        CertificateMode mode) {
  Examination examination = examine(graph, drawing, guarantee, {}, {.mode = mode});
  if (!examination.summary.real) {
    set_angles_and_crossings(graph, drawing, guarantee, examination.certificate,
                             examination.summary);
  }
  examination.summary.volume_at_least = volume_at_least(graph, guarantee);
  examination.summary.optimum = known_optimum(graph, guarantee);
  return examination;
}

void write_summary_line(OutputFile& output, const Drawing& drawing, const Examination& examination,
                        Level level) {
  ordered_json line = {
      {"n", drawing.num_vertices()},
      {"m", drawing.num_edges()},
      {"algorithm", drawing.algorithm()},
      {"level", to_string(level)},
      {"certificate", examination.certificate.measured ? std::string("measured")
                                                       : to_string(examination.certificate.mode)},
      {"verdict", verdict_of(examination.certificate)},
      {"violations", examination.certificate.violations.size()},
      {"drawing_hash", examination.drawing_hash}};
  if (!drawing.real) {
    const Box& box = examination.summary.box;
    line["box"] = {point_json(box.low), point_json(box.high)};
  }
  const std::vector<MetricValue> values = metric_values(examination.summary);
  for (std::size_t i = 0; i < values.size(); ++i) line[metrics()[i].name] = metric_json(values[i]);
  std::string text = line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
  if (level == Level::extents) {
    output.append(text + "\n");
    return;
  }
  text.back() = ',';  // instead of the brace
  output.append(text);
  if (drawing.real) {
    const ordered_json type = drawing.real->type;
    output.append("\"real_type\":" + type.dump() +
                  ",\"unit_exponent\":" + std::to_string(drawing.real->unit_exponent) + ",");
  }
  output.append("\"vertices\":");
  write_vertices(output, drawing);
  output.append("}\n");
}

}  // namespace ar3d
