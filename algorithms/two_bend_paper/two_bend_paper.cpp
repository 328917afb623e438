// Theorem 2 as the paper's Section 3 builds it: Steps P.1 to P.12 of docs/theorem2-paper.md.
#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "ar3d/algorithms/degree_limit.h"
#include "ar3d/algorithms/two_bend_paper/clearance.h"
#include "ar3d/algorithms/two_bend_paper/expansion.h"
#include "ar3d/algorithms/two_bend_paper/placement.h"
#include "ar3d/algorithms/two_bend_paper/stacking.h"
#include "ar3d/model/error.h"

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

/// What is decided before a real type comes into play.
struct Choices {
  ContractedGraph graph;
  std::vector<PlacedComponent> components;
  std::vector<Room> rooms;
};

Choices choose(const Graph& graph) {
  Choices choices;
  choices.graph = contract(graph);
  choices.components = place(choices.graph, grow(choices.graph));
  choices.rooms = top_rooms(choices.graph, choices.components, graph.num_edges());
  return choices;
}

template <class T>
RealPoints draw_in(const Graph& graph, RealType type) {
  const Choices choices = choose(graph);
  Points<T> points = stack<T>(choices.graph, choices.components, graph.num_edges());
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

}  // namespace

const char* to_string(RealType type) {
  switch (type) {
    case RealType::single_precision:
      return "float";
    case RealType::double_precision:
      return "double";
    case RealType::extended_precision:
      return "long double";
    case RealType::binary128:
      return "binary128";
    case RealType::reference:
      return "reference";
  }
  throw InternalError("internal error: no such real type");
}

RealPoints draw_real(const Graph& graph, RealType type) {
  refuse_larger_degrees("two-bend-paper", graph, 3);
  switch (type) {
    case RealType::single_precision:
      return draw_in<float>(graph, type);
    case RealType::double_precision:
      return draw_in<double>(graph, type);
    case RealType::extended_precision:
      return draw_in<long double>(graph, type);
    case RealType::binary128:
      return draw_in<Binary128>(graph, type);
    case RealType::reference:
      return draw_in<Reference>(graph, type);
  }
  throw InternalError("internal error: no such real type");
}

}  // namespace ar3d::two_bend_paper
