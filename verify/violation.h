#pragma once

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/graph.h"

namespace ar3d {

enum class ViolationKind {
  vertex_count,        ///< the drawing has another number of vertices than the graph
  edge_set,            ///< an edge is missing, extra, or drawn twice
  lattice,             ///< the drawing's Gram matrix is not the guarantee's
  coordinate_range,    ///< a coordinate passes kMaxCoordinate; such a drawing is judged no further
  plane,               ///< a vertex is not in the plane z = 0 although promised
  degenerate_segment,  ///< two consecutive points of an edge coincide
  direction,           ///< a segment is not parallel to an allowed direction
  bends,               ///< an edge has too many bends
  bend_angle,          ///< consecutive segments of an edge meet at a wrong angle
  vertex_angle,        ///< two segments leave a vertex at a wrong angle
  same_point,          ///< two vertices coincide
  vertex_on_edge,      ///< a vertex lies on an edge that does not end there
  crossing,            ///< two segments share a point that is not a common end of theirs
  size,                ///< an extent passes the bound
};
/// "crossing", "vertex_on_edge", …
inline const char* to_string(ViolationKind kind) {
  static constexpr std::array<const char*, 14> kNames = {
      "vertex_count",     "edge_set",   "lattice",
      "coordinate_range", "plane",      "degenerate_segment",
      "direction",        "bends",      "bend_angle",
      "vertex_angle",     "same_point", "vertex_on_edge",
      "crossing",         "size"};
  return kNames.at(static_cast<std::size_t>(kind));
}

/// One violation, with everything needed to look at it.
struct Violation {
  ViolationKind kind{};
  std::vector<Vertex> vertices;
  std::vector<EdgeId> edges;  ///< numbers of the drawing's edges
  std::vector<Point> points;  ///< exact places
  std::string message;        ///< one line
};

}  // namespace ar3d

namespace ar3d::verify {

/// Collects violations up to a limit. Checks stop early once done().
class Findings {
 public:
  explicit Findings(std::size_t limit) : limit_(limit) {}

  /// Keeps a violation with its message, or remembers that the list was cut.
  template <class... Arguments>
  void add(ViolationKind kind, std::vector<Vertex> vertices, std::vector<EdgeId> edges,
           std::vector<Point> points, fmt::format_string<Arguments...> message,
           Arguments&&... arguments) {
    add({kind, std::move(vertices), std::move(edges), std::move(points),
         fmt::format(message, std::forward<Arguments>(arguments)...)});
  }
  void add(Violation violation) {
    if (list_.size() < limit_) {
      list_.push_back(std::move(violation));
    } else {
      cut_ = true;
    }
  }
  /// True once something was found that no longer fits: nothing further can change the verdict.
  bool done() const { return cut_; }
  /// Returns how many more violations fit.
  std::size_t room() const { return limit_ - list_.size(); }
  bool empty() const { return list_.empty() && !cut_; }

  std::vector<Violation> take() { return std::move(list_); }

 private:
  std::size_t limit_;
  bool cut_ = false;
  std::vector<Violation> list_;
};

}  // namespace ar3d::verify
