#include "ar3d/model/graph_rows.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

// Few edges: counting sort. Many edges would be scattered over memory far beyond the caches, so
// their half-edges are first dealt to bins of kBinVertices vertices each, every bin standing where
// its rows will stand, and then every bin is sorted within the caches (radix partitioning; the idea
// of propagation blocking, Beamer, Asanovic and Patterson 2017). A dealt half-edge holds the vertex
// within the bin and the edge within its chunk of kChunkEdges edges in place of the edge; the bins
// keep the order of the chunks, so that bin and chunk follow from its place.
namespace ar3d {
namespace {

constexpr unsigned kBinBits = 13;  // the half-edges of a bin of degree 4 fill 256 KiB
constexpr unsigned kChunkBits = 32 - kBinBits;
constexpr std::uint64_t kBinVertices = std::uint64_t{1} << kBinBits;
constexpr std::uint64_t kChunkEdges = std::uint64_t{1} << kChunkBits;
constexpr EdgeId kInChunk = kChunkEdges - 1;
constexpr std::uint64_t kFewEdges = std::uint64_t{1} << 16;

/// What is known of a range of finished rows.
struct RowFacts {
  std::uint32_t max_degree = 0;
  std::uint64_t repeating = 0;
};

/// The facts of the rows first to last - 1 of n, which end before half-edge row_end.
RowFacts facts_of(const Rows& rows, std::uint64_t first, std::uint64_t last, std::uint32_t row_end,
                  std::uint64_t n) {
  RowFacts facts{0, n};
  for (std::uint64_t v = last; v-- > first;) {
    const std::uint32_t row_begin = rows.offsets[v];
    const std::span row(rows.half_edges.data() + row_begin, row_end - row_begin);
    facts.max_degree = std::max(facts.max_degree, row_end - row_begin);
    if (row.size() <= kShortRow && first_repeat(row) != row.size()) facts.repeating = v;
    row_end = row_begin;
  }
  return facts;
}

Rows unwritten_rows(std::uint64_t n, std::uint64_t m) {
  Rows rows;
  rows.offsets.resize(n + 1);
  rows.offsets[n] = static_cast<std::uint32_t>(2 * m);
  rows.half_edges.resize(2 * m);
  return rows;
}

/// The offsets count the ends at each vertex, then name the end of its row; filled from the last
/// edge to the first, every row ends with its offset at its first half-edge.
Rows counted_rows(std::uint64_t n, std::span<const Edge> edges) {
  Rows rows = unwritten_rows(n, edges.size());
  std::uint32_t* const offsets = rows.offsets.data();
  std::fill(offsets, offsets + n, 0u);
  for (const auto [u, v] : edges) {
    ++offsets[u];
    ++offsets[v];
  }
  std::uint32_t place = 0;
  for (std::uint64_t v = 0; v < n; ++v) place = offsets[v] += place;
  for (std::size_t e = edges.size(); e-- > 0;) {
    const auto [u, v] = edges[e];
    rows.half_edges[--offsets[u]] = {v, static_cast<EdgeId>(e)};
    rows.half_edges[--offsets[v]] = {u, static_cast<EdgeId>(e)};
  }
  const RowFacts facts = facts_of(rows, 0, n, rows.offsets[n], n);
  rows.max_degree = facts.max_degree;
  rows.repeating = facts.repeating;
  return rows;
}

class BinnedRows {
 public:
  BinnedRows(std::uint64_t n, std::span<const Edge> edges)
      : n_(n),
        edges_(edges),
        bins_((n + kBinVertices - 1) / kBinVertices),
        chunks_((edges.size() + kChunkEdges - 1) / kChunkEdges),
        parts_(static_cast<std::uint64_t>(threads_for(edges.size()))),
        places_((chunks_ + 1) * bins_),
        rows_(unwritten_rows(n, edges.size())) {}

  Rows build() && {
    for_each_part(chunks_, [&](std::uint64_t, auto begin, auto end) {
      for (std::uint64_t chunk = begin; chunk < end; ++chunk) count(chunk);
    });
    turn_into_places();
    for_each_part(chunks_, [&](std::uint64_t, auto begin, auto end) {
      for (std::uint64_t chunk = begin; chunk < end; ++chunk) deal(chunk);
    });
    std::vector<RowFacts> facts(parts_, {0, n_});
    for_each_part(bins_, [&](std::uint64_t part, auto begin, auto end) {
      facts[part] = sort_bins(begin, end);
    });
    rows_.repeating = n_;
    for (const RowFacts& part : facts) {
      rows_.max_degree = std::max(rows_.max_degree, part.max_degree);
      rows_.repeating = std::min(rows_.repeating, part.repeating);
    }
    return std::move(rows_);
  }

