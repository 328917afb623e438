// What efforts 1 and 2 draw: a strip with about one cell per vertex, filled greedily at random by
// rules (a) to (e) alone (Lemmas C.3 to C.5), without zones and caps. A vertex that finds no cell
// among 120 ejects a placed neighbour, as in cuckoo hashing; nothing proves that this ends well,
// hence the bounded number of ejections and the zones behind it. A cell is refused by the cheapest
// test: eight at a time by the places of neighbours (cells.h), then two bits of its line
// (narrow_lines.h), and only then its pieces. Cost: O(n + ejections) cells, each O(1) expected.
#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

#include "ar3d/algorithms/compact/fill.h"
#include "ar3d/algorithms/compact/narrow_lines.h"
#include "ar3d/algorithms/compact/words.h"
#include "ar3d/algorithms/strips/numbers_ahead.h"
#include "ar3d/base/error.h"

namespace ar3d::compact {
namespace {

/// Puts vertices at random cells of one strip.
class NarrowPlacer {
 public:
  NarrowPlacer(const Decomposition& links, std::size_t num_edges, StripSize size,
               strips::NumbersAhead& random, Census& census)
      : links_(links),
        size_(size),
        places_(links.at.size(), SiteForms{}),
        variant_(num_edges, 0),
        taken_(size),
        lines_(size, num_edges),
        random_(random),
        census_(census) {
    // Efforts 1 and 2 have at most 1.05 * 1.1^7 < 2.1 cells per vertex, with two bits each, and n
    // <= 2^27.
    expect(std::int64_t{size.columns} * (size.rows / 2 + 1) < std::int64_t{1} << 30,
           "places of a narrow strip are counted in 31 bits");
    for (std::size_t i = 0; i < words_.size(); ++i) {
      const WordConstants& first = words_[i / 4 * 4];
      words_[i].step =
          lines_.step(kind_of(i), words_[i].first - first.first, words_[i].second - first.second);
    }
  }

  bool place(const std::vector<Vertex>& waiting) {
    const Vertex v = waiting.back();
    prefetch_neighbours(v + kAhead);
    const JoinedVertex joined = joined_of(v);
    for (int tried = 0; tried < kNarrowTrials; tried += static_cast<int>(kCellsAtOnce)) {
      if (place_in_some_cell(v, joined)) return true;
      if (tried == kHalfway) prefetch_ejection(v, false);
      if (tried == kNearTheEnd) prefetch_ejection(v, true);
    }
    return false;
  }

  strips::FewVertices placed_neighbours(Vertex v) const {
    strips::FewVertices placed;
    for (const HalfEdge& edge : links_.at[v]) {
      if (edge.to != kNobody && places_[edge.to].is_set()) placed.push_back(edge.to);
    }
    return placed;
  }

  void remove(Vertex v) {
    const SiteForms own = places_[v];
    const PlacedEnd end = end_at(own);
    const JoinedVertex joined = joined_of(v);
    if (joined.has_arrival) lines_.flip_arrival(arrival_line(end));
    std::array<Piece, 4> pieces;
    for (std::size_t i = 0; i < joined.edges.size(); ++i) {
      const MiddleLine line = line_of(joined.edges[i], end);
      pieces[i] = piece_of(line, words_[line.word + variant_[joined.edges[i].edge]]);
      lines_.prefetch(pieces[i].line);
      lines_.prefetch_pieces(pieces[i].line);
    }
    for (std::size_t i = 0; i < joined.edges.size(); ++i) lines_.erase(pieces[i]);
    taken_.flip(own);
    places_[v] = {};
  }

  Placement placement() && { return {size_, std::move(places_), std::move(variant_)}; }

 private:
  static constexpr Vertex kAhead = 8;
  // After so many cells, of kNarrowTrials, one neighbour or other is likely to be ejected.
  static constexpr int kHalfway = 48;
  static constexpr int kNearTheEnd = 80;

  /// An edge to a placed neighbour.
  struct JoinedEdge {
    PlacedEnd other;
    EdgeId edge = 0;
    bool red = false;
    bool out = false;
  };
  /// A vertex and its placed neighbours.
  struct JoinedVertex {
    boost::container::static_vector<JoinedEdge, 4> edges;
    bool has_arrival = false;
    CellChoice choice;
  };
  /// Holds what placing one vertex would add.
  struct Plan {
    std::array<Piece, 4> pieces{};  ///< line 0 beyond `count`
    std::array<std::uint8_t, 4> variants{};
    std::size_t count = 0;
    bool overlaps(const Piece& piece) const {
      return any([&](const Piece& other) { return other.overlaps(piece); });
    }
    bool is_on(std::uint64_t line) const {
      return any([&](const Piece& other) { return other.line == line; });
    }

