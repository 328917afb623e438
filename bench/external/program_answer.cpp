// Reads the answer of a foreign program. Decimal numbers become integers of one common unit, so
// that its drawing is judged by the same exact code as ours, or the nearest values of a real type.
#include <fmt/format.h>

#include <charconv>
#include <numeric>

#include "ar3d/base/error.h"
#include "ar3d/bench/external/external_drawer.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/text_input.h"
#include "ar3d/model/real_points.h"

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

/// Index of each edge of the graph among those drawn; empty if all are straight.
std::vector<std::size_t> order_of_edges(const Graph& graph, const DecimalDrawing& read) {
  require_vertices(graph, read.vertices.size());
  if (!read.edges) return {};
  for (const auto [u, v] : *read.edges) {
    if (std::max(u, v) < graph.num_vertices()) continue;
    throw InputError(fmt::format("an edge has the end {}, the graph has {} vertices",
                                 std::max(u, v), graph.num_vertices()));
  }
  return matched_edges(graph, *read.edges);
}

/// The bends of an edge of the graph from its lower end, as they were written.
std::vector<DecimalPoint> bends_of(const DecimalDrawing& read,
                                   const std::vector<std::size_t>& order, EdgeId e) {
  if (order.empty()) return {};
  const std::size_t drawn = order[e];
  const DecimalPoint* all = read.bends.data();
  std::vector<DecimalPoint> bends(all + read.offsets[drawn], all + read.offsets[drawn + 1]);
  if ((*read.edges)[drawn].u > (*read.edges)[drawn].v) std::ranges::reverse(bends);
  return bends;
}

Drawing scaled_drawing(const std::string& algorithm, const Graph& graph,
                       const DecimalDrawing& read) {
  const std::vector<std::size_t> order = order_of_edges(graph, read);
  const int unit = common_unit(read);
  std::vector<Point> vertices;
  for (const auto& vertex : read.vertices) vertices.push_back(integers(vertex, unit));
  std::vector<std::vector<Point>> bends(graph.num_edges());
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    for (const auto& bend : bends_of(read, order, e)) bends[e].push_back(integers(bend, unit));
  }
  Drawing drawing = drawing_from_points(algorithm, graph, vertices, bends);
  drawing.counters.push_back({"decimals", -unit});
  return drawing;
}

template <class Real>
DyadicNumber nearest(const Decimal& number, const std::string& type) {
  const std::string text = fmt::format("{}e{}", number.digits, number.exponent);
  Real value{};
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc()) {
    throw InputError(fmt::format("{} is beyond the numbers of {}", text, type));
  }
  const double exact = value;
  return dyadic_sum({&exact, 1});
}

/// The drawing whose coordinates are the values of a real type nearest to those written.
Drawing rounded_drawing(const std::string& algorithm, const Graph& graph,
                        const DecimalDrawing& read, const std::string& type) {
  const std::vector<std::size_t> order = order_of_edges(graph, read);
  const auto rounded = [&](const DecimalPoint& point) {
    RealPointsBuilder::Point result;
    std::ranges::transform(point, result.begin(), [&](const Decimal& number) {
      return type == "float" ? nearest<float>(number, type) : nearest<double>(number, type);
    });
    return result;
  };
  RealPointsBuilder points(type);
  for (const auto& vertex : read.vertices) points.add_vertex(rounded(vertex));
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    std::vector<RealPointsBuilder::Point> bends;
    for (const auto& bend : bends_of(read, order, e)) bends.push_back(rounded(bend));
    points.add_edge(std::move(bends));
  }
  return real_drawing(algorithm, graph.shared_edges(), points.finish());
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

ProgramAnswer parse_answer(const std::string& algorithm, const Graph& graph, std::string_view line,
                           const std::string& type) {
  if (const auto zero = line.find('\0'); zero != std::string_view::npos) {
    throw InputError(fmt::format("column {}: a byte 0", zero + 1));
  }
  if (line.find("\"gram\"") != std::string_view::npos) {
    if (type.empty()) return parse_own_format(graph, line);
    throw InputError(fmt::format("integers and a Gram matrix are no coordinates of {}", type));
  }
  const DecimalDrawing read = read_decimal_drawing(line);
  ProgramAnswer answer{{}, read.error, read.seconds};
  if (!read.error.empty()) return answer;
  answer.drawing = type.empty() ? scaled_drawing(algorithm, graph, read)
                                : rounded_drawing(algorithm, graph, read, type);
  return answer;
}

}  // namespace ar3d
