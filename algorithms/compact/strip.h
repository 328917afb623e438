#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/compact/caps.h"
#include "ar3d/algorithms/compact/decomposition.h"
#include "ar3d/algorithms/compact/placement.h"
#include "ar3d/algorithms/compact/words.h"
#include "ar3d/algorithms/strips/lines.h"

namespace ar3d::compact {

/// Neighbours that are placed: what v is to the edge, the edge, and where its other end stands.
struct Joined {
  struct Edge {
    Role role = kGreenOut;
    EdgeId edge = 0;
    Site other;
  };
  std::array<Edge, 4> edges;
  std::uint32_t count = 0;
  const Edge* begin() const { return edges.data(); }
  const Edge* end() const { return edges.data() + count; }
};

/// How vertices share the lines.
struct StripRules {
  bool whole_lines =
      false;             ///< an edge takes all of its contested line, and only variant 0 is used
  std::int32_t cap = 0;  ///< T of the cap rule; 0: no cap
};

/// The vertices placed so far and the pieces of contested lines that their edges use. Invariants:
/// (a) a green edge leaves a tail of type 0 to the right and one of type 1 to the left; (b) all
/// lengths are at least 1; (c) one edge of each role at a vertex; (d) one vertex per cell and type;
/// (e) no two pieces overlap. By docs/compact.md these are enough for a right drawing.
class Strip {
 public:
  Strip(const Decomposition& links, std::size_t num_edges, StripSize size, StripRules rules);

  /// The placed neighbours of v. O(1).
  Joined joined(Vertex v) const;
  /// True if v can be placed there. O(1) expected.
  bool fits(Vertex v, Site site) const;
  /// Places v if that keeps the invariants; routes its edges to placed neighbours in the first
  /// variants that fit. O(1) expected.
  bool try_place(Vertex v, Site site);

  /// Takes a placed vertex and its edges away.
  void remove(Vertex v);

  bool is_placed(Vertex v) const { return sites_[v].is_set(); }
  const Site& site(Vertex v) const { return sites_[v]; }
  Vertex num_vertices() const { return static_cast<Vertex>(sites_.size()); }
  const StripSize& size() const { return size_; }
  const Roles& roles(Vertex v) const { return links_->at[v]; }
  /// Where all vertices stand, all of them placed.
  Placement placement() const;

 private:
  /// What placing one vertex would add: its arrival line and four edges at most.
  struct Plan {
    std::array<Piece, 5> pieces;
    std::array<Shape, 5> shapes;
    std::array<Letters, 5> starts;
    std::array<EdgeId, 5> edges;
    std::size_t count = 0;
  };

  std::size_t cell_bit(Site site) const {
    return 2 * (static_cast<std::size_t>(site.column) * half_rows_ +
                static_cast<std::size_t>(site.row / 2)) +
           static_cast<std::size_t>(site.type);
  }
  bool is_taken(Site site) const {
    const std::size_t bit = cell_bit(site);
    return (taken_[bit / 64] >> bit % 64 & 1) != 0;
  }
  /// False if the cell is taken or some edge to those neighbours can have no word there.
  bool may_hold(Site site, const Joined& joined) const;
  bool has_arrival(Vertex v) const { return links_->at[v][kGreenIn].to != kNobody; }
  bool is_free(const Piece& piece, const Plan& plan) const;
  bool may_join(Role role, Site own, Site other) const;
  bool make_plan(Vertex v, Site site, const Joined& joined, Plan& plan) const;
  bool plan_arrival(Vertex v, Site site, Plan& plan) const;
  bool plan_edge(Role role, Site own, Site other, EdgeId edge, Plan& plan) const;
  Piece piece_of(const Shape& shape, Site tail, Site head) const;
  void commit(Vertex v, Site site, const Plan& plan);

  const Decomposition* links_;  ///< never null
  StripSize size_;
  std::size_t half_rows_;  ///< cells of a column: every other row has one
  StripRules rules_;
  UnwrittenVector<Site> sites_;
  std::vector<std::uint8_t> variant_;
  std::vector<std::uint64_t> taken_;  ///< two bits per cell, one for each type
  strips::Lines lines_;
  std::optional<Caps> caps_;
};

}  // namespace ar3d::compact
