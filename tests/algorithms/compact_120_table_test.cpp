// The table of words against Lemmas D.3 to D.5, without any drawing: all lattice points of all
// words, with all heads in a window, are sorted by their residues modulo 4 and their height. Points
// of two edges can be made to coincide by moving the edges within the base lattice if and only if
// these agree.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ar3d/algorithms/compact_120/strip.h"

namespace ar3d::compact_120 {
namespace {

/// An entry of the table with the lengths of its shorts, both open to change.
struct Row {
  Class head = Class::n;
  Arm arm = k12;
  Word word;
  std::array<std::int32_t, 3> shorts{1, 1, 1};
};

struct Table {
  std::vector<Row> rows;                                ///< words to the right
  std::array<std::array<std::int32_t, 2>, 3> places{};  ///< (t, w) of the classes, modulo 4
};

Table the_table() {
  Table table;
  for (const Class head : {Class::n, Class::t}) {
    for (const Arm arm : {k12, head == Class::n ? k20 : k01}) {
      const Arrival at = arrival_on(arm, head);
      for (unsigned variant = 0; variant < variants(at); ++variant) {
        table.rows.push_back({head, arm, right_word(at, variant)});
      }
    }
  }
  for (const Class of : {Class::n, Class::s, Class::t}) {
    table.places[static_cast<std::size_t>(of)] = {t_of({0, 0, of}), w_of({0, 0, of})};
  }
  return table;
}

/// What a lattice point of an edge is: a point that belongs to one arm of one vertex (at this
/// offset from it), or one of a middle segment, which only segments of its letter and side may
/// share.
struct Use {
  bool middle = false;
  bool right = true;
  int letter = 0;       ///< of a middle segment
  Class of = Class::n;  ///< of the vertex
  int arm = 0;
  Quad offset{};
  friend auto operator<=>(const Use&, const Use&) = default;
};

Class mirrored_class(Class of) {
  return of == Class::s ? Class::t : of == Class::t ? Class::s : Class::n;
}
int mirrored_arm(int arm) { return arm == k12 ? arm : 2 - arm; }

int letter_of(UnitStep d, bool right) {
  const UnitStep seen = right ? d : mirrored(d);
  return 4 * std::min(seen.gain, seen.lose) + std::max(seen.gain, seen.lose);
}

/// Collects uses by residues and height. Every bucket may have one use only.
class Buckets {
 public:
  /// The use of a point of an edge to the right, and that of its mirror image.
  void add(const Quad& x, Use use) {
    for (const bool right : {true, false}) {
      use.right = right || !use.middle;
      put(right ? x : mirrored(x), use);
      use.of = mirrored_class(use.of);
      use.arm = mirrored_arm(use.arm);
      use.offset = mirrored(use.offset);
      use.letter = use.letter == 7 ? 11 : use.letter == 11 ? 7 : use.letter;  // 13 and 23
    }
  }
  const std::set<std::string>& clashes() const { return clashes_; }

 private:
  void put(const Quad& x, const Use& use) {
    const auto residue = [](std::int32_t value) { return ((value % 4) + 4) % 4; };
    const auto key = std::array{residue(x[0]), residue(x[1]), height(x)};
    const auto [at, added] = uses_.emplace(key, use);
    if (!added && at->second != use) clashes_.insert(fmt::format("height {}", height(x)));
  }

