// The rules of docs/compact.md are enough and all needed: random drawings that keep the rules are
// right if and only if no two pieces of a contested line overlap; with a rule broken the verifier
// refuses some of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <set>

#include "algorithms/strips_support.h"

namespace ar3d::compact {
namespace {

/// The rules as a drawing uses them; a mutation changes one.
struct Rules {
  std::function<Letters(Site)> place = letters_of;
  std::function<void(const Shape&, Word&)> change = [](const Shape&, Word&) {};
  std::int32_t shortest = 1;
  bool one_vertex_a_cell_and_type = true;
  bool one_red_in = true;
  bool no_overlap = true;  ///< edges that would overlap are left out
  bool arrivals_count = true;
};

/// One random drawing, edge by edge; what does not keep the rules is left out.
class RandomDrawing {
 public:
  RandomDrawing(const Rules& rules, std::uint64_t seed) : rules_(rules), random_(seed) {
    const std::uint32_t n = 2 + random_.below(11);
    for (std::uint32_t v = 0; v < n; ++v) add_vertex();
    roles_.resize(sites_.size());
    for (int attempt = 0; attempt < 120; ++attempt) add_edge();
  }

  bool overlaps() const { return overlaps_; }

  bool is_right() const {
    const Graph graph(sites_.size(), edges_);
    Coordinates at(sites_.size(), 1000);
    for (std::size_t v = 0; v < sites_.size(); ++v) at.set(v, to_point(rules_.place(sites_[v])));
    const Drawing drawing("compact", kCubeLattice, std::move(at),
                          std::make_shared<const std::vector<Edge>>(edges_),
                          std::make_shared<StoredBends>(bends_));
    return certify(graph, drawing, compact::row().guarantee,
                   {.crossing_test = CrossingTest::all_pairs, .check_size = false})
        .valid();
  }

 private:
  void add_vertex() {
    const auto column = static_cast<std::int32_t>(random_.below(14));
    const auto row = static_cast<std::int32_t>(2 * random_.below(2)) + column % 2;
    const Site site{column, row, static_cast<std::int32_t>(random_.below(2))};
    for (const Site& other : sites_) {
      const bool on_one_point = to_point(rules_.place(other)) == to_point(rules_.place(site));
      if (on_one_point && rules_.one_vertex_a_cell_and_type) return;
    }
    sites_.push_back(site);
  }

  bool takes(Vertex v, Role role) {
    if (role == kRedIn && !rules_.one_red_in) return true;
    return !roles_[v][role];
  }

  void add_edge() {
    const auto n = static_cast<std::uint32_t>(sites_.size());
    const Vertex u = random_.below(n);
    const Vertex v = random_.below(n);
    const bool red = random_.chance(1, 2);
    const Role out = red ? kRedOut : kGreenOut;
    const Site tail = sites_[u];
    const Site head = sites_[v];
    if (u == v || tail.column == head.column || joined_.count(std::minmax(u, v)) > 0) return;
    if (!takes(u, out) || !takes(v, opposite(out))) return;
    const Shape shape{red, tail.type, head.type, head.column > tail.column,
                      random_.below(variants(red))};
    if (!red && shape.right != (tail.type == 0)) return;
    Word word = word_of(shape);
    rules_.change(shape, word);
    const Letters from = rules_.place(tail);
    const auto lengths = long_lengths(word, from, rules_.place(head));
    if (*std::min_element(lengths.begin(), lengths.end()) < rules_.shortest) return;
    if (!add_pieces(word, red, from, lengths)) return;
    std::vector<Point> bends;
    append_bends_of(word, from, lengths, bends);
    bends_.add_edge(bends);
    edges_.push_back({u, v});
    joined_.insert(std::minmax(u, v));
    roles_[u][out] = roles_[v][opposite(out)] = true;
  }

  /// The middle line and, of a green edge, the arrival line.
  bool add_pieces(const Word& word, bool red, const Letters& from,
                  const std::array<std::int32_t, 3>& lengths) {
    Letters at = middle_start(word, from, lengths);
    std::vector<Piece> added = {middle_piece(word, red, at, lengths[1])};
    if (!red && rules_.arrivals_count) {
      at[word.long_letter[1]] += lengths[1];
      at[word.short_letter[1]] -= word.short_length[1];
      const LineKind kind = word.long_letter[2] == kB ? LineKind::upper_b : LineKind::upper_c;
      added.push_back({line_key(kind, at), height(at) - lengths[2], height(at)});
    }
    bool overlap = false;
    for (const Piece& piece : added) {
      for (const Piece& other : pieces_) overlap = overlap || piece.overlaps(other);
    }
    if (overlap && rules_.no_overlap) return false;
    overlaps_ = overlaps_ || overlap;
    pieces_.insert(pieces_.end(), added.begin(), added.end());
    return true;
  }

