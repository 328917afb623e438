#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/algorithms/compact/cells.h"
#include "ar3d/algorithms/compact/words.h"
#include "ar3d/algorithms/strips/lines.h"
#include "ar3d/model/graph.h"

namespace ar3d::compact {

/// The cap rule of the size bound's proof: of every family of contested lines (green by q and the
/// tail's letter, red to the right, red to the left) at most T + 1 have one value of the form that
/// neither their tail nor their head fixes. No more than (edges of the colour) / T values are ever
/// closed.
class Caps {
 public:
  /// @param widest  bound on the absolute value of the forms.
  Caps(std::int32_t cap, std::int32_t widest)
      : cap_(cap), widest_(widest), counts_(kFamilies * width()) {}

  /// False if the value of this edge is closed. @param on_line  a point of its middle line.
  bool is_open(const Shape& shape, const Letters& on_line) const {
    return counts_[index(shape, on_line)] < cap_;
  }
  void add(const Shape& shape, const Letters& on_line) { ++counts_[index(shape, on_line)]; }

 private:
  static constexpr std::size_t kFamilies = 6;
  std::size_t width() const { return 2 * static_cast<std::size_t>(widest_) + 1; }
  std::size_t index(const Shape& shape, const Letters& on_line) const;

  std::int32_t cap_;
  std::int32_t widest_;
  std::vector<std::int32_t> counts_;
};

/// The edge of each role at a vertex; `to` is kNobody where there is none.
inline constexpr Vertex kNobody = 0xffffffffu;
enum ColourRole : std::size_t { kGreenOut = 0, kGreenIn = 1, kRedOut = 2, kRedIn = 3 };
inline bool is_red(ColourRole role) { return role >= kRedOut; }
inline bool is_out(ColourRole role) { return role == kGreenOut || role == kRedOut; }
inline ColourRole opposite(ColourRole role) { return static_cast<ColourRole>(role ^ 1u); }
using Roles = std::array<HalfEdge, 4>;

/// Every edge is directed and green or red, such that every vertex has at most one edge of each
/// role.
struct Decomposition {
  UnwrittenVector<Roles> at;  ///< by vertex
  std::size_t num_green = 0;
};

/// Balanced orientation and two-colouring of docs/theorem1.md. O(n + m).
Decomposition decompose(const Graph& graph);

/// A neighbour that is placed: what v is to the edge, the edge, and where its other end stands.
struct PlacedNeighbour {
  ColourRole role = kGreenOut;
  EdgeId edge = 0;
  Site other;
};
using Joined = boost::container::static_vector<PlacedNeighbour, 4>;

/// The vertices placed so far and the pieces of contested lines that their edges use. Invariants:
/// (a) a green edge leaves a tail of type 0 to the right and one of type 1 to the left; (b) all
/// lengths are at least 1; (c) one edge of each role at a vertex; (d) one vertex per cell and type;
/// (e) no two pieces overlap. By docs/compact.md these are enough for a right drawing.
class Strip {
 public:
  /// @param cap  T of the cap rule: an edge takes all of its contested line, and only variant 0 is
  /// used. 0: edges take pieces of lines, in any variant, without the cap rule.
  Strip(const Decomposition& links, std::size_t num_edges, StripSize size, std::int32_t cap);

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
  const StripSize& size() const { return size_; }
  const Roles& roles(Vertex v) const { return links_->at[v]; }
  /// Returns where all vertices stand, all of them placed.
  Placement placement() const;

 private:
  /// Holds what placing one vertex would add: its arrival line and four edges at most.
  struct Plan {
    std::array<Piece, 5> pieces;
    std::array<Shape, 5> shapes;
    std::array<Letters, 5> starts;
    std::array<EdgeId, 5> edges;
    std::size_t count = 0;
  };

  /// False if the cell is taken or some edge to those neighbours can have no word there.
  bool may_hold(Site site, const Joined& joined) const;
  bool has_arrival(Vertex v) const { return links_->at[v][kGreenIn].to != kNobody; }
  bool is_free(const Piece& piece, const Plan& plan) const;
  bool may_join(ColourRole role, Site own, Site other) const;
  bool make_plan(Vertex v, Site site, const Joined& joined, Plan& plan) const;
  bool plan_arrival(Vertex v, Site site, Plan& plan) const;
  bool plan_edge(ColourRole role, Site own, Site other, EdgeId edge, Plan& plan) const;
  Piece piece_of(const Shape& shape, Site tail, Site head) const;
  void commit(Vertex v, Site site, const Plan& plan);

  const Decomposition* links_;  ///< never null
  StripSize size_;
  UnwrittenVector<Site> sites_;
  std::vector<std::uint8_t> variant_;
  TakenPlaces taken_;
  strips::Lines lines_;
  std::optional<Caps> caps_;
};

}  // namespace ar3d::compact