  std::map<std::array<std::int32_t, 3>, Use> uses_;
  std::set<std::string> clashes_;
};

/// All points of one edge, if its lengths are at least 1.
void add_edge(const Row& row, Class tail_class, const Quad& tail, const Quad& head,
              Buckets& buckets) {
  Quad delta{};
  for (std::size_t i = 0; i < 4; ++i) delta[i] = head[i] - tail[i];
  for (std::size_t s = 0; s < 3; ++s) step(delta, row.word[2 * s + 1], -row.shorts[s]);
  // p = 01; q and r are 32 and one of 31 and 30.
  const bool has_30 = row.word[4].lose == 0;
  const bool q_is_32 = row.word[2].lose == 2;
  const std::int32_t by_32 = -delta[2];
  const std::int32_t other = -(delta[0] + delta[1]);
  const std::array<std::int32_t, 3> lengths = {has_30 ? -delta[1] : delta[0],
                                               q_is_32 ? by_32 : other, q_is_32 ? other : by_32};
  if (*std::min_element(lengths.begin(), lengths.end()) < 1) return;
  const auto offset = [](const Quad& x, const Quad& from) {
    return Quad{x[0] - from[0], x[1] - from[1], x[2] - from[2], x[3] - from[3]};
  };
  Quad at = tail;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::int32_t length = i % 2 == 0 ? lengths[i / 2] : row.shorts[i / 2];
    for (std::int32_t k = i % 2 == 0 ? 0 : 1; k <= length; ++k) {
      if (i % 2 == 1 && (k == length && i < 5)) continue;  // begins the next long segment
      Quad x = at;
      step(x, row.word[i], k);
      Use use;
      if (i == 2) {
        use.middle = true;
        use.letter = letter_of(row.word[i], true);
      } else if (i == 0) {
        use = {.of = tail_class, .arm = k01, .offset = offset(x, tail)};
      } else if (i >= 4) {
        use = {.of = row.head, .arm = row.arm, .offset = offset(x, head)};
      } else {  // a midpoint of s1 or s2, which may be met by none
        use = {.of = tail_class, .arm = 3 + static_cast<int>(i), .offset = offset(x, tail)};
      }
      if (use.offset == Quad{} && !use.middle) use.arm = k12;  // a vertex: its own mirror image
      buckets.add(x, use);
    }
    step(at, row.word[i], length);
  }
}

std::size_t clashes(const Table& table, std::int32_t columns) {
  Buckets buckets;
  const auto place = [&](Class of, std::int32_t t, std::int32_t w) -> Quad {
    const auto& at = table.places[static_cast<std::size_t>(of)];
    t = 4 * t + at[0];
    w = 4 * w + at[1];
    return {t, w, -5 * t - w, 4 * t};
  };
  for (const Row& row : table.rows) {
    for (const Class tail : {Class::n, Class::s}) {
      for (std::int32_t t = 0; t <= columns; ++t) {
        for (std::int32_t w = -5 * columns - 4; w <= 4; ++w) {
          add_edge(row, tail, place(tail, 0, 0), place(row.head, t, w), buckets);
        }
      }
    }
  }
  return buckets.clashes().size();
}

constexpr std::int32_t kWindow = 6;

TEST(Compact120Table, NoTwoPointsCoincideThatTheLemmasKeepApart) {
  EXPECT_EQ(the_table().rows.size(), 5u);
  EXPECT_EQ(clashes(the_table(), 10), 0u);
}

TEST(Compact120Table, TheMirrorImageMakesTheWordsToTheLeft) {
  for (const Arrival at :
       {Arrival::on_01, Arrival::on_12, Arrival::on_20, Arrival::on_12_of_extreme}) {
    const Word left = word_of({false, at, 0});
    EXPECT_EQ(left[0], (UnitStep{2, 0}));
    const std::array<UnitStep, 4> last = {UnitStep{1, 0}, {2, 1}, {0, 2}, {2, 1}};
    EXPECT_EQ(left[5], last[static_cast<std::size_t>(at)]);
  }
}

TEST(Compact120Mutation, ThePlacesOfSourcesAndSinksAreNeeded) {
  for (std::int32_t t = 0; t < 4; ++t) {
    for (std::int32_t w = 0; w < 4; ++w) {
      if (t == 2 && w == 2) continue;
      Table table = the_table();
      table.places[1] = {t, w};
      table.places[2] = {4 - t, (5 * t + w) % 4};  // the mirror image
      EXPECT_GT(clashes(table, kWindow), 0u) << t << " " << w;
    }
  }
}

TEST(Compact120Mutation, TheFirstWordOn12IsNotForSinks) {
  Table table = the_table();
  table.rows.push_back({Class::t, k12, right_word(Arrival::on_12, 0)});
  EXPECT_GT(clashes(table, kWindow), 0u);
}

TEST(Compact120Mutation, TheLengthsOfShortsAreNeededButOne) {
  for (std::size_t row = 0; row < the_table().rows.size(); ++row) {
    for (std::size_t s = 0; s < 3; ++s) {
      Table table = the_table();
      table.rows[row].shorts[s] = 2;
      const bool free = row == 0 && s == 0;  // the first short of the first word to N on 12
      EXPECT_EQ(clashes(table, kWindow) == 0, free) << "row " << row << " short " << s + 1;
    }
  }
}

}  // namespace
}  // namespace ar3d::compact_120
