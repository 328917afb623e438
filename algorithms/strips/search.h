#pragma once

// How places in a strip are found, whatever the letters: at random with ejections, at random and
// then in turn, and in ever wider strips.

#include <bit>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <numeric>
#include <optional>
#include <vector>

#include "ar3d/base/random.h"
#include "ar3d/model/graph.h"

namespace ar3d::strips {

/// Holds what a search did.
struct Census {
  std::int64_t trials = 0;     ///< cells tried
  std::int64_t ejections = 0;  ///< vertices taken away again
  std::int64_t scans = 0;      ///< vertices for which all cells were tried in turn
  std::int64_t widenings = 0;  ///< narrow strips given up
};

/// Holds how tight a narrow strip is; ratios in hundredths.
struct Tightness {
  std::int64_t cells = 105;        ///< cells per vertex
  std::int64_t rows = 105;         ///< rows over sqrt(n)
  std::int64_t reach = 60;         ///< reach over columns
  std::int64_t extra_columns = 3;  ///< what small graphs need besides
  std::int64_t extra_reach = 1;
  std::int64_t ejections = 50;  ///< most ejections per vertex
};

/// The next wider strip: a tenth more cells, and a column.
inline Tightness widened(Tightness tightness) {
  tightness.cells += tightness.cells / 10;
  ++tightness.extra_columns;
  ++tightness.extra_reach;
  return tightness;
}

/// Returns how many vertices may be ejected before a strip for n vertices counts as too narrow.
inline std::int64_t most_ejections(std::int64_t n, const Tightness& tightness) {
  return tightness.ejections * n / 100 + 20;
}

/// All vertices, the first one last.
inline std::vector<Vertex> stack_of_vertices(Vertex n) {
  std::vector<Vertex> waiting(n);
  std::iota(waiting.rbegin(), waiting.rend(), 0);
  return waiting;
}

/// Neighbours of one vertex.
using FewVertices = boost::container::static_vector<Vertex, 4>;

/// Greedy search with ejections, as in cuckoo hashing (Pagh and Rodler 2001): a vertex that finds
/// no place ejects one of its placed neighbours, which is placed again next.
/// @param placer  place(waiting): true if the last of them found a place; placed_neighbours(v);
/// remove(v).
/// @param waiting  a stack of vertices, the first one last.
/// @param ejections  how often a vertex may be taken away.
/// @param random  a RandomStream or NumbersAhead.
/// @return false if that did not suffice. Calls place at most |waiting| + 2 ejections + 1 times.
template <class Placer, class Random>
bool place_with_ejections(Placer& placer, std::vector<Vertex> waiting, std::int64_t ejections,
                          Random& random, Census& census) {
  while (!waiting.empty()) {
    const Vertex v = waiting.back();
    if (placer.place(waiting)) {
      waiting.pop_back();
      continue;
    }
    if (ejections-- == 0) return false;
    const FewVertices placed = placer.placed_neighbours(v);
    if (placed.empty()) continue;
    const Vertex away = placed[random.below(static_cast<std::uint32_t>(placed.size()))];
    placer.remove(away);
    waiting.insert(waiting.end() - 1, away);
    ++census.ejections;
  }
  return true;
}

/// Random cells until one is accepted, then all cells in turn.
/// @param accept  bool(cell), cell < cells. @return false if no cell is accepted.
template <class Accept>
bool place_in_turn(std::uint32_t cells, int random_trials, Accept accept, RandomStream& random,
                   Census& census) {
  for (int trial = 0; trial < random_trials; ++trial) {
    ++census.trials;
    if (accept(random.below(cells))) return true;
  }
  ++census.scans;
  for (std::uint32_t cell = 0; cell < cells; ++cell) {
    ++census.trials;
    if (accept(cell)) return true;
  }
  return false;
}

/// Cells of a zone of which `closed` may be closed: one in nine is open.
inline std::int64_t cells_with_reserve(std::int64_t closed) { return closed + closed / 8 + 1; }

/// Random cells to try before all in turn: all are closed with probability below 1/n.
inline int random_trials(std::uint64_t n) { return 6 * static_cast<int>(std::bit_width(n)) + 8; }

/// Returns how many vertices each zone has. @param zones  by vertex.
template <class Zones>
std::vector<std::int64_t> sizes_of(const Zones& zones) {
  std::vector<std::int64_t> sizes;
  for (const auto zone : zones) {
    if (zone >= sizes.size()) sizes.resize(zone + 1u);
    ++sizes[zone];
  }
  return sizes;
}

inline constexpr std::uint64_t kStrips =
    8;  ///< narrow strips tried, each wider than the one before

/// The first of some ever wider narrow strips that can be filled.
/// @param may_try  bool(tightness): whether such a strip keeps the guarantee's box.
/// @param fill  std::optional<Strip>(tightness, number of the strip).
template <class MayTry, class Fill>
auto fill_ever_wider(Tightness tightness, MayTry may_try, Fill fill, Census& census)
    -> decltype(fill(tightness, std::uint64_t{0})) {
  for (std::uint64_t i = 0; i < kStrips && may_try(tightness);
       ++i, tightness = widened(tightness)) {
    if (auto strip = fill(tightness, i)) return strip;
    ++census.widenings;
  }
  return std::nullopt;
}

/// floor(sqrt(value)) for 0 <= value < 2^62, in integers: the same on every platform.
inline std::int64_t square_root(std::int64_t value) {
  std::int64_t root = 0;
  for (std::int64_t bit = std::int64_t{1} << 30; bit > 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) root += bit;
  }
  return root;
}

}  // namespace ar3d::strips
