// Steps O.1 to O.3 and O.6 to O.8 of the formula: where vertices are, which point is whose, how
// edges leave their ends.
#include "ar3d/optimum/encoding.h"

#include "ar3d/base/error.h"

namespace ar3d::optimum {

Encoding::Encoding(const Graph& graph, const Question& question, const PointClass& points)
    : graph_(graph), question_(question), points_(points), steps_(steps_of(question.diagonals)) {
  expect(points.points.size() >= graph.num_vertices(), "every vertex may have a point");
  make_variables();
  add_positions();
  add_owners();
  add_steps();
  add_turns();
  add_bends();
  add_stars();
  if (question.diagonals == Diagonals::body) add_tetrahedra();
  if (question.in_plane) add_plane();
  break_graph_symmetry();
  break_box_symmetry();
}

Encoding::Table Encoding::table(std::size_t rows, std::size_t columns) {
  Table made(rows, Row(columns));
  for (Row& row : made) {
    for (int& variable : row) variable = formula_.new_variable();
  }
  return made;
}

void Encoding::make_variables() {
  const auto n = static_cast<std::size_t>(num_points());
  vertex_at_ = table(graph_.num_vertices(), n);
  vertex_until_ = table(graph_.num_vertices(), n);
  edge_at_ = table(graph_.num_edges(), n);
  step_.assign(n, Row(num_steps()));
  into_.assign(n, Row(num_steps()));
  for (std::size_t p = 0; p < n; ++p) {
    for (std::size_t d = 0; d < num_steps(); ++d) {
      const int q = points_.neighbours[p][d];
      if (q >= 0) step_[p][d] = into_[static_cast<std::size_t>(q)][d] = formula_.new_variable();
    }
  }
  bends_before_ = table(n, question_.max_bends + 1);
  is_bend_ = table(1, n)[0];
  is_inside_ = table(1, n)[0];
  is_vertex_ = table(1, n)[0];
  for (EdgeId e = 0; e < graph_.num_edges(); ++e) leaves_.push_back(table(2, num_steps()));
  for (const Vector& d : steps_) {
    for (std::size_t f = 0; f < num_steps(); ++f) {
      if (steps_[f] == -d) opposite_.push_back(static_cast<int>(f));
    }
  }
}

int Encoding::inner_product(std::size_t d, std::size_t f) const {
  return static_cast<int>(steps_[d].x * steps_[f].x + steps_[d].y * steps_[f].y +
                          steps_[d].z * steps_[f].z);
}

bool Encoding::is_in_first_tetrahedron(std::size_t d) const {
  return steps_[d].x * steps_[d].y * steps_[d].z > 0;
}

Vertex Encoding::end_of(EdgeId e, std::size_t end) const {
  const Edge edge = graph_.edge(e);
  return end == 0 ? edge.u : edge.v;
}

void Encoding::at_most_one(std::span<const int> literals) {
  for (std::size_t i = 0; i < literals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) formula_.add({-literals[i], -literals[j]});
  }
}

// Every vertex is at exactly one point.
void Encoding::add_positions() {
  for (Vertex u = 0; u < graph_.num_vertices(); ++u) {
    const Row& at = vertex_at_[u];
    const Row& until = vertex_until_[u];
    for (std::size_t p = 0; p < at.size(); ++p) {
      formula_.add({-at[p], until[p]});
      if (p == 0) {
        formula_.add({-until[p], at[p]});
        continue;
      }
      formula_.add({-until[p - 1], until[p]});
      formula_.add({-until[p - 1], -at[p]});
      formula_.add({-until[p], until[p - 1], at[p]});
    }
    formula_.add({until.back()});
  }
}

// A point is at most one vertex's or inside at most one edge.
void Encoding::add_owners() {
  for (std::size_t p = 0; p < points_.points.size(); ++p) {
    Row vertices = {-is_vertex_[p]};
    Row edges = {-is_inside_[p]};
    Row owners;
    for (const Row& at : vertex_at_) {
      vertices.push_back(at[p]);
      formula_.add({-at[p], is_vertex_[p]});
      owners.push_back(at[p]);
    }
    for (const Row& at : edge_at_) {
      edges.push_back(at[p]);
      formula_.add({-at[p], is_inside_[p]});
      owners.push_back(at[p]);
    }
    at_most_one(owners);
    formula_.add(vertices);
    formula_.add(edges);
    formula_.add({-is_inside_[p], -is_vertex_[p]});
  }
}

