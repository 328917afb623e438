// The rules of docs/compact-120.md are enough and all needed: random drawings that keep the rules
// are right if and only if no two middle segments overlap or touch; with a rule broken the verifier
// refuses some of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "algorithms/strips_mutation.h"

namespace ar3d::compact_120 {
namespace {

/// The rules as a drawing uses them; a mutation changes one.
struct Rules {
  std::int32_t shortest = 1;
  bool one_vertex_a_place = true;
  bool one_edge_an_arm = true;
  bool no_overlap = true;  ///< edges that would overlap are left out
};

class RandomDrawing : public testing::RandomStripDrawing<Site> {
 public:
  static constexpr std::uint64_t kDrawings = 4000;

  RandomDrawing(const Rules& rules, std::uint64_t seed)
      : RandomStripDrawing(testing::compact_120_strips(), seed), rules_(rules) {
    const std::uint32_t n = 2 + random_.below(13);
    for (std::uint32_t v = 0; v < n; ++v) add_vertex();
    arms_.resize(sites_.size());
    for (int attempt = 0; attempt < 150; ++attempt) add_random_edge();
  }

 private:
  Point point_of(const Site& site) const override { return to_point(quad_of(site)); }

  std::int32_t below(std::uint32_t bound) {
    return static_cast<std::int32_t>(random_.below(bound));
  }

  void add_vertex() {
    const Site site{below(7), below(3), static_cast<Class>(below(3))};
    const bool taken = std::find(sites_.begin(), sites_.end(), site) != sites_.end();
    if (!taken || !rules_.one_vertex_a_place) sites_.push_back(site);
  }

  bool takes(Vertex v, Arm arm) const { return !arms_[v][arm] || !rules_.one_edge_an_arm; }

  void add_random_edge() {
    const Vertex u = random_vertex();
    const Vertex v = random_vertex();
    if (!may_join(u, v)) return;
    const Quad from = quad_of(sites_[u]);
    const Quad to = quad_of(sites_[v]);
    const bool right = to[0] > from[0];
    if (to[0] == from[0] || sites_[u].of == (right ? Class::t : Class::s)) return;
    if (sites_[v].of == (right ? Class::s : Class::t)) return;
    const Arm own = right ? k01 : k20;
    const Arm side = (sites_[v].of == Class::n) == right ? k20 : k01;
    const Arm arm = random_.chance(1, 2) ? k12 : side;
    const Arrival at = arrival_on(arm, sites_[v].of);
    const Route route({right, at, random_.below(variants(at))}, from, to);
    const auto& lengths = route.lengths();
    if (*std::min_element(lengths.begin(), lengths.end()) < rules_.shortest) return;
    if (!takes(u, own) || !takes(v, arm)) return;
    if (!add_pieces({route.middle()}, rules_.no_overlap)) return;
    std::vector<Point> bends;
    route.append_bends(bends);
    add_edge(u, v, bends);
    arms_[u][own] = arms_[v][arm] = true;
  }

