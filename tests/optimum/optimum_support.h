#pragma once

#include <utility>
#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/optimum/encoding.h"
#include "ar3d/optimum/smallest_box.h"
#include "ar3d/verify/certificate.h"
#include "optimum/second_encoding.h"
#include "support/graphs.h"

namespace ar3d::testing {

using optimum::BoxSize;
using optimum::Diagonals;
using optimum::Question;

/// Does the box hold a drawing, by the formulas of optimum/? A drawing is certified, and lies in it.
inline bool decide(const Graph& graph, const Question& question, const BoxSize& box,
                   const optimum::Solver& solver) {
  for (const optimum::PointClass& points : point_classes(question, box)) {
    if (points.points.size() < graph.num_vertices()) continue;  // it holds none
    const optimum::Encoding encoding(graph, question, points);
    const auto result = solver({.formula = encoding.formula()});
    if (result.answer != optimum::Answer::satisfiable) continue;
    const Drawing drawing = encoding.decode(result.model);
    const Certificate certificate =
        certify(graph, drawing, guarantee_of(question), {.check_size = false});
    EXPECT_TRUE(certificate.valid());
    for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(certificate.box.extents()[i], box[i]);
    return true;
  }
  return false;
}

/// Asks both encodings about boxes that are drawn at random. @return how many hold a drawing.
inline int compare_encodings(int cases, std::uint64_t seed) {
  const auto solver = optimum::cadical_solver();
  RandomStream random(seed);
  std::vector<std::vector<Graph>> sizes;
  for (const char* some : {"-c -D4 2", "-c -D4 3", "-c -D4 4", "-c -D4 5"}) {
    sizes.push_back(geng(some));
  }
  int drawings = 0;
  for (int i = 0; i < cases; ++i) {
    const std::vector<Graph>& graphs = sizes[random.below(4)];
    const Graph& graph = graphs[random.below(static_cast<std::uint32_t>(graphs.size()))];
    const bool is_face = graph.max_degree() <= 3 && random.chance(1, 2);
    const Question question{is_face ? Diagonals::face : Diagonals::body, random.below(6),
                            random.chance(1, 4)};
    const auto side = [&] { return static_cast<int>(1 + !is_face + random.below(5)); };
    const BoxSize box = {side(), side(), side()};
    const bool is_drawn = decide(graph, question, box, solver);
    drawings += is_drawn;
    EXPECT_EQ(is_drawn, holds_drawing(graph, question, box, solver))
        << graph_hash(graph) << ' ' << optimum::to_string(box) << ' ' << question.max_bends
        << is_face << question.in_plane;
  }
  return drawings;
}

/// The volume of the smallest box, found and certified without a limit of time.
inline std::int64_t smallest_volume(const Graph& graph, const Question& question) {
  const auto solver = optimum::cadical_solver();
  const optimum::SmallestBox found = find_smallest_box(graph, question, solver);
  EXPECT_TRUE(found.is_closed());
  EXPECT_TRUE(
      certify(graph, *found.drawing, guarantee_of(question), {.check_size = false}).valid());
  return found.at_most();
}

/// All connected graphs G - e that come from taking one edge away.
inline std::vector<Graph> without_an_edge(const Graph& graph) {
  std::vector<Graph> rest;
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    std::vector<Edge> edges(graph.edges().begin(), graph.edges().end());
    edges.erase(edges.begin() + e);
    Graph less(graph.num_vertices(), std::move(edges));
    if (connected_components_of(less).count == 1) rest.push_back(std::move(less));
  }
  return rest;
}

}  // namespace ar3d::testing
