#pragma once

#include <array>
#include <utility>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"
#include "ar3d/optimum/formula.h"
#include "ar3d/optimum/question.h"

namespace ar3d::optimum {

/// Holds the points of a box that one connected drawing can visit (Lemma O.1). Steps are numbered
/// as steps_of() gives them.
struct PointClass {
  BoxSize box{};
  int number = 0;                            ///< of the class: 0 to 3, or 0 to 1
  std::vector<std::array<int, 3>> points;    ///< ascending
  std::vector<std::vector<int>> neighbours;  ///< [point][step], -1 outside of the box
  /// Images of all points under each symmetry of the box that keeps the class (and the z axis if
  /// vertices are in a plane), except the identity.
  std::vector<std::vector<int>> symmetries;
};

/// Returns the classes of a box, none the image of another under a symmetry of the box. The plane
/// of a question with one is across the z axis. O(points * 48).
std::vector<PointClass> point_classes(const Question& question, const BoxSize& box);

/// The formula that says "the graph has a drawing on the points of this class": it is satisfiable
/// if there is one (Lemmas O.4 and O.7), and decode() turns a model into one.
class Encoding {
 public:
  /// All three are kept by reference. @pre the class has a point for every vertex.
  /// @throws std::length_error as Formula::add.
  Encoding(const Graph& graph, const Question& question, const PointClass& points);

  const Formula& formula() const { return formula_; }
  /// Returns the drawing of a model. Vertices in a plane get z = 0.
  Drawing decode(const Model& model) const;

 private:
  using Row = std::vector<int>;
  using Table = std::vector<Row>;

  void make_variables();
  Table table(std::size_t rows, std::size_t columns);
  void add_positions();  // Step O.1
  void add_owners();     // Step O.2
  void add_steps();      // Step O.3
  void add_turns();      // Step O.4
  void add_turns_at(int p);
  void add_bends();  // Step O.5
  void add_bends_along(int p, int q, int step);
  void add_stars();  // Step O.6
  void add_star_of(EdgeId e, std::size_t end);
  void add_tetrahedra();        // Step O.7
  void add_plane();             // Step O.8
  void break_graph_symmetry();  // Step O.9
  void break_box_symmetry();    // Step O.10
  void at_most_one(std::span<const int> literals);

  int num_points() const { return static_cast<int>(points_.points.size()); }
  std::size_t num_steps() const { return steps_.size(); }
  int inner_product(std::size_t d, std::size_t f) const;
  bool may_follow(std::size_t d, std::size_t f) const { return d == f || inner_product(d, f) == 1; }
  bool is_in_first_tetrahedron(std::size_t d) const;
  Vertex end_of(EdgeId e, std::size_t end) const;
  std::vector<Point> bends_of(EdgeId e, const std::vector<int>& position, const Model& model) const;

  const Graph& graph_;
  const Question& question_;
  const PointClass& points_;
  std::vector<Vector> steps_;
  Row opposite_;  // of each step
  Formula formula_;
  // Variables, 0 where there is none.
  Table vertex_at_;     // [vertex][point]
  Table vertex_until_;  // [vertex][point]: at this point or an earlier one
  Table edge_at_;       // [edge][point]: inside the edge
  Table step_;          // [point][step]: some edge leaves the point so, towards its larger end
  Table into_;          // [point][step]: ... reaches the point so
  Table bends_before_;  // [point][k]: inside an edge, with at least k bends before
  Row is_bend_;         // [point]
  Row is_inside_;       // [point]: inside some edge
  Row is_vertex_;       // [point]
  std::vector<Table> leaves_;  // [edge][end][step]: the edge leaves its end so
};

/// Returns the pairs (i, j), i < j, such that an automorphism of the graph fixes 0, ..., i - 1 and
/// maps i to j. Exponential in the worst case; the graph is connected and small.
std::vector<std::pair<Vertex, Vertex>> orbit_pairs(const Graph& graph);

}  // namespace ar3d::optimum
