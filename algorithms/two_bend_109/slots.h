#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ar3d/algorithms/two_bend_109/partition.h"
#include "ar3d/algorithms/two_bend_109/stubs.h"
#include "ar3d/model/graph.h"

namespace ar3d::two_bend_109 {

/// Says how many vertices ahead entries of neighbours are asked for.
inline constexpr Vertex kAhead = 8;

/// A graph whose vertices are numbered upwards, part by part: what is drawn at about the same time
/// then stands together in memory. The half-edges of a vertex are in the order of the graph's.
struct OrderedGraph {
  /// Component after component; in each, the parts have the order that they came in. O(n).
  OrderedGraph(const Graph& graph, std::vector<VertexPart> all_parts, const Components& components);

  Vertex num_vertices() const { return static_cast<Vertex>(names.size()); }
  std::uint32_t degree(Vertex v) const { return offsets[v + 1] - offsets[v]; }
  /// Asks for these entries of the neighbours of a vertex that will soon be gone through, if any.
  template <class T>
  void prefetch_neighbours(Vertex v, const T* entries) const {
    if (v >= num_vertices()) return;
    for (const HalfEdge& half : incident(v)) __builtin_prefetch(&entries[half.to]);
  }
  /// `edge` is 2 e for the smaller end of edge e by the names, 2 e + 1 for the other: the bend's.
  std::span<const HalfEdge> incident(Vertex v) const {
    return {half_edges.data() + offsets[v], half_edges.data() + offsets[v + 1]};
  }

  std::vector<VertexPart> parts;
  std::vector<Vertex> names;    ///< of each vertex: its number in the graph
  std::vector<Vertex> numbers;  ///< that among the vertices of its component
  std::vector<std::uint32_t> offsets;
  std::vector<HalfEdge> half_edges;
};

/// A list in which any two members can be compared.
class SlotList {
 public:
  std::uint32_t size() const { return static_cast<std::uint32_t>(label_.size()); }
  /// A new member right after slot `at`, or first if `at` is kNone. O(1) amortised over few
  /// insertions at one place; O(n) after about 40 of them.
  std::uint32_t insert_after(std::uint32_t at);
  std::uint32_t last() const { return last_; }
  std::uint32_t before(std::uint32_t at) const { return before_[at]; }
  bool is_before(std::uint32_t a, std::uint32_t b) const { return label_[a] < label_[b]; }
  std::vector<std::uint32_t> in_order() const;

  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

 private:
  void spread_labels();
  std::vector<std::uint32_t> after_;
  std::vector<std::uint32_t> before_;
  std::vector<std::int64_t> label_;
  std::uint32_t first_ = kNone;
  std::uint32_t last_ = kNone;
};

enum class SlotKind : std::uint8_t { single, cycle, triangle };

/// Says where in its slot a vertex stands.
enum class SlotSpot : std::uint8_t {
  middle,        ///< y = 0
  upper,         ///< on a cycle of four or more: at larger y
  lower,         ///< at smaller y
  right_corner,  ///< of a triangle
  upper_corner,
  lower_corner,
  centre,       ///< inside a triangle, joined to its three corners
  left_inside,  ///< inside a triangle, joined to its left corners and to who is at the centre
};

/// The order of all vertices but those of bodies along the x-axis, and how each stands (Step E.2).
struct SlotArrangement {
  std::vector<std::uint32_t> slot;  ///< of each vertex, its index in the order
  std::vector<SlotSpot> spot;       ///< of each vertex
  std::vector<SlotKind> kind;       ///< of each slot, by index in the order
  std::vector<std::uint32_t> part;  ///< of each vertex: index into the parts
  std::vector<std::uint8_t> stubs;  ///< of each vertex: their number
  std::vector<std::uint8_t> port;   ///< of each bend: which stub of its vertex it ends
};

/// The slots are by component, too. Cost: O(n) plus the list's.
SlotArrangement arrange(const OrderedGraph& graph);

}  // namespace ar3d::two_bend_109