   private:
    template <class Test>
    bool any(Test test) const {  // without branches on what is random
      const auto is = [&](std::size_t i) { return static_cast<unsigned>(test(pieces[i])); };
      return (is(0) | is(1) | is(2) | is(3)) != 0;
    }
  };

  void prefetch_neighbours(Vertex v) const {
    if (v >= links_.at.size()) return;
    for (const HalfEdge& edge : links_.at[v]) {
      if (edge.to != kNobody) __builtin_prefetch(&places_[edge.to]);
    }
  }

  /// Prefetches the edges of v's neighbours, or what removing one of them reads of these.
  void prefetch_ejection(Vertex v, bool edges_are_there) const {
    for (const HalfEdge& edge : links_.at[v]) {
      if (edge.to == kNobody) continue;
      if (!edges_are_there) {
        __builtin_prefetch(&links_.at[edge.to]);
        continue;
      }
      for (const HalfEdge& next : links_.at[edge.to]) {
        if (next.to == kNobody) continue;
        __builtin_prefetch(&places_[next.to]);
        __builtin_prefetch(&variant_[next.edge]);
      }
    }
  }

  /// The columns are those that reach and the types of placed tails leave. The vertex's type is
  /// the side of its green head or, before that is placed, the side that has more room.
  JoinedVertex joined_of(Vertex v) const {
    JoinedVertex joined;
    const Roles& roles = links_.at[v];
    joined.has_arrival = roles[kGreenIn].to != kNobody;
    CellChoice& choice = joined.choice;
    choice = {size_.rows, 0, size_.columns - 1, (size_.columns - 1) / 2, {}, 0};
    for (const ColourRole role : {kGreenOut, kGreenIn, kRedOut, kRedIn}) {
      const HalfEdge edge = roles[role];
      if (edge.to == kNobody) continue;
      const SiteForms other = places_[edge.to];
      if (!other.is_set()) continue;
      const std::int32_t column = other.U / 4;
      choice.neighbours[choice.num_neighbours++] = other;
      choice.low = std::max(choice.low, column - size_.reach);
      choice.high = std::min(choice.high, column + size_.reach);
      joined.edges.push_back({end_at(other), edge.edge, is_red(role), is_out(role)});
      if (role == kGreenOut) choice.last_of_type_0 = column;
      if (role == kGreenIn && joined.edges.back().other.type == 0) {
        choice.low = std::max(choice.low, column + 1);
      } else if (role == kGreenIn) {
        choice.high = std::min(choice.high, column - 1);
      }
    }
    return joined;
  }

  /// Tries the next cells of the stream, kCellsAtOnce of them.
  bool place_in_some_cell(Vertex v, const JoinedVertex& joined) {
    const CellChoice& choice = joined.choice;
    if (!choice.has_cells_in_every_row()) return place_one_by_one(v, joined);
    draw_cells(choice, taken_, random_.ahead(2 * kCellsAtOnce), batch_);
    if (!batch_.is_exact) return place_one_by_one(v, joined);
    for (std::uint32_t open = batch_.open; open != 0; open &= open - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(open));
      if (!try_place(v, {batch_.U[k], batch_.V[k]}, joined)) continue;
      census_.trials += static_cast<std::int64_t>(k) + 1;
      random_.skip(2 * (k + 1));
      return true;
    }
    census_.trials += static_cast<std::int64_t>(kCellsAtOnce);
    random_.skip(2 * kCellsAtOnce);
    return false;
  }

