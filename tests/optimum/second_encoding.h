#pragma once

// A second formula for "this box holds a drawing", written apart from optimum/: a variable for each
// edge, segment number, point and step; no counter, no symmetry broken, all classes in turn.
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "ar3d/optimum/question.h"
#include "ar3d/optimum/solver.h"

namespace ar3d::testing {

using Triple = std::array<int, 3>;

class SecondEncoding {
 public:
  SecondEncoding(const Graph& graph, const optimum::Question& question, const Triple& box,
                 const Triple& shift)
      : graph_(graph), bends_(static_cast<int>(question.max_bends)) {
    const bool is_body = question.diagonals == optimum::Diagonals::body;
    const int squared = is_body ? 3 : 2;
    for (int code = 0; code < 27; ++code) {
      const Triple d = {code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1};
      if (dot(d, d) == squared) steps_.push_back(d);
    }
    for (int x = 0; x < box[0]; ++x) {
      for (int y = 0; y < box[1]; ++y) {
        for (int z = 0; z < box[2]; ++z) {
          const Triple r = {(x + shift[0]) % 2, (y + shift[1]) % 2, (z + shift[2]) % 2};
          const bool is_in = is_body ? r[0] == r[1] && r[1] == r[2] : (r[0] + r[1] + r[2]) % 2 == 0;
          if (is_in) points_.insert({x, y, z});
        }
      }
    }
    for (Vertex u = 0; u < graph.num_vertices(); ++u) add_vertex(u);
    for (EdgeId e = 0; e < graph.num_edges(); ++e) {
      for (const Triple& p : points_) add_edge_at(e, p);
    }
    add_owners();
    add_stars();
    if (question.in_plane) add_plane(box[2]);
  }

  const optimum::Formula& formula() const { return formula_; }

 private:
  enum Kind { at, inside, segment, leaves, layer };
  using Key = std::tuple<Kind, int, int, Triple, Triple>;

  static int dot(const Triple& a, const Triple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Triple plus(const Triple& p, const Triple& d, int times = 1) {
    return {p[0] + times * d[0], p[1] + times * d[1], p[2] + times * d[2]};
  }
  int variable(Kind kind, std::uint64_t i, int k, const Triple& p, const Triple& d) {
    int& number = numbers_[{kind, static_cast<int>(i), k, p, d}];
    if (number == 0) number = formula_.new_variable();
    return number;
  }
  int vertex(Vertex u, const Triple& p) { return variable(at, u, 0, p, {}); }
  int used(EdgeId e, const Triple& p) { return variable(inside, e, 0, p, {}); }
  int piece(EdgeId e, int k, const Triple& p, const Triple& d) {
    return variable(segment, e, k, p, d);
  }
  int leaving(EdgeId e, int end, const Triple& d) { return variable(leaves, e, end, {}, d); }
  bool has(const Triple& p) const { return points_.contains(p); }
  void never_two(const std::vector<int>& some) {
    for (std::size_t i = 0; i < some.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) formula_.add({-some[i], -some[j]});
    }
  }

  void add_vertex(Vertex u) {
    std::vector<int> places;
    for (const Triple& p : points_) places.push_back(vertex(u, p));
    formula_.add(places);
    never_two(places);
  }

  // The edge runs from u to w; piece k is between its bends k and k + 1.
  void add_edge_at(EdgeId e, const Triple& p) {
    const auto [u, w] = graph_.edge(e);
    std::vector<int> out, start = {-vertex(u, p)}, arrive = {-vertex(w, p)};
    for (const Triple& d : steps_) {
      for (int k = 0; k <= bends_; ++k) {
        if (has(plus(p, d))) out.push_back(piece(e, k, p, d));
        if (has(plus(p, d, -1))) arrive.push_back(piece(e, k, plus(p, d, -1), d));
      }
      if (!has(plus(p, d))) continue;
      start.push_back(piece(e, 0, p, d));
      for (int k = 0; k <= bends_; ++k) add_piece(e, k, p, d);
    }
    never_two(out);
    formula_.add(start);
    formula_.add(arrive);
  }

  void add_piece(EdgeId e, int k, const Triple& p, const Triple& d) {
    const auto [u, w] = graph_.edge(e);
    const int own = piece(e, k, p, d);
    const Triple q = plus(p, d);
    std::vector<int> before = {-own}, after = {-own, vertex(w, q)};
    if (has(plus(p, d, -1))) before.push_back(piece(e, k, plus(p, d, -1), d));
    if (k == 0) before.push_back(vertex(u, p));
    if (has(plus(q, d))) after.push_back(piece(e, k, q, d));
    for (const Triple& f : steps_) {
      if (dot(f, d) != 1) continue;
      if (k > 0 && has(plus(p, f, -1))) before.push_back(piece(e, k - 1, plus(p, f, -1), f));
      if (k < bends_ && has(plus(q, f))) after.push_back(piece(e, k + 1, q, f));
    }
    formula_.add(before);
    formula_.add(after);
    formula_.add({-own, vertex(u, p), used(e, p)});
    formula_.add({-own, vertex(w, q), used(e, q)});
    formula_.add({-own, -vertex(u, p), leaving(e, 0, d)});
    formula_.add({-own, -vertex(w, q), leaving(e, 1, plus({}, d, -1))});
  }

  void add_owners() {
    for (const Triple& p : points_) {
      std::vector<int> owners;
      for (Vertex u = 0; u < graph_.num_vertices(); ++u) owners.push_back(vertex(u, p));
      for (EdgeId e = 0; e < graph_.num_edges(); ++e) owners.push_back(used(e, p));
      never_two(owners);
    }
  }

  void add_stars() {
    for (EdgeId e = 0; e < graph_.num_edges(); ++e) {
      for (EdgeId f = 0; f < e; ++f) {
        for (const int i : {0, 1}) {
          for (const int j : {0, 1}) {
            const Vertex a = i == 0 ? graph_.edge(e).u : graph_.edge(e).v;
            const Vertex b = j == 0 ? graph_.edge(f).u : graph_.edge(f).v;
            if (a == b) add_angle(e, i, f, j);
          }
        }
      }
    }
  }

  void add_angle(EdgeId e, int i, EdgeId f, int j) {
    for (const Triple& c : steps_) {
      for (const Triple& d : steps_) {
        if (dot(c, d) != -1) formula_.add({-leaving(e, i, c), -leaving(f, j, d)});
      }
    }
  }

  void add_plane(int layers) {
    std::vector<int> some;
    for (int z = 0; z < layers; ++z) some.push_back(variable(layer, 0, z, {}, {}));
    never_two(some);
    for (const Triple& p : points_) {
      for (Vertex u = 0; u < graph_.num_vertices(); ++u) {
        formula_.add({-vertex(u, p), some[static_cast<std::size_t>(p[2])]});
      }
    }
  }

  const Graph& graph_;
  int bends_;
  std::vector<Triple> steps_;
  std::set<Triple> points_;
  optimum::Formula formula_;
  std::map<Key, int> numbers_;
};

/// Does the box hold a drawing? With a plane it is across z.
inline bool holds_drawing(const Graph& graph, const optimum::Question& question, const Triple& box,
                          const optimum::Solver& solver) {
  std::vector<Triple> shifts = {{0, 0, 0}, {1, 0, 0}};
  if (question.diagonals == optimum::Diagonals::body)
    shifts = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return std::ranges::any_of(shifts, [&](const Triple& shift) {
    const SecondEncoding second(graph, question, box, shift);
    return solver({.formula = second.formula()}).answer == optimum::Answer::satisfiable;
  });
}

}  // namespace ar3d::testing