  Rules rules_;
  std::vector<std::array<bool, 3>> arms_;
};

std::uint64_t wrong_drawings(const Rules& rules) {
  return testing::wrong_drawings<RandomDrawing>(rules);
}

TEST(Compact120Rules, MakeEveryDrawingRight) { EXPECT_EQ(wrong_drawings({}), 0u); }

TEST(Compact120Rules, OverlapsAreTheOnlyFaultsLeft) {
  EXPECT_GT(testing::overlapping_drawings<RandomDrawing>(Rules()), 5u);
}

TEST(Compact120Mutation, EveryRuleIsNeeded) {
  EXPECT_GT(wrong_drawings({.one_vertex_a_place = false}), 0u);
  EXPECT_GT(wrong_drawings({.one_edge_an_arm = false}), 0u);
  EXPECT_GT(wrong_drawings({.shortest = 0}), 0u);
  EXPECT_GT(wrong_drawings({.shortest = -1}), 0u);
}

// Rule (a) follows from the lengths.
TEST(Compact120Mutation, AnEdgeToTheWrongSideHasALengthBelowOne) {
  int seen = 0;
  for (std::int32_t cell = 0; cell < 40; ++cell) {
    for (const Class of : {Class::n, Class::s, Class::t}) {
      const Site tail{5, 2, Class::n};
      const Site head{cell / 4, cell % 4, of};
      const std::int32_t across = quad_of(head)[0] - quad_of(tail)[0];
      for (const bool right : {true, false}) {
        if ((right ? across : -across) > 0) continue;
        for (const Arm arm : {k12, (of == Class::n) == right ? k20 : k01}) {
          if (of == (right ? Class::s : Class::t)) continue;
          const Arrival at = arrival_on(arm, of);
          for (unsigned i = 0; i < variants(at); ++i) {
            EXPECT_FALSE(Route({right, at, i}, quad_of(tail), quad_of(head)).fits());
            ++seen;
          }
        }
      }
    }
  }
  EXPECT_GT(seen, 100);
}

/// An edge alone, with the piece of its middle line.
struct LoneEdge {
  Site tail;
  Site head;
  Shape shape;
  Piece piece;
};

/// All edges to the right on 12 and 01 between places of a few cells.
std::vector<LoneEdge> some_edges() {
  std::vector<Site> sites;
  for (std::int32_t cell = 0; cell < 28; ++cell) {
    for (const Class of : {Class::n, Class::s, Class::t}) sites.push_back({cell / 4, cell % 4, of});
  }
  std::vector<LoneEdge> edges;
  for (const Site& tail : sites) {
    for (const Site& head : sites) {
      if (tail.of == Class::t || head.of == Class::s) continue;
      if (quad_of(head)[0] <= quad_of(tail)[0]) continue;
      for (const Arm arm : {k12, k01}) {
        if (arm == k01 && head.of == Class::n) continue;
        const Shape shape{true, arrival_on(arm, head.of),
                          arm == k12 && head.of == Class::n ? 1u : 0u};
        const Route route(shape, quad_of(tail), quad_of(head));
        if (route.fits()) edges.push_back({tail, head, shape, route.middle()});
      }
    }
  }
  return edges;
}

bool is_right(const LoneEdge& one, const LoneEdge& two) {
  testing::Draft draft;
  for (const LoneEdge* edge : {&one, &two}) {
    const auto v = static_cast<Vertex>(draft.vertices.size());
    draft.edges.push_back({{v, v + 1}, {}});
    const Quad tail = quad_of(edge->tail), head = quad_of(edge->head);
    draft.vertices.insert(draft.vertices.end(), {to_point(tail), to_point(head)});
    Route(edge->shape, tail, head).append_bends(draft.edges.back().bends);
  }
  return testing::is_valid(draft, row().guarantee);
}

/// Expects that two edges for which that holds are never right; that there are such.
template <class Clash>
void expect_wrong(Clash clash) {
  const std::vector<LoneEdge> edges = some_edges();
  int clashes = 0;
  for (const LoneEdge& one : edges) {
    for (const LoneEdge& two : edges) {
      if (!clash(one, two)) continue;
      ++clashes;
      ASSERT_FALSE(is_right(one, two));
    }
  }
  EXPECT_GT(clashes, 0);
}

TEST(Compact120Mutation, PiecesThatTouchCount) {
  expect_wrong([](const LoneEdge& one, const LoneEdge& two) {
    if (one.piece.line != two.piece.line || one.piece.high != two.piece.low) return false;
    const std::set<Point> ends = {to_point(quad_of(one.tail)), to_point(quad_of(one.head)),
                                  to_point(quad_of(two.tail)), to_point(quad_of(two.head))};
    return ends.size() == 4;
  });
}

TEST(Compact120Mutation, WordsToNAndToSinksCompete) {
  expect_wrong([](const LoneEdge& one, const LoneEdge& two) {
    return one.shape.at == Arrival::on_12 && two.shape.at == Arrival::on_01 &&
           one.tail != two.tail && one.piece.overlaps(two.piece);
  });
}

}  // namespace
}  // namespace ar3d::compact_120