  Rules rules_;
  RandomStream random_;
  std::vector<Site> sites_;
  std::vector<std::array<bool, 4>> roles_;
  std::set<std::pair<Vertex, Vertex>> joined_;
  std::vector<Edge> edges_;
  StoredBends bends_;
  std::vector<Piece> pieces_;
  bool overlaps_ = false;
};

constexpr std::uint64_t kDrawings = 3000;

std::uint64_t wrong_drawings(const Rules& rules) {
  std::uint64_t wrong = 0;
  for (std::uint64_t seed = 0; seed < kDrawings; ++seed) {
    wrong += RandomDrawing(rules, seed).is_right() ? 0 : 1;
  }
  return wrong;
}

TEST(CompactRules, MakeEveryDrawingRight) { EXPECT_EQ(wrong_drawings({}), 0u); }

TEST(CompactRules, OverlapsAreTheOnlyFaultsLeft) {
  Rules rules;
  rules.no_overlap = false;
  std::uint64_t wrong = 0;
  for (std::uint64_t seed = 0; seed < kDrawings; ++seed) {
    const RandomDrawing drawing(rules, seed);
    ASSERT_EQ(drawing.is_right(), !drawing.overlaps()) << "seed " << seed;
    wrong += drawing.overlaps() ? 1 : 0;
  }
  EXPECT_GT(wrong, 10u);
}

TEST(CompactMutation, TheShiftOfHByTheTypeIsNeeded) {
  Rules rules;
  rules.place = [](Site s) { return letters_of({s.column, s.row, 0}); };
  EXPECT_GT(wrong_drawings(rules), 0u);
}

TEST(CompactMutation, PlacesThatAreFourApartAreNeeded) {
  Rules rules;
  rules.place = [](Site s) {
    const std::int32_t g = s.column + s.row;
    const std::int32_t h = s.column - s.row + 2 * s.type;
    return Letters{g + h, g, h, 0};
  };
  EXPECT_GT(wrong_drawings(rules), 0u);
}

TEST(CompactMutation, TheFirstShortOfRedEdgesToTheRightIsNeeded) {
  for (const unsigned variant : {0u, 1u}) {
    Rules rules;
    rules.change = [variant](const Shape& shape, Word& word) {
      if (!shape.red || !shape.right || shape.variant != variant) return;
      word.short_letter[0] = word.short_letter[0] == kA ? kD : kA;
    };
    EXPECT_GT(wrong_drawings(rules), 0u) << "variant " << variant;
  }
}

TEST(CompactMutation, ThePairsOfShortsOfRedEdgesToTheLeftAreNeeded) {
  Rules rules;
  rules.change = [](const Shape& shape, Word& word) {
    if (shape.red && !shape.right) word.short_letter[1] = word.short_letter[1] == kA ? kB : kA;
  };
  EXPECT_GT(wrong_drawings(rules), 0u);
}

TEST(CompactMutation, TheLengthsOfTheRedShortsAreNeeded) {
  const auto with_lengths = [](bool right, std::array<std::int32_t, 3> lengths) {
    Rules rules;
    rules.change = [=](const Shape& shape, Word& word) {
      if (shape.red && shape.right == right) word.short_length = lengths;
    };
    return wrong_drawings(rules);
  };
  EXPECT_GT(with_lengths(true, {1, 1, 1}), 0u);
  EXPECT_GT(with_lengths(false, {1, 1, 1}), 0u);
  EXPECT_GT(with_lengths(true, {2, 2, 2}), 0u);
  EXPECT_GT(with_lengths(false, {2, 2, 2}), 0u);
}

TEST(CompactMutation, ArrivalLinesAreNeeded) {
  Rules rules;
  rules.arrivals_count = false;
  EXPECT_GT(wrong_drawings(rules), 0u);
}

TEST(CompactMutation, OneVertexACellAndTypeIsNeeded) {
  Rules rules;
  rules.one_vertex_a_cell_and_type = false;
  EXPECT_GT(wrong_drawings(rules), 0u);
}

TEST(CompactMutation, OneRedInEdgeIsNeeded) {
  Rules rules;
  rules.one_red_in = false;
  EXPECT_GT(wrong_drawings(rules), 0u);
}

TEST(CompactMutation, LengthsOfAtLeastOneAreNeeded) {
  Rules rules;
  rules.shortest = 0;
  EXPECT_GT(wrong_drawings(rules), 0u);
}

}  // namespace
}  // namespace ar3d::compact
