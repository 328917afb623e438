// The fast filling of narrow strips beside the plain one, and its parts beside what they stand for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include "algorithms/compact_plain_narrow.h"
#include "algorithms/strips_support.h"
#include "ar3d/algorithms/compact/cells.h"
#include "ar3d/algorithms/compact/fill.h"
#include "ar3d/algorithms/compact/narrow_lines.h"
#include "ar3d/algorithms/compact/words.h"
#include "ar3d/generators/catalog.h"

namespace ar3d::compact {
namespace {

/// An edge between two sites that keeps the rules of the sides, in variant 0.
struct Ends {
  Site tail;
  Site head;
  Shape shape;
};

/// All edges between sites of a small strip.
std::vector<Ends> all_ends(const StripSize& size) {
  std::vector<Site> sites;
  for (std::int32_t column = 0; column < size.columns; ++column) {
    for (std::int32_t row = column % 2; row < size.rows; row += 2) {
      for (const std::int32_t type : {0, 1}) sites.push_back({column, row, type});
    }
  }
  std::vector<Ends> ends;
  for (const Site& tail : sites) {
    for (const Site& head : sites) {
      const std::int32_t across = head.column - tail.column;
      if (across == 0 || std::abs(across) > size.reach) continue;
      ends.push_back({tail, head, {true, tail.type, head.type, across > 0, 0}});
      if ((across > 0) != (tail.type == 0)) continue;
      ends.push_back({tail, head, {false, tail.type, head.type, across > 0, 0}});
    }
  }
  return ends;
}

MiddleLine line_of(const Ends& ends) {
  return middle_line(ends.shape.red, end_at(forms_of(ends.tail)), end_at(forms_of(ends.head)));
}

Piece plain_piece(const Ends& ends, const Shape& shape) {
  const Word word = word_of(shape);
  const Letters tail = letters_of(ends.tail);
  const auto lengths = long_lengths(word, tail, letters_of(ends.head));
  return middle_piece(word, shape.red, middle_start(word, tail, lengths), lengths[1]);
}

TEST(CompactMiddleLines, AreThoseOfTheWords) {
  const WordTable table = word_table();
  for (const Ends& ends : all_ends({9, 6, 5})) {
    const MiddleLine line = line_of(ends);
    Shape shape = ends.shape;
    for (; shape.variant < variants(shape.red); ++shape.variant) {
      const Word word = word_of(shape);
      const Letters tail = letters_of(ends.tail);
      const auto lengths = long_lengths(word, tail, letters_of(ends.head));
      const Letters start = middle_start(word, tail, lengths);
      const WordConstants& constants = table[line.word + shape.variant];
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(line.length[i] + constants.length[i], lengths[i]);
        ASSERT_LE(std::abs(constants.length[i]), 8);
      }
      const Letter other = !shape.red && word.long_letter[1] == kB ? kC : kB;
      ASSERT_EQ(line.first + constants.first, start[kA] - start[kD]);
      ASSERT_EQ(line.second + constants.second, start[other] - start[kD]);
      ASSERT_EQ(line.top + constants.top, height(start));
      ASSERT_LE(std::max(std::abs(constants.first), std::abs(constants.second)), 8);
    }
  }
}

TEST(CompactNarrowLines, HaveNumbersOfTheirOwn) {
  const StripSize size{25, 10, 15};
  const NarrowLines lines(size, 1);
  const WordTable table = word_table();
  std::map<std::uint64_t, std::uint64_t> number_of;  // by key
  std::map<std::uint64_t, std::uint64_t> key_of;
  for (const Ends& ends : all_ends(size)) {
    const MiddleLine line = line_of(ends);
    Shape shape = ends.shape;
    for (; shape.variant < variants(shape.red); ++shape.variant) {
      const std::uint64_t key = plain_piece(ends, shape).line;
      const WordConstants& constants = table[line.word + shape.variant];
      const auto kind = static_cast<LineKind>(key >> 62);
      const std::uint64_t number =
          lines.number(kind, line.first + constants.first, line.second + constants.second);
      EXPECT_NE(number, 0u);
      const WordConstants& first = table[line.word];
      EXPECT_EQ(number, lines.number(kind, line.first + first.first, line.second + first.second) +
                            lines.step(kind, constants.first - first.first,
                                       constants.second - first.second));
      EXPECT_TRUE(lines.is_empty(number));  // its bits are there
      EXPECT_EQ(number_of.emplace(key, number).first->second, number);
      EXPECT_EQ(key_of.emplace(number, key).first->second, key);
    }
  }
  EXPECT_GT(number_of.size(), 1000u);
}

TEST(CompactNarrowLines, AgreeWithAPlainList) {
  RandomStream random(6);
  NarrowLines lines({9, 6, 5}, 200);
  std::vector<Piece> plain;
  std::vector<std::uint64_t> arrivals;
  const auto is_on = [](std::uint64_t line) {
    return [line](const Piece& piece) { return piece.line == line; };
  };
  for (int step = 0; step < 20000; ++step) {
    const std::uint64_t line = 1 + random.below(40);
    const bool arrives = std::find(arrivals.begin(), arrivals.end(), line) != arrivals.end();
    const bool empty = !arrives && std::none_of(plain.begin(), plain.end(), is_on(line));
    ASSERT_EQ(lines.is_empty(line), empty);
    const std::uint32_t what = random.below(4);
    if (what == 0 && !plain.empty()) {
      const std::uint32_t i = random.below(static_cast<std::uint32_t>(plain.size()));
      lines.erase(plain[i]);
      plain.erase(plain.begin() + i);
    } else if (what == 1 && (empty || arrives)) {
      lines.flip_arrival(line);
      if (arrives) std::erase(arrivals, line);
      if (empty) arrivals.push_back(line);
    } else {
      const auto low = static_cast<std::int32_t>(random.below(60));
      const Piece piece{line, low, low + static_cast<std::int32_t>(random.below(5))};
      const bool is_free = !arrives && std::none_of(plain.begin(), plain.end(), [&](Piece other) {
        return other.overlaps(piece);
      });
      lines.prefetch(line);
      lines.prefetch_pieces(line);
      ASSERT_EQ(lines.is_free(piece), is_free);
      if (!is_free || plain.size() == 200) continue;
      lines.insert(piece);
      plain.push_back(piece);
    }
  }
}

TEST(CompactCells, AreTheSameOneByOneAndSeveralAtATime) {
  const StripSize size{41, 13, 20};
  TakenSites taken(size);
  RandomStream random(7);
  const auto below = [&](std::int32_t bound) {
    return static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(bound)));
  };
  const auto random_place = [&] {
    const std::int32_t column = below(size.columns);
    return forms_of({column, column % 2 + 2 * below(6), below(2)});
  };
  int open = 0;
  int inexact = 0;
  for (int step = 0; step < 20000; ++step) {
    if (step < 300) taken.flip(random_place());
    CellChoice choice{size.rows, below(20), 0, below(size.columns), {}, random.below(5)};
    choice.high = choice.low + 1 + below(size.columns - choice.low - 1);
    for (SiteForms& place : choice.neighbours) place = random_place();
    std::array<std::uint32_t, 2 * kCellsAtOnce> numbers;
    for (std::uint32_t& number : numbers) number = random.next32();
    if (step % 3 == 0) numbers[random.below(16)] = 0;
    CellBatch batch, plain;
    draw_cells(choice, taken, numbers.data(), batch);
    draw_cells_plainly(choice, taken, numbers.data(), plain);
    ASSERT_EQ(batch.U, plain.U);
    ASSERT_EQ(batch.V, plain.V);
    ASSERT_EQ(batch.open, plain.open);
    ASSERT_EQ(batch.is_exact, plain.is_exact);
    open += batch.open != 0 ? 1 : 0;
    inexact += batch.is_exact ? 0 : 1;
    for (std::size_t k = 0; k < kCellsAtOnce; ++k) {
      const SiteForms place{batch.U[k], batch.V[k]};
      EXPECT_EQ((batch.open >> k & 1) != 0, is_open(choice, taken, place));
      const Site site = site_of(place);
      EXPECT_TRUE(site.row >= 0 && site.row < size.rows && (site.column - site.row) % 2 == 0);
      EXPECT_TRUE(site.column >= choice.low && site.column <= choice.high);
    }
  }
  EXPECT_GT(open, 1000);
  EXPECT_GT(inexact, 1000);
}

