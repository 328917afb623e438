#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <utility>
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

/// The vertices placed so far and the contested lines that their edges take as a whole. Invariants:
/// (a) a green edge leaves a tail of type 0 to the right and one of type 1 to the left; (b) all
/// lengths are at least 1; (c) one edge of each role at a vertex; (d) one vertex per cell and type;
/// (e) no two edges take one line; and the cap rule. By docs/compact.md (a) to (e) are enough for a
/// right drawing. All edges are routed in variant 0.
class Strip {
 public:
  /// @param cap  T of the cap rule.
  Strip(const Decomposition& links, std::size_t num_edges, StripSize size, std::int32_t cap);

  /// True if v can be placed there. O(1) expected.
  bool fits(Vertex v, Site site) const;
  /// Places v if that keeps the invariants. O(1) expected.
  bool try_place(Vertex v, Site site);
  /// Returns where all vertices stand, all of them placed.
  Placement placement() const;

 private:
  /// Holds what placing one vertex would add: the lines of its edges and of an arrival, and for the
  /// cap rule a point on the line of each edge.
  struct Plan {
    boost::container::static_vector<Piece, 5> lines;
    boost::container::static_vector<std::pair<Shape, Letters>, 4> edges;
  };

  bool make_plan(Vertex v, Site site, Plan& plan) const;
  bool plan_edge(bool red, Site tail, Site head, Plan& plan) const;
  bool plan_line(std::uint64_t line, Plan& plan) const;

  const Decomposition* links_;  ///< never null
  std::size_t num_edges_;
  StripSize size_;
  UnwrittenVector<Site> sites_;
  TakenSites taken_;
  strips::Lines lines_;
  Caps caps_;
};

}  // namespace ar3d::compact