 private:
  /// Calls work(part, begin, end) for ranges that make up 0..items, one a thread.
  template <class Work>
  void for_each_part(std::uint64_t items, Work work) const {
    const int threads = static_cast<int>(parts_);
#pragma omp parallel for schedule(static, 1) num_threads(threads)
    for (std::uint64_t part = 0; part < parts_; ++part) {
      work(part, items * part / parts_, items * (part + 1) / parts_);
    }
  }
  /// One number for each bin: first how many half-edges of the chunk it gets, then where they
  /// stand. Those of chunk chunks_ are the ends of the bins.
  std::uint32_t* places(std::uint64_t chunk) { return places_.data() + chunk * bins_; }
  std::span<const Edge> edges_of(std::uint64_t chunk) const {
    const std::uint64_t first = chunk * kChunkEdges;
    return edges_.subspan(first, std::min(kChunkEdges, edges_.size() - first));
  }

  void count(std::uint64_t chunk) {
    std::uint32_t* const counts = places(chunk);
    for (const auto [u, v] : edges_of(chunk)) {
      ++counts[u >> kBinBits];
      ++counts[v >> kBinBits];
    }
  }
  void turn_into_places() {
    std::uint32_t place = 0;
    for (std::uint64_t bin = 0; bin < bins_; ++bin) {
      for (std::uint64_t chunk = 0; chunk < chunks_; ++chunk) {
        place += std::exchange(places(chunk)[bin], place);
      }
      places(chunks_)[bin] = place;
    }
  }
  void deal(std::uint64_t chunk) {
    constexpr Vertex kInBin = kBinVertices - 1;
    std::vector<std::uint32_t> next(places(chunk), places(chunk) + bins_);
    HalfEdge* const half_edges = rows_.half_edges.data();
    std::uint32_t edge = 0;  // within the chunk
    for (const auto [u, v] : edges_of(chunk)) {
      half_edges[next[u >> kBinBits]++] = {v, (u & kInBin) << kChunkBits | edge};
      half_edges[next[v >> kBinBits]++] = {u, (v & kInBin) << kChunkBits | edge};
      ++edge;
    }
  }

  RowFacts sort_bins(std::uint64_t begin, std::uint64_t end) {
    RowFacts facts{0, n_};
    UnwrittenVector<HalfEdge> dealt;
    for (std::uint64_t bin = begin; bin < end; ++bin) {
      sort_bin(bin, dealt);
      const std::uint64_t first = bin * kBinVertices;
      const RowFacts more =
          facts_of(rows_, first, std::min(n_, first + kBinVertices), places(chunks_)[bin], n_);
      facts.max_degree = std::max(facts.max_degree, more.max_degree);
      facts.repeating = std::min(facts.repeating, more.repeating);
    }
    return facts;
  }
  void sort_bin(std::uint64_t bin, UnwrittenVector<HalfEdge>& dealt) {
    const std::uint32_t begin = places(0)[bin];
    const std::uint32_t end = places(chunks_)[bin];
    HalfEdge* const half_edges = rows_.half_edges.data();
    dealt.assign(half_edges + begin, half_edges + end);
    std::array<std::uint32_t, kBinVertices> next{};
    for (const HalfEdge& half : dealt) ++next[half.edge >> kChunkBits];
    const std::uint64_t first = bin * kBinVertices;
    const std::uint64_t vertices = std::min(n_ - first, kBinVertices);
    std::uint32_t place = begin;
    for (std::uint64_t v = 0; v < vertices; ++v) {
      place += std::exchange(next[v], place);
      rows_.offsets[first + v] = next[v];
    }
    std::size_t i = 0;
    for (std::uint64_t chunk = 0; chunk < chunks_; ++chunk) {
      const auto first_edge = static_cast<EdgeId>(chunk * kChunkEdges);
      for (const std::size_t stop = places(chunk + 1)[bin] - begin; i < stop; ++i) {
        const auto [to, packed] = dealt[i];
        half_edges[next[packed >> kChunkBits]++] = {to, first_edge | (packed & kInChunk)};
      }
    }
  }

  std::uint64_t n_;
  std::span<const Edge> edges_;
  std::uint64_t bins_;
  std::uint64_t chunks_;
  std::uint64_t parts_;
  std::vector<std::uint32_t> places_;
  Rows rows_;
};

}  // namespace

std::size_t first_repeat(std::span<const HalfEdge> row) {
  for (std::size_t i = 1; i < row.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (row[i].to == row[j].to) return i;
    }
  }
  return row.size();
}

Rows rows_of(std::uint64_t n, std::span<const Edge> edges) {
  if (edges.size() < kFewEdges || n <= kBinVertices) return counted_rows(n, edges);
  return BinnedRows(n, edges).build();
}

}  // namespace ar3d
