// Theorem 2 as the paper's Section 3 builds it: Steps P.1 to P.12 of docs/theorem2-paper.md. All
// decisions are made once, in double (Repair P.1); then one template computes the points in the
// type that is asked for, so types differ by rounding alone. Whether this file rounds as IEEE 754
// says, on which that rests, is tested in it, with the flags of the drawings. Cost: O(n m) at worst
// for each cycle, O(N^2 log N) for N rays, O(k m) for k contracted vertices.
#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"

#include <fmt/format.h>

#include <cmath>

#include "ar3d/algorithms/two_bend_paper/expansion.h"
#include "ar3d/algorithms/two_bend_paper/growth.h"
#include "ar3d/algorithms/two_bend_paper/stacking.h"
#include "ar3d/base/error.h"
#include "ar3d/base/ieee_arithmetic.h"

namespace ar3d::two_bend_paper {
namespace {

/// A number of any of the types as an exact sum of doubles: each takes the leading 53 bits that are
/// left, so what remains is a number of the type, too.
template <class T>
DyadicNumber dyadic(T value) {
  std::array<double, 6> parts{};
  std::size_t count = 0;
  while (value != 0) {
    expect(count < parts.size(), "six doubles hold a number of 237 bits");
    parts[count] = static_cast<double>(value);
    if (!std::isfinite(parts[count])) {
      throw InputError("the real type is too narrow for this graph: a coordinate is not finite");
    }
    value = T(value - T(parts[count]));
    ++count;
  }
  return dyadic_sum(std::span(parts).first(count));
}

template <class T>
RealPointsBuilder::Point exact(const Vector3<T>& p) {
  return {dyadic(p.x), dyadic(p.y), dyadic(p.z)};
}

/// Holds what is decided before a real type comes into play.
struct Choices {
  ContractedGraph graph;
  std::vector<Component> components;
  std::vector<std::pair<double, bool>> rooms;  // of top_rooms()
};

Choices choose(const Graph& graph) {
  Choices choices;
  choices.graph = contract(graph);
  choices.components = grow(choices.graph);
  place(choices.graph, choices.components);
  choices.rooms = top_rooms(choices.graph, choices.components, graph.num_edges());
  return choices;
}

template <class T>
RealPoints draw_in(const Graph& graph, const Choices& choices, RealType type) {
  NodePoints<T> points = stack<T>(choices.graph, choices.components, graph.num_edges());
  Expansion<T>(choices.graph, points).run(choices.rooms);
  RealPointsBuilder builder(to_string(type));
  for (Vertex v = 0; v < graph.num_vertices(); ++v) builder.add_vertex(exact(points.of_node[v]));
  for (const auto& bends : points.bends) {
    std::vector<RealPointsBuilder::Point> exact_bends;
    for (const Vector3<T>& bend : bends) exact_bends.push_back(exact(bend));
    builder.add_edge(std::move(exact_bends));
  }
  return builder.finish();
}

RealPoints draw_chosen(const Graph& graph, const Choices& choices, RealType type) {
  switch (type) {
    case RealType::single_precision:
      return draw_in<float>(graph, choices, type);
    case RealType::double_precision:
      return draw_in<double>(graph, choices, type);
    case RealType::extended_precision:
      return draw_in<Extended>(graph, choices, type);
    case RealType::binary128:
      return draw_in<Binary128>(graph, choices, type);
    case RealType::reference:
      return draw_in<Reference>(graph, choices, type);
  }
  throw InternalError("internal error: no such real type");
}

/// Returns how many figures are inside one another.
std::int64_t deepest_nest(const ContractedGraph& graph) {
  const Node inputs = graph.num_nodes() - static_cast<Node>(graph.contractions.size());
  std::vector<std::int64_t> depth(graph.num_nodes());
  std::int64_t deepest = 0;
  for (const Contraction& step : graph.contractions) {
    std::int64_t inner = 0;
    for (const Node member : step.members) {
      if (member >= inputs) inner = std::max(inner, depth[member]);
    }
    depth[step.result] = inner + 1;
    deepest = std::max(deepest, inner + 1);
  }
  return deepest;
}

std::vector<Counter> counters_of(const Choices& choices) {
  std::int64_t cycles = 0, triskelions = 0, k4s = 0;
  for (const Component& component : choices.components) {
    k4s += component.k4 ? 1 : 0;
    for (const Step& step : component.steps) {
      cycles += step.kind == StepKind::cycle ? 1 : 0;
      triskelions += step.kind == StepKind::triskelion ? 1 : 0;
    }
  }
  return {{"components", static_cast<std::int64_t>(choices.components.size())},
          {"k4s", k4s},
          {"cycles", cycles},
          {"triskelions", triskelions},
          {"contractions", static_cast<std::int64_t>(choices.graph.contractions.size())},
          {"levels", deepest_nest(choices.graph)}};
}

}  // namespace

const char* to_string(RealType type) {
  constexpr std::array<const char*, kRealTypes> kNames{"float", "double", "binary80", "binary128",
                                                       "reference"};
  return kNames.at(static_cast<std::size_t>(type));
}

RealPoints draw_real(const Graph& graph, RealType type) {
  refuse_larger_degrees("two-bend-paper", graph, 3);
  return draw_chosen(graph, choose(graph), type);
}

Drawing draw(const Graph& graph, const Options& options) {
  refuse_larger_degrees("two-bend-paper", graph, 3);
  const Choices choices = choose(graph);
  Drawing drawing = real_drawing("two-bend-paper", graph.shared_edges(),
                                 draw_chosen(graph, choices, options.type));
  drawing.counters = counters_of(choices);
  return drawing;
}

Algorithm row() {
  return {
      .name = "two-bend-paper",
      .summary =
          "Section 3 as the paper builds it, in real arithmetic: what rounding makes of it is "
          "measured",
      .source = "Theorem 2",
      .guarantee = {.claim = Claim::measured,
                    .max_degree = 3,
                    .max_bends = 2,
                    .angle_rule = AngleRule::at_least,
                    .cosine = {-1, 2},
                    .lattice = kCubeLattice,
                    .directions = {},
                    .bound = {"none", "docs/theorem2-paper.md", {linear(0), linear(0), linear(0)}},
                    .published = {}},
      .options = {{"type", 0, kRealTypes - 1, static_cast<std::int64_t>(RealType::double_precision),
                   "bits of the significand: 0: 24 (float); 1: 53 (double); 2: 64 (binary80); "
                   "3: 113 (binary128); 4: 237 (reference)"}},
      .draw = [](const Graph& graph, const Settings& values) {
        const std::int64_t type = value_of(values, "type");
        if (type < 0 || type >= kRealTypes) {
          throw InputError(fmt::format("two-bend-paper has no type {}, its types are 0 to {}", type,
                                       kRealTypes - 1));
        }
        return draw(graph, {static_cast<RealType>(type)});
      }};
}

std::string arithmetic_departures() { return ar3d::arithmetic_departures(); }

}  // namespace ar3d::two_bend_paper