// A step leads from a point of an edge to the next point of the same edge.
void Encoding::add_steps() {
  for (std::size_t p = 0; p < points_.points.size(); ++p) {
    for (std::size_t d = 0; d < num_steps(); ++d) {
      const int step = step_[p][d];
      if (step == 0) continue;
      const auto q = static_cast<std::size_t>(points_.neighbours[p][d]);
      const auto back = static_cast<std::size_t>(opposite_[d]);
      if (p < q) formula_.add({-step, -step_[q][back]});
      formula_.add({-step, is_inside_[p], is_vertex_[p]});
      formula_.add({-step, is_inside_[q], is_vertex_[q]});
      for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
        const auto [u, w] = graph_.edge(e);
        formula_.add({-step, -edge_at_[e][p], edge_at_[e][q], vertex_at_[w][q]});
        formula_.add({-step, -edge_at_[e][q], edge_at_[e][p], vertex_at_[u][p]});
      }
      for (Vertex u = 0; u < graph_.num_vertices(); ++u) {
        Row leaves = {-step, -vertex_at_[u][p]};
        Row arrives = {-step, -vertex_at_[u][q]};
        for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
          if (graph_.edge(e).u == u) leaves.push_back(leaves_[e][0][d]);
          if (graph_.edge(e).v == u) arrives.push_back(leaves_[e][1][back]);
        }
        formula_.add(leaves);
        formula_.add(arrives);
      }
    }
  }
}

// An edge leaves each end along exactly one step, at the angle to the others there.
void Encoding::add_stars() {
  for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
    for (std::size_t end = 0; end < 2; ++end) {
      formula_.add(leaves_[e][end]);
      at_most_one(leaves_[e][end]);
      add_star_of(e, end);
    }
  }
}

void Encoding::add_star_of(EdgeId e, std::size_t end) {
  const Vertex u = end_of(e, end);
  const Vertex w = end_of(e, 1 - end);
  for (std::size_t d = 0; d < num_steps(); ++d) {
    const int leaves = leaves_[e][end][d];
    for (std::size_t p = 0; p < points_.points.size(); ++p) {
      const int at = points_.neighbours[p][d];
      if (at < 0) {
        formula_.add({-vertex_at_[u][p], -leaves});
        continue;
      }
      const auto q = static_cast<std::size_t>(at);
      const int step = end == 0 ? step_[p][d] : step_[q][static_cast<std::size_t>(opposite_[d])];
      formula_.add({-vertex_at_[u][p], -leaves, step});
      formula_.add({-vertex_at_[u][p], -leaves, edge_at_[e][q], vertex_at_[w][q]});
    }
  }
  for (EdgeId other = 0; other < e; ++other) {
    for (std::size_t at = 0; at < 2; ++at) {
      if (end_of(other, at) != u) continue;
      for (std::size_t d = 0; d < num_steps(); ++d) {
        for (std::size_t f = 0; f < num_steps(); ++f) {
          if (inner_product(d, f) != -1)
            formula_.add({-leaves_[e][end][d], -leaves_[other][at][f]});
        }
      }
    }
  }
}

// Implied by the rest: the steps at a vertex are of one tetrahedron, and a bend changes it.
void Encoding::add_tetrahedra() {
  const Row first = table(1, graph_.num_vertices())[0];
  const auto agree = [&](int of, std::size_t d) { return is_in_first_tetrahedron(d) ? of : -of; };
  for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
    for (std::size_t end = 0; end < 2; ++end) {
      for (std::size_t d = 0; d < num_steps(); ++d) {
        formula_.add({-leaves_[e][end][d], agree(first[end_of(e, end)], d)});
      }
    }
  }
  for (std::size_t p = 0; p < points_.points.size(); ++p) {
    const int reached_by_first = formula_.new_variable();
    for (std::size_t d = 0; d < num_steps(); ++d) {
      const int as_reached = agree(reached_by_first, d);
      if (into_[p][d] != 0) formula_.add({-is_inside_[p], -into_[p][d], as_reached});
      if (step_[p][d] == 0) continue;
      formula_.add({-is_inside_[p], -step_[p][d], -is_bend_[p], -as_reached});
      formula_.add({-is_inside_[p], -step_[p][d], is_bend_[p], as_reached});
    }
  }
}

// All vertices are in one layer across the z axis.
void Encoding::add_plane() {
  const Row layer = table(1, static_cast<std::size_t>(points_.box[2]))[0];
  at_most_one(layer);
  for (std::size_t p = 0; p < points_.points.size(); ++p) {
    formula_.add({-is_vertex_[p], layer[static_cast<std::size_t>(points_.points[p][2])]});
  }
}

}  // namespace ar3d::optimum
