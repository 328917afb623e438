#pragma once

// Random drawings in a strip, edge by edge, for `compact` and `compact-120` alike: what does not
// keep the rules is left out. A mutation breaks one rule.

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "algorithms/strips_support.h"
#include "verify/counted_pairs.h"

namespace ar3d::testing {

/// What a random drawing has so far, whatever the letters. `Site` is the algorithm's.
template <class Site>
class RandomStripDrawing {
 public:
  RandomStripDrawing(const StripAlgorithm& algorithm, std::uint64_t seed)
      : algorithm_(algorithm), random_(seed) {}
  virtual ~RandomStripDrawing() = default;

  bool overlaps() const { return overlaps_; }

  bool is_right() const {
    Draft draft = drawn_;
    for (const Site& site : sites_) draft.vertices.push_back(point_of(site));
    return is_valid(draft, algorithm_.row.guarantee);
  }

 protected:
  virtual Point point_of(const Site& site) const = 0;

  Vertex random_vertex() { return random_.below(static_cast<std::uint32_t>(sites_.size())); }
  bool may_join(Vertex u, Vertex v) const {
    return u != v && joined_.count(std::minmax(u, v)) == 0;
  }
  /// @param no_overlap  refuses pieces that overlap earlier ones, which else are noted.
  bool add_pieces(const std::vector<strips::Piece>& added, bool no_overlap) {
    bool overlap = false;
    for (const strips::Piece& piece : added) {
      for (const strips::Piece& other : pieces_) overlap = overlap || piece.overlaps(other);
    }
    if (overlap && no_overlap) return false;
    overlaps_ = overlaps_ || overlap;
    pieces_.insert(pieces_.end(), added.begin(), added.end());
    return true;
  }
  void add_edge(Vertex u, Vertex v, const std::vector<Point>& bends) {
    drawn_.edges.push_back({{u, v}, bends});
    joined_.insert(std::minmax(u, v));
  }

  const StripAlgorithm& algorithm_;
  RandomStream random_;
  std::vector<Site> sites_;

 private:
  std::set<std::pair<Vertex, Vertex>> joined_;
  Draft drawn_;  ///< its edges
  std::vector<strips::Piece> pieces_;
  bool overlaps_ = false;
};

/// How many of the drawings by these rules the verifier refuses.
template <class RandomDrawing, class Rules>
std::uint64_t wrong_drawings(const Rules& rules) {
  std::uint64_t wrong = 0;
  for (std::uint64_t seed = 0; seed < RandomDrawing::kDrawings; ++seed) {
    wrong += RandomDrawing(rules, seed).is_right() ? 0 : 1;
  }
  return wrong;
}

/// Drawings whose edges may overlap are right if and only if none do. Returns how many overlap.
template <class RandomDrawing, class Rules>
std::uint64_t overlapping_drawings(Rules rules) {
  rules.no_overlap = false;
  std::uint64_t wrong = 0;
  for (std::uint64_t seed = 0; seed < RandomDrawing::kDrawings; ++seed) {
    const RandomDrawing drawing(rules, seed);
    EXPECT_EQ(drawing.is_right(), !drawing.overlaps()) << "seed " << seed;
    wrong += drawing.overlaps() ? 1 : 0;
  }
  return wrong;
}

}  // namespace ar3d::testing
