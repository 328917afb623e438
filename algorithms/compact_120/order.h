#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "ar3d/algorithms/compact_120/letters.h"
#include "ar3d/algorithms/strips/numbers_ahead.h"
#include "ar3d/base/long_vector.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact_120 {

/// Holds which end of an edge is to the left: the one of smaller rank. Adjacent ranks differ.
struct Order {
  LongVector<std::uint16_t> rank;  ///< by vertex
  bool is_right(Vertex from, Vertex to) const { return rank[to] > rank[from]; }
};

/// A vertex and its edges, in half a cache line: read at random, it costs one wait for memory.
struct alignas(32) PaddedRow {
  std::array<HalfEdge, 3> half{};  ///< behind its degree: to itself
  Vertex v = 0;
  std::uint32_t degree = 0;
  std::span<const HalfEdge> edges() const { return {half.data(), degree}; }
};
UnwrittenVector<PaddedRow> rows_of(const Graph& graph);

/// Greedy colouring in order of vertex numbers in which vertices at distance 1 or 2 differ: colours
/// 0 .. 9 for maximum degree 3. O(n).
std::vector<std::uint8_t> distance_two_colours(const Graph& graph);

/// Steps D.1 to D.3: the order by colours, after the moves of sources and sinks. At most 76 ranks,
/// and by Lemma D.8 every component of the slot graph has at most one cycle. O(n).
Order moved_order(const Graph& graph);

/// The same order with ranks 0, 1, 2, ...: the length of the longest ascending path to a vertex.
/// O(n log n).
Order in_levels(const Graph& graph, const Order& order);

/// Every edge belongs to one of its ends, its tail; a vertex owns at most one edge to the right and
/// at most one to the left.
struct Owners {
  /// By vertex, its right side, then its left one: a bit for each of its edges that is there, in the
  /// order of the graph's row, and above them which of these it owns (0 to 2, or kNothing).
  LongVector<std::uint8_t> sides;
  /// The vertices of all components of the slot graph that have two cycles: there some vertices own
  /// two edges on one side, so the owners cannot be used. Empty after the moves (Lemma D.8).
  std::vector<Vertex> crowded;

  static constexpr unsigned kNothing = 3;
  unsigned right_edges(Vertex v) const { return sides[2 * std::size_t{v}] & 7u; }
  /// True if v owns the edge at index k of its row.
  bool owns(Vertex v, unsigned k) const {
    const std::size_t right = 2 * std::size_t{v};
    return sides[right] >> 3 == k || sides[right + 1] >> 3 == k;
  }
};

/// Step D.4. A node of the slot graph is a vertex and one of its sides; an edge joins the right
/// side of its left end with the left side of its right end. In a component with a cycle every node
/// owns an edge, in a tree every node but one leaf. So a source or sink of degree 3 owns an edge.
/// O(n).
Owners choose_owners(const Graph& graph, const Order& order);

/// choose_owners for an order that changes: components of the slot graph that stay are not searched
/// again where few change.
class ChangingOwners {
 public:
  /// O(n). @param rows  outlive this.
  ChangingOwners(const UnwrittenVector<PaddedRow>& rows, const Order& order);
  /// Goes over to another order. O(the components of the slot graph that change).
  /// @param vertices  all those with an edge whose ends have changed sides.
  void change(const Order& order, const std::vector<Vertex>& vertices);

  /// choose_owners(graph, order) of the last order.
  const Owners& owners() const { return owners_; }

 private:
  /// 2 v: the right side of v; 2 v + 1: its left side.
  using Node = std::uint32_t;
  /// A node that a search comes to, and by which edge; again, if that edge closes a cycle.
  struct Found {
    Node node = 0;
    EdgeId from = 0;
    bool again = false;
  };

  bool set_sides(const Order& order, Vertex v);
  unsigned owned(Node node) const { return owners_.sides[node] >> 3; }
  void set_owned(Node node, unsigned k);
  void prefetch(Vertex v) const;
  void search_all();
  void search_component(Node start);
  void make_root(Node node, unsigned given);
  std::vector<Node> forget_components(const std::vector<Vertex>& touched);
  void list_crowded();

  const UnwrittenVector<PaddedRow>& rows_;
  std::vector<Found> queue_;                     ///< of a search
  std::map<Node, std::vector<Vertex>> crowded_;  ///< the vertices of components, by first nodes
  Owners owners_;
};

inline constexpr Vertex kNobody = 0xffffffffu;

/// The edge at an arm of a vertex.
struct ArmLink {
  Vertex to = kNobody;
  std::uint32_t edge : 28 = 0;     ///< its number: below 3 kMaxVertices / 2
  std::uint32_t is_out : 1 = 0;    ///< the vertex is its tail
  std::uint32_t is_right : 1 = 0;  ///< the other end is to the right
  std::uint32_t at : 2 = 0;        ///< its Arrival
  bool is_set() const { return to != kNobody; }
  /// The edge runs to the right, from its tail to its head.
  bool runs_right() const { return is_out == is_right; }
  Arrival arrival() const { return static_cast<Arrival>(at); }
  /// It arrives at T on 01 or at S on 20. (At N edges to the right arrive on 20, to the left on
  /// 01.)
  bool is_steep() const { return arrival() == (runs_right() ? Arrival::on_01 : Arrival::on_20); }
  friend bool operator==(const ArmLink&, const ArmLink&) = default;
};

/// The class of every vertex and the edge at each of its arms. An own edge to the right leaves at
/// 01, one to the left at 20; edges arrive
///   at N from the left on 12 or 20, from the right on 12 or 01;
///   at S from the right on 12 or 20; at T from the left on 12 or 01.
struct Links {
  LongVector<std::array<ArmLink, 3>> at;  ///< by vertex and Arm
  LongVector<Class> of;                   ///< by vertex
};

/// Step D.5. @param owners  none of them crowded. O(n).
Links assign_arms(const Graph& graph, const Order& order, const Owners& owners);

/// Says where in a narrow strip a vertex belongs: 0 at the left end to 100 at the right end; larger
/// for the right end of an edge than for the left one.
using Position = std::uint8_t;

/// An order for narrow strips, what follows from it, and where vertices belong.
struct NarrowOrder {
  Links links;
  std::vector<Position> position;     ///< by vertex
  std::int64_t moved_components = 0;  ///< components of the graph that needed moved_order
};

/// Step D.6: a random proper colouring with four levels, then sweeps in which every vertex goes to
/// the level with which the fewest sources and sinks of degree 3 are near it, until no component of
/// the slot graph has two cycles. Components of the graph where a bounded number of sweeps does not
/// achieve that get the order of Steps D.1 to D.3. O(n), then O(n log n).
/// @param repairs  how often components with two cycles get a new start before they are given up.
NarrowOrder narrow_order(const Graph& graph, const strips::NumbersAhead& random, int repairs = 30);

}  // namespace ar3d::compact_120
