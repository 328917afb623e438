// The stages one by one.
#include <gtest/gtest.h>

#include <set>

#include "algorithms/strips_support.h"
#include "ar3d/algorithms/strips/search.h"
#include "ar3d/generators/catalog.h"
#include "support/graphs.h"

namespace ar3d::compact {
namespace {

constexpr std::array<ColourRole, 4> kRoles = {kGreenOut, kGreenIn, kRedOut, kRedIn};

Graph random_regular(std::uint64_t n, std::uint64_t seed = 1) {
  return generate(find_family("random-4-regular"), n, seed);
}

TEST(CompactSquareRoot, IsExact) {
  for (std::int64_t root : {0, 1, 2, 3, 10, 65535, 65536, 1000003}) {
    EXPECT_EQ(strips::square_root(root * root), root);
    EXPECT_EQ(strips::square_root(root * root + 2 * root), root);
  }
}

TEST(CompactDecomposition, GivesEveryEdgeOneTailAndOneHead) {
  for (const Graph& graph : {random_regular(200), testing::complete(5), testing::path(9)}) {
    const Decomposition links = decompose(graph);
    std::vector<int> tails(graph.num_edges(), 0);
    std::vector<int> heads(graph.num_edges(), 0);
    std::size_t green = 0;
    for (Vertex v = 0; v < graph.num_vertices(); ++v) {
      for (const ColourRole role : kRoles) {
        const HalfEdge edge = links.at[v][role];
        if (edge.to == kNobody) continue;
        EXPECT_EQ(graph.other_end(edge.edge, v), edge.to);
        EXPECT_EQ(links.at[edge.to][opposite(role)].to, v);
        ++(is_out(role) ? tails : heads)[edge.edge];
        if (role == kGreenOut) ++green;
      }
    }
    EXPECT_EQ(tails, std::vector<int>(graph.num_edges(), 1));
    EXPECT_EQ(heads, std::vector<int>(graph.num_edges(), 1));
    EXPECT_EQ(links.num_green, green);
  }
}

TEST(CompactSites, AreReadBackFromPointsOfThePlane) {
  for (std::int32_t column = 0; column < 20; ++column) {
    for (std::int32_t row = column % 2; row < 12; row += 2) {
      for (const std::int32_t type : {0, 1}) {
        const Site site{column, row, type};
        const Letters at = letters_of(site);
        EXPECT_EQ(height(at), 0);
        EXPECT_EQ(to_point(at).z, 0);
        EXPECT_EQ(site_of(to_point(at)), site);
        EXPECT_EQ(at[kB] % 4, 0);                         // g
        EXPECT_EQ(((at[kC] - 2 * type) % 4 + 4) % 4, 0);  // h
      }
    }
  }
}

/// All shapes of edges. Green edges go right iff the tail has type 0.
std::vector<Shape> all_shapes() {
  std::vector<Shape> shapes;
  for (const bool red : {false, true}) {
    for (const std::int32_t tail : {0, 1}) {
      for (const std::int32_t head : {0, 1}) {
        for (const bool right : {false, true}) {
          if (!red && right != (tail == 0)) continue;
          for (unsigned variant = 0; variant < variants(red); ++variant) {
            shapes.push_back({red, tail, head, right, variant});
          }
        }
      }
    }
  }
  return shapes;
}

TEST(CompactWords, AlternateAndLeaveEveryVertexByFourLetters) {
  EXPECT_EQ(all_shapes().size(), 32u);
  for (const Shape& shape : all_shapes()) {
    const Word word = word_of(shape);
    const auto [p, q, r] = word.long_letter;
    const auto [s1, s2, s3] = word.short_letter;
    EXPECT_EQ((std::set<Letter>{p, q, r, word.spare}.size()), 4u);
    EXPECT_TRUE(s1 != p && s1 != q && s2 != q && s2 != r && s3 != r);
    const Letter own = shape.tail_type == 0 ? kA : kD;
    const Letter in = shape.head_type == 0 ? kD : kA;
    EXPECT_EQ(p, shape.red ? kB : own);
    EXPECT_EQ(s3, shape.red ? kC : in);
  }
}

TEST(CompactWords, JoinTheirEnds) {
  const Site tail{10, 2, 0};
  for (Shape shape : all_shapes()) {
    const Site from{tail.column, tail.row, shape.tail_type};
    const Site to{shape.right ? 21 : 1, 3, shape.head_type};
    const Word word = word_of(shape);
    const auto lengths = long_lengths(word, letters_of(from), letters_of(to));
    EXPECT_GE(*std::min_element(lengths.begin(), lengths.end()), 1);
    Letters at = letters_of(from);
    for (std::size_t i = 0; i < 3; ++i) {
      at[word.long_letter[i]] += lengths[i];
      at[word.short_letter[i]] -= word.short_length[i];
    }
    EXPECT_EQ(to_point(at), to_point(letters_of(to)));
  }
}

TEST(CompactLines, AgreeWithAPlainList) {
  RandomStream random(5);
  strips::Lines lines(300);
  std::vector<Piece> plain;
  for (int step = 0; step < 20000; ++step) {
    if (!plain.empty() && (plain.size() == 300 || random.chance(1, 2))) {
      const std::uint32_t i = random.below(static_cast<std::uint32_t>(plain.size()));
      lines.erase(plain[i]);
      plain.erase(plain.begin() + i);
      continue;
    }
    const auto low = static_cast<std::int32_t>(random.below(60));
    const Piece piece{1 + random.below(20), low, low + static_cast<std::int32_t>(random.below(5))};
    const bool is_free = std::none_of(plain.begin(), plain.end(),
                                      [&](const Piece& other) { return other.overlaps(piece); });
    ASSERT_EQ(lines.is_free(piece), is_free);
    lines.insert(piece);
    plain.push_back(piece);
  }
}

TEST(CompactLines, AreDifferentForDifferentLetters) {
  const Letters at{0, 0, 0, 0};
  EXPECT_NE(line_key(LineKind::upper_b, at), line_key(LineKind::upper_c, at));
  EXPECT_NE(line_key(LineKind::upper_c, at), line_key(LineKind::lower_c, at));
  const Letters far{-(1 << 24), 1 << 24, 1 << 24, 1 << 24};
  EXPECT_NE(line_key(LineKind::lower_c, far), line_key(LineKind::lower_c, at));
}

TEST(CompactNarrowStrips, AreGivenUpAfterTheirEjections) {
  const Graph graph = random_regular(200);
  Census census;
  const Tightness tight{.cells = 30, .ejections = 50};
  EXPECT_FALSE(fill_narrow_strip(decompose(graph), graph.num_edges(), tight, 1, 0, census));
  EXPECT_LE(census.ejections, 100 + 20);
  EXPECT_LE(census.trials, 120 * (200 + 2 * 120 + 1));
  EXPECT_GT(narrow_size(200, strips::widened(tight)).columns, narrow_size(200, tight).columns);
}

}  // namespace
}  // namespace ar3d::compact