  bool place_one_by_one(Vertex v, const JoinedVertex& joined) {
    const CellChoice& choice = joined.choice;
    for (std::size_t i = 0; i < kCellsAtOnce; ++i) {
      ++census_.trials;
      const auto row =
          static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(choice.rows)));
      const std::int32_t first = choice.low + ((choice.low ^ row) & 1);
      if (first > choice.high) continue;
      const auto choices = static_cast<std::uint32_t>((choice.high - first) / 2 + 1);
      const std::int32_t column = first + 2 * static_cast<std::int32_t>(random_.below(choices));
      const SiteForms place = forms_of({column, row, column > choice.last_of_type_0 ? 1 : 0});
      if (is_open(choice, taken_, place) && try_place(v, place, joined)) return true;
    }
    return false;
  }

  static LineKind kind_of(std::size_t word) {
    return word >= word_index(true, 0, 0, false) ? LineKind::lower_c
           : (word / 8) % 2 == 0                 ? LineKind::upper_b
                                                 : LineKind::upper_c;
  }
  /// Of an edge to a placed neighbour if the vertex stood at that end.
  MiddleLine line_of(const JoinedEdge& edge, const PlacedEnd& own) const {
    MiddleLine line =
        middle_line(edge.red, edge.out ? own : edge.other, edge.out ? edge.other : own);
    const WordConstants& word = words_[line.word];
    line.number =
        lines_.number(kind_of(line.word), line.first + word.first, line.second + word.second);
    return line;
  }
  static Piece piece_of(const MiddleLine& line, const WordConstants& word) {
    const std::int32_t top = line.top + word.top;
    return {line.number + word.step, top - line.length[1] - word.length[1], top};
  }
  /// The whole line on which a green edge arrives (words.h, arrival_line).
  std::uint64_t arrival_line(const PlacedEnd& head) const {
    return head.type == 0 ? lines_.number(LineKind::upper_c, head.U - 2, head.form[0] - 2)
                          : lines_.number(LineKind::upper_b, head.U + 2, head.form[1]);
  }

  bool plan_edge(const MiddleLine& line, bool red, Plan& plan) const {
    for (unsigned variant = 0; variant < variants(red); ++variant) {
      const WordConstants& word = words_[line.word + variant];
      if (line.length[0] + word.length[0] < 1 || line.length[1] + word.length[1] < 1 ||
          line.length[2] + word.length[2] < 1) {
        continue;
      }
      const Piece piece = piece_of(line, word);
      if (plan.overlaps(piece) || !lines_.is_free(piece)) continue;
      plan.variants[plan.count] = static_cast<std::uint8_t>(variant);
      plan.pieces[plan.count++] = piece;
      return true;
    }
    return false;
  }

  /// Places v at an open place if its arrival and all its edges to placed neighbours have room.
  bool try_place(Vertex v, SiteForms own, const JoinedVertex& joined) {
    const PlacedEnd end = end_at(own);
    std::array<MiddleLine, 4> middle;
    for (std::size_t i = 0; i < joined.edges.size(); ++i) {
      middle[i] = line_of(joined.edges[i], end);
      lines_.prefetch(middle[i].number);
    }
    const std::uint64_t arrival = joined.has_arrival ? arrival_line(end) : 0;
    if (joined.has_arrival) lines_.prefetch(arrival);
    for (std::size_t i = 0; i < joined.edges.size(); ++i) lines_.prefetch_pieces(middle[i].number);
    Plan plan;
    for (std::size_t i = 0; i < joined.edges.size(); ++i) {
      if (!plan_edge(middle[i], joined.edges[i].red, plan)) return false;
    }
    if (joined.has_arrival) {
      if (plan.is_on(arrival) || !lines_.is_empty(arrival)) return false;
      lines_.flip_arrival(arrival);
    }
    places_[v] = own;
    taken_.flip(own);
    for (std::size_t i = 0; i < joined.edges.size(); ++i) {
      lines_.insert(plan.pieces[i]);
      variant_[joined.edges[i].edge] = plan.variants[i];
    }
    return true;
  }

  const Decomposition& links_;
  StripSize size_;
  UnwrittenVector<SiteForms> places_;
  std::vector<std::uint8_t> variant_;
  TakenSites taken_;
  NarrowLines lines_;
  WordTable words_ = word_table();
  CellBatch batch_;
  strips::NumbersAhead& random_;
  Census& census_;
};

}  // namespace

StripSize narrow_size(std::int64_t n, const Tightness& tightness) {
  const std::int64_t rows = strips::square_root(tightness.rows * tightness.rows * n) / 100 + 2;
  const std::int64_t cells = tightness.cells * n / 100 + 1;
  const std::int64_t columns = 2 * cells / rows + tightness.extra_columns;
  const std::int64_t reach = tightness.reach * columns / 100 + tightness.extra_reach;
  return {static_cast<std::int32_t>(columns), static_cast<std::int32_t>(rows),
          static_cast<std::int32_t>(std::min(reach, columns))};
}

std::optional<Placement> fill_narrow_strip(const Decomposition& links, std::size_t num_edges,
                                           const Tightness& tightness, std::uint64_t seed,
                                           std::uint64_t stream, Census& census) {
  const auto n = static_cast<Vertex>(links.at.size());
  strips::NumbersAhead random(seed, stream);
  NarrowPlacer placer(links, num_edges, narrow_size(n, tightness), random, census);
  if (!strips::place_with_ejections(placer, strips::stack_of_vertices(n),
                                    strips::most_ejections(n, tightness), random, census)) {
    return std::nullopt;
  }
  return std::move(placer).placement();
}

}  // namespace ar3d::compact
