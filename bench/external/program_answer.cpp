// Reads the answer of a foreign program. Decimal numbers become integers of one common unit, so
// that its drawing is judged by the same exact code as ours.
#include <fmt/format.h>

#include <numeric>

#include "ar3d/base/error.h"
#include "ar3d/bench/external/external_drawer.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/text_input.h"

namespace ar3d {
namespace {

Edge canonical(Edge edge) { return edge.u < edge.v ? edge : Edge{edge.v, edge.u}; }

void require_vertices(const Graph& graph, std::size_t drawn) {
  if (drawn == graph.num_vertices()) return;
  throw InputError(
      fmt::format("{} vertices are drawn, the graph has {}", drawn, graph.num_vertices()));
}

// The drawn edges in the order of the graph's; each has to be there once.
std::vector<std::size_t> matched_edges(const Graph& graph, const std::vector<Edge>& drawn) {
  std::vector<std::size_t> order(drawn.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) {
    const Edge edge = canonical(drawn[i]);
    return std::pair(edge.u, edge.v);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  bool equal = order.size() == graph.num_edges();
  for (std::size_t i = 0; equal && i < order.size(); ++i) {
    equal = canonical(drawn[order[i]]) == graph.edge(static_cast<EdgeId>(i));
  }
  if (!equal) throw InputError("the drawn edges are not those of the graph");
  return order;
}

Point integers(const DecimalPoint& point, int unit) {
  return {scaled(point[0], unit), scaled(point[1], unit), scaled(point[2], unit)};
}

// The largest power of ten that all coordinates are integer multiples of, at most 1.
int common_unit(const DecimalDrawing& read) {
  int unit = 0;
  for (const auto* const points : {&read.vertices, &read.bends}) {
    for (const DecimalPoint& point : *points) {
      for (const Decimal& number : point) unit = std::min(unit, number.exponent);
    }
  }
  return unit;
}

Drawing scaled_drawing(const std::string& algorithm, const Graph& graph,
                       const DecimalDrawing& read) {
  require_vertices(graph, read.vertices.size());
  std::vector<std::size_t> order;
  if (read.edges) {
    for (const auto [u, v] : *read.edges) {
      if (std::max(u, v) < graph.num_vertices()) continue;
      throw InputError(fmt::format("an edge has the end {}, the graph has {} vertices",
                                   std::max(u, v), graph.num_vertices()));
    }
    order = matched_edges(graph, *read.edges);
  }
  const int unit = common_unit(read);
  std::vector<Point> vertices;
  for (const auto& vertex : read.vertices) vertices.push_back(integers(vertex, unit));
  std::vector<std::vector<Point>> bends;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    std::vector<Point>& points = bends.emplace_back();
    if (read.edges) {
      const std::size_t drawn = order[e];
      for (std::size_t i = read.offsets[drawn]; i < read.offsets[drawn + 1]; ++i) {
        points.push_back(integers(read.bends[i], unit));
      }
      if ((*read.edges)[drawn].u > (*read.edges)[drawn].v)
        std::reverse(points.begin(), points.end());
    }
  }
  Drawing drawing = drawing_from_points(algorithm, graph, vertices, bends);
  drawing.counters.push_back({"decimals", -unit});
  return drawing;
}

// A drawing as this program writes them.
ProgramAnswer parse_own_format(const Graph& graph, std::string_view line) {
  DrawingJsonlReader reader(TextInput("its answer", bytes_of(std::string(line))));
  std::optional<DrawingJsonlReader::Line> read = reader.next();
  if (!read) throw InputError("an empty line");
  if (const auto* undrawn = std::get_if<UndrawnGraph>(&*read)) return {{}, undrawn->error};
  ProgramAnswer answer;
  answer.drawing = std::get<Drawing>(std::move(*read));
  require_vertices(graph, answer.drawing->num_vertices());
  std::vector<Edge> ends;
  for (EdgeId e = 0; e < answer.drawing->num_edges(); ++e) ends.push_back(answer.drawing->edge(e));
  matched_edges(graph, ends);
  return answer;
}

}  // namespace

ProgramAnswer parse_answer(const std::string& algorithm, const Graph& graph,
                           std::string_view line) {
  if (const auto zero = line.find('\0'); zero != std::string_view::npos) {
    throw InputError(fmt::format("column {}: a byte 0", zero + 1));
  }
  if (line.find("\"gram\"") != std::string_view::npos) return parse_own_format(graph, line);
  const DecimalDrawing read = read_decimal_drawing(line);
  ProgramAnswer answer{{}, read.error, read.seconds};
  if (read.error.empty()) answer.drawing = scaled_drawing(algorithm, graph, read);
  return answer;
}

}  // namespace ar3d
