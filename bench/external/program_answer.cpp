#include "ar3d/bench/external/program_answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/external/decimal.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/byte_source.h"

namespace ar3d {
namespace {

using Json = nlohmann::json;

struct DecimalPoint {
  std::array<Decimal, 3> at{};
  std::size_t count = 0;
};

struct DrawnEdge {
  std::vector<std::uint64_t> ends;
  std::vector<DecimalPoint> bends;
};

// Takes the numbers as they are written: a double would round them.
class AnswerEvents final : public nlohmann::json_sax<Json> {
 public:
  std::vector<DecimalPoint> vertices;
  std::optional<std::vector<DrawnEdge>> edges;
  std::string refusal;
  double own_s = std::numeric_limits<double>::quiet_NaN();
  bool has(const std::string& key) const { return keys_.contains(key); }

  bool null() override { refuse("null"); }
  bool boolean(bool) override { refuse("true or false"); }
  bool binary(binary_t&) override { refuse("binary data"); }
  bool number_integer(number_integer_t value) override { return number(std::to_string(value)); }
  bool number_unsigned(number_unsigned_t value) override { return number(std::to_string(value)); }
  bool number_float(number_float_t, const string_t& text) override { return number(text); }
  bool string(string_t& text) override {
    if (depth_ != 0 || key_ != "error") refuse("a text");
    refusal = text.empty() ? "no reason given" : text;
    return true;
  }
  bool start_object(std::size_t) override {
    if (begun_) refuse("an object");
    return begun_ = true;
  }
  bool end_object() override { return true; }
  bool key(string_t& name) override {
    static const std::set<std::string> kKnown = {"vertices", "edges", "error", "seconds", "n"};
    if (!kKnown.contains(name)) throw InputError(fmt::format("unknown key '{}'", printable(name)));
    if (!keys_.insert(name).second) throw InputError(fmt::format("key '{}' stands twice", name));
    key_ = name;
    if (name == "edges") edges.emplace();
    return true;
  }
  bool start_array(std::size_t) override {
    ++depth_;
    if (key_ == "vertices" && depth_ == 2) {
      vertices.emplace_back();
    } else if (key_ == "edges" && depth_ == 2) {
      edges->emplace_back();
    } else if (key_ == "edges" && depth_ == 3) {
      if (edges->back().ends.size() != 2) refuse("a list before the two ends of an edge");
    } else if (key_ == "edges" && depth_ == 4) {
      edges->back().bends.emplace_back();
    } else if (depth_ != 1 || (key_ != "vertices" && key_ != "edges")) {
      refuse("a list");
    }
    return true;
  }
  bool end_array() override {
    if (key_ == "edges" && depth_ == 2 && edges->back().ends.size() != 2) {
      refuse("an edge without two ends");
    }
    const DecimalPoint* const point = open_point();
    if (point != nullptr && point->count < 2) refuse("a point of less than two numbers");
    --depth_;
    return true;
  }
  bool parse_error(std::size_t column, const std::string& token,
                   const nlohmann::detail::exception&) override {
    throw InputError(fmt::format("column {}: no JSON at '{}'", column, printable(token)));
  }

 private:
  [[noreturn]] void refuse(const char* what) const {
    throw InputError(fmt::format("{} where none is expected, in '{}'", what, printable(key_)));
  }
  DecimalPoint* open_point() {
    if (key_ == "vertices" && depth_ == 2) return &vertices.back();
    if (key_ == "edges" && depth_ == 4) return &edges->back().bends.back();
    return nullptr;
  }
  bool number(const std::string& text) {
    if (DecimalPoint* const point = open_point()) {
      if (point->count == 3) refuse("a fourth coordinate");
      point->at[point->count++] = parse_decimal(text);
    } else if (key_ == "edges" && depth_ == 2) {
      const Decimal id = parse_decimal(text);
      std::vector<std::uint64_t>& ends = edges->back().ends;
      if (ends.size() == 2 || id.exponent < 0 || id.digits < 0) refuse("a number that is no end");
      ends.push_back(static_cast<std::uint64_t>(scaled(id, 0)));
    } else if (depth_ == 0 && key_ == "seconds") {
      own_s = std::strtod(text.c_str(), nullptr);
      if (!std::isfinite(own_s) || own_s < 0) refuse("a time that is none");
    } else if (depth_ != 0 || key_ != "n") {
      refuse("a number");
    }
    return true;
  }

  bool begun_ = false;
  int depth_ = 0;  // of arrays
  std::string key_;
  std::set<std::string> keys_;
};

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
  return {scaled(point.at[0], unit), scaled(point.at[1], unit), scaled(point.at[2], unit)};
}

Drawing scaled_drawing(const std::string& algorithm, const Graph& graph, const AnswerEvents& read) {
  require_vertices(graph, read.vertices.size());
  std::vector<Edge> ends;
  const auto id = [&](std::uint64_t value) {
    if (value >= graph.num_vertices()) {
      throw InputError(fmt::format("an edge has the end {}, the graph has {} vertices", value,
                                   graph.num_vertices()));
    }
    return static_cast<Vertex>(value);
  };
  int unit = 0;
  const auto note_unit = [&unit](const DecimalPoint& point) {
    for (const Decimal& number : point.at) unit = std::min(unit, number.exponent);
  };
  for (const DecimalPoint& point : read.vertices) note_unit(point);
  if (read.edges) {
    for (const DrawnEdge& edge : *read.edges) {
      ends.push_back({id(edge.ends[0]), id(edge.ends[1])});
      for (const DecimalPoint& point : edge.bends) note_unit(point);
    }
  }
  Coordinates vertices(graph.num_vertices(), kMaxCoordinate);
  for (std::size_t v = 0; v < read.vertices.size(); ++v) {
    vertices.set(v, integers(read.vertices[v], unit));
  }
  auto bends = std::make_shared<StoredBends>();
  const std::vector<std::size_t> order =
      read.edges ? matched_edges(graph, ends) : std::vector<std::size_t>();
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    std::vector<Point> points;
    if (read.edges) {
      const DrawnEdge& edge = (*read.edges)[order[e]];
      for (const DecimalPoint& point : edge.bends) points.push_back(integers(point, unit));
      if (edge.ends[0] > edge.ends[1]) std::reverse(points.begin(), points.end());
    }
    bends->add_edge(points);
  }
  Drawing drawing(algorithm, kCubeLattice, std::move(vertices), graph.shared_edges(), bends);
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
  AnswerEvents events;
  Json::sax_parse(line.begin(), line.end(), &events);
  ProgramAnswer answer;
  answer.own_s = events.own_s;
  answer.refusal = events.refusal;
  if (events.has("error")) return answer;
  if (!events.has("vertices")) throw InputError("neither 'vertices' nor 'error' is in it");
  answer.drawing = scaled_drawing(algorithm, graph, events);
  return answer;
}

}  // namespace ar3d