/// Both fillings of a strip: the same vertices at the same places, the same words, the same census.
void expect_same(const Graph& graph, const Tightness& tightness, std::uint64_t seed) {
  const Decomposition links = decompose(graph);
  Census census, fast_census;
  const std::optional<Placement> plain =
      fill_plainly(links, graph.num_edges(), tightness, RandomStream(seed, 3), census);
  const std::optional<Placement> fast =
      fill_narrow_strip(links, graph.num_edges(), tightness, seed, 3, fast_census);
  EXPECT_EQ(fast_census.trials, census.trials);
  EXPECT_EQ(fast_census.ejections, census.ejections);
  ASSERT_EQ(fast.has_value(), plain.has_value());
  if (!plain) return;
  EXPECT_EQ(fast->size, plain->size);
  EXPECT_EQ(fast->variant, plain->variant);
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    ASSERT_EQ(site_of(fast->places[v]), site_of(plain->places[v])) << v;
  }
}

TEST(CompactFastNarrowStrips, AreThePlainOnesOnEveryFamily) {
  const Tightness tighter{
      .cells = 95, .rows = 107, .reach = 57, .extra_columns = 2, .ejections = 200};
  int drawn = 0;
  for (const Family& family : families()) {
    for (const std::uint64_t n : {12u, 100u, 700u}) {
      const Graph graph = generate(family, n, 4, {{"shuffle", 1}});
      if (graph.max_degree() > 4) continue;
      SCOPED_TRACE(family.name + " " + std::to_string(graph.num_vertices()));
      expect_same(graph, {}, n);
      expect_same(graph, tighter, n + 1);
      ++drawn;
    }
  }
  EXPECT_GT(drawn, 100);
}

TEST(CompactFastNarrowStrips, AreThePlainOnesWhereNoStripCanBeFilled) {
  for (const std::uint64_t n : {1u, 2u, 5u, 60u, 500u}) {
    const Graph graph = generate(find_family("random-max-degree"), n, 4);
    for (const std::int64_t cells : {20, 60, 80, 90}) {
      expect_same(graph, {.cells = cells, .rows = 60, .extra_columns = 0}, n);
      expect_same(graph, {.cells = cells, .reach = 10}, n);
    }
  }
}

TEST(CompactFastNarrowStrips, AreThePlainOnesOnALargeGraph) {
  expect_same(generate(find_family("random-4-regular"), 30000, 1), {}, 1);
}

}  // namespace
}  // namespace ar3d::compact
