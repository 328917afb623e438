// The rules of docs/compact.md are enough and all needed: random drawings that keep the rules are
// right if and only if no two pieces of a contested line overlap; with a rule broken the verifier
// refuses some of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

#include "algorithms/strips_mutation.h"

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

class RandomDrawing : public testing::RandomStripDrawing<Site> {
 public:
  static constexpr std::uint64_t kDrawings = 3000;

  RandomDrawing(const Rules& rules, std::uint64_t seed)
      : RandomStripDrawing(testing::compact_strips(), seed), rules_(rules) {
    const std::uint32_t n = 2 + random_.below(11);
    for (std::uint32_t v = 0; v < n; ++v) add_vertex();
    roles_.resize(sites_.size());
    for (int attempt = 0; attempt < 120; ++attempt) add_random_edge();
  }

 private:
  Point point_of(const Site& site) const override { return to_point(rules_.place(site)); }

  void add_vertex() {
    const auto column = static_cast<std::int32_t>(random_.below(14));
    const auto row = static_cast<std::int32_t>(2 * random_.below(2)) + column % 2;
    const Site site{column, row, static_cast<std::int32_t>(random_.below(2))};
    for (const Site& other : sites_) {
      const bool on_one_point = point_of(other) == point_of(site);
      if (on_one_point && rules_.one_vertex_a_cell_and_type) return;
    }
    sites_.push_back(site);
  }

  bool takes(Vertex v, ColourRole role) {
    if (role == kRedIn && !rules_.one_red_in) return true;
    return !roles_[v][role];
  }

  void add_random_edge() {
    const Vertex u = random_vertex();
    const Vertex v = random_vertex();
    const bool red = random_.chance(1, 2);
    const ColourRole out = red ? kRedOut : kGreenOut;
    const Site tail = sites_[u];
    const Site head = sites_[v];
    if (tail.column == head.column || !may_join(u, v)) return;
    if (!takes(u, out) || !takes(v, opposite(out))) return;
    const Shape shape{red, tail.type, head.type, head.column > tail.column,
                      random_.below(variants(red))};
    if (!red && shape.right != (tail.type == 0)) return;
    Word word = word_of(shape);
    rules_.change(shape, word);
    const Letters from = rules_.place(tail);
    const auto lengths = long_lengths(word, from, rules_.place(head));
    if (*std::min_element(lengths.begin(), lengths.end()) < rules_.shortest) return;
    if (!add_pieces(pieces_of(word, red, from, lengths), rules_.no_overlap)) return;
    std::vector<Point> bends;
    append_bends_of(word, from, lengths, bends);
    add_edge(u, v, bends);
    roles_[u][out] = roles_[v][opposite(out)] = true;
  }

  /// The middle line and, of a green edge, the arrival line.
  std::vector<Piece> pieces_of(const Word& word, bool red, const Letters& from,
                               const std::array<std::int32_t, 3>& lengths) const {
    Letters at = middle_start(word, from, lengths);
    std::vector<Piece> pieces = {middle_piece(word, red, at, lengths[1])};
    if (!red && rules_.arrivals_count) {
      at[word.long_letter[1]] += lengths[1];
      at[word.short_letter[1]] -= word.short_length[1];
      const LineKind kind = word.long_letter[2] == kB ? LineKind::upper_b : LineKind::upper_c;
      pieces.push_back({line_key(kind, at), height(at) - lengths[2], height(at)});
    }
    return pieces;
  }

  Rules rules_;
  std::vector<std::array<bool, 4>> roles_;
};

std::uint64_t wrong_drawings(const Rules& rules) {
  return testing::wrong_drawings<RandomDrawing>(rules);
}

TEST(CompactRules, MakeEveryDrawingRight) { EXPECT_EQ(wrong_drawings({}), 0u); }

TEST(CompactRules, OverlapsAreTheOnlyFaultsLeft) {
  EXPECT_GT(testing::overlapping_drawings<RandomDrawing>(Rules()), 10u);
}

/// Breaks words of red edges to that side.
std::function<void(Rules&)> red(bool right,
                                const std::function<void(const Shape&, Word&)>& change) {
  return [=](Rules& rules) {
    rules.change = [=](const Shape& shape, Word& word) {
      if (shape.red && shape.right == right) change(shape, word);
    };
  };
}

std::function<void(Rules&)> red_lengths(bool right, std::array<std::int32_t, 3> lengths) {
  return red(right, [=](const Shape&, Word& word) { word.short_length = lengths; });
}

/// Another letter a or d in the first short of one variant.
std::function<void(Rules&)> red_first_short(unsigned variant) {
  return red(true, [=](const Shape& shape, Word& word) {
    Letter& letter = word.short_letter[0];
    if (shape.variant == variant) letter = letter == kA ? kD : kA;
  });
}

TEST(CompactMutation, EveryRuleIsNeeded) {
  const std::pair<const char*, std::function<void(Rules&)>> mutations[] = {
      {"arrival lines", [](Rules& rules) { rules.arrivals_count = false; }},
      {"one vertex a cell and type",
       [](Rules& rules) { rules.one_vertex_a_cell_and_type = false; }},
      {"one red in-edge", [](Rules& rules) { rules.one_red_in = false; }},
      {"lengths of at least one", [](Rules& rules) { rules.shortest = 0; }},
      {"the shift of h by the type",
       [](Rules& rules) { rules.place = [](Site s) {
                            return letters_of({s.column, s.row, 0});
                          }; }},
      {"places that are four apart",
       [](Rules& rules) {
         rules.place = [](Site s) {
           const std::int32_t g = s.column + s.row;
           const std::int32_t h = s.column - s.row + 2 * s.type;
           return Letters{g + h, g, h, 0};
         };
       }},
      {"the first short of red edges to the right", red_first_short(0)},
      {"the same in the other variant", red_first_short(1)},
      {"the pairs of shorts of red edges to the left",
       red(false, [](const Shape&,
                     Word& word) { word.short_letter[1] = word.short_letter[1] == kA ? kB : kA; })},
      {"longer red shorts to the right", red_lengths(true, {1, 1, 1})},
      {"longer red shorts to the left", red_lengths(false, {1, 1, 1})},
      {"shorter red shorts to the right", red_lengths(true, {2, 2, 2})},
      {"shorter red shorts to the left", red_lengths(false, {2, 2, 2})}};
  for (const auto& [name, mutate] : mutations) {
    Rules rules;
    mutate(rules);
    EXPECT_GT(wrong_drawings(rules), 0u) << name;
  }
}

}  // namespace
}  // namespace ar3d::compact
