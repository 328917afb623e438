// Brings edges into canonical order and makes adjacency lists, in linear time: a counting sort by
// the smaller end, then the edges of every smaller end by the larger one, few where degrees are
// small. Many edges are dealt to bins first, so that each sort stays within the caches.
#include "ar3d/model/canonical_edges.h"

#include <array>
#include <functional>

#include "ar3d/base/parallel.h"

namespace ar3d {

namespace {

/// Few items are sorted by counting. Many would be scattered over memory far beyond the caches, so
/// they are first dealt to bins of kBinVertices vertices with neighbouring names, every bin
/// standing where its sorted items will stand, and then every bin is sorted within the caches
/// (radix partitioning; the idea of propagation blocking, Beamer, Asanovic and Patterson 2017).
/// Threads deal the edges in chunks of kChunkEdges; a bin holds its items in the order of the
/// chunks, and of the edges in each.
inline constexpr unsigned kBinBits = 13;  // the half-edges of a bin of degree 4 fill 256 KiB
inline constexpr unsigned kChunkBits = 32 - kBinBits;
inline constexpr std::uint64_t kBinVertices = std::uint64_t{1} << kBinBits;
inline constexpr std::uint64_t kChunkEdges = std::uint64_t{1} << kChunkBits;

/// True if bins pay.
inline bool worth_binning(std::uint64_t n, std::uint64_t edges) {
  return edges >= std::uint64_t{1} << 16 && n > kBinVertices;
}

/// The chunks and bins of many edges, and the indices of the items of each chunk in each bin.
class Bins {
 public:
  Bins(std::uint64_t n, std::span<const Edge> edges)
      : n_(n),
        edges_(edges),
        bins_((n + kBinVertices - 1) / kBinVertices),
        chunks_((edges.size() + kChunkEdges - 1) / kChunkEdges),
        threads_(threads_for(edges.size())),
        indices_((chunks_ + 1) * bins_) {}

  std::uint64_t bins() const { return bins_; }
  std::uint64_t chunks() const { return chunks_; }
  std::uint32_t threads() const { return threads_; }
  std::uint64_t first_vertex(std::uint64_t bin) const { return bin * kBinVertices; }
  std::uint64_t end_vertex(std::uint64_t bin) const {
    return std::min(n_, (bin + 1) * kBinVertices);
  }
  std::span<const Edge> edges_of(std::uint64_t chunk) const {
    const std::uint64_t first = chunk * kChunkEdges;
    return edges_.subspan(first, std::min(kChunkEdges, edges_.size() - first));
  }

  /// For each bin: how many items of the chunk it gets, after make_indices() where the first of them
  /// stands. Row chunks() then has the ends of the bins' items.
  std::uint32_t* indices(std::uint64_t chunk) { return indices_.data() + chunk * bins_; }
  std::uint32_t begin(std::uint64_t bin) const { return indices_[bin]; }
  std::uint32_t end(std::uint64_t bin) const { return indices_[chunks_ * bins_ + bin]; }

  /// Counts one item for each edge, in the bin of the end that bin_end(edge) gives.
  template <class BinEnd>
  void count(BinEnd bin_end) {
    for_each_in_threads(threads_, chunks_, [&](std::uint32_t, std::uint64_t chunk) {
      std::uint32_t* const counts = indices(chunk);
      for (const Edge edge : edges_of(chunk)) ++counts[bin_end(edge) >> kBinBits];
    });
  }
  /// Turns counts into indices; behind its items every bin has room for as many more as room(bin).
  template <class Room>
  void make_indices(Room room) {
    std::uint32_t index = 0;
    for (std::uint64_t bin = 0; bin < bins_; ++bin) {
      for (std::uint64_t chunk = 0; chunk < chunks_; ++chunk) {
        index += std::exchange(indices(chunk)[bin], index);
      }
      indices(chunks_)[bin] = index;
      index += room(bin);
    }
  }
  /// Calls put(edge, number in the chunk, index) for every edge.
  template <class BinEnd, class Put>
  void deal(BinEnd bin_end, Put put) {
    for_each_in_threads(threads_, chunks_, [&](std::uint32_t, std::uint64_t chunk) {
      std::vector<std::uint32_t> next(indices(chunk), indices(chunk) + bins_);
      std::uint32_t number = 0;
      for (const Edge edge : edges_of(chunk))
        put(edge, number++, next[bin_end(edge) >> kBinBits]++);
    });
  }

 private:
  std::uint64_t n_;
  std::span<const Edge> edges_;
  std::uint64_t bins_;
  std::uint64_t chunks_;
  std::uint32_t threads_;
  std::vector<std::uint32_t> indices_;
};

Edge turned(Edge edge) { return {std::min(edge.u, edge.v), std::max(edge.u, edge.v)}; }
Vertex small_end(Edge edge) { return std::min(edge.u, edge.v); }

/// Sorts the edges at one smaller end by the larger one. @return true if one stands twice.
bool sort_edges_of_row(Edge* begin, Edge* end) {
  sort_row(begin, end, [](Edge a, Edge b) { return a.v < b.v; });
  return std::adjacent_find(begin, end) != end;
}

/// Sorts the edges of `from`, whose smaller ends are first..first + counts.size() - 1, into `to`.
/// @param counts  zeros; ends with the index after the edges of each smaller end.
/// @return the first smaller end of a pair that stands twice; first + counts.size() if none does.
std::uint64_t sort_by_counting(std::span<const Edge> from, Edge* to, std::uint64_t first,
                               std::span<std::uint32_t> counts) {
  for (const Edge edge : from) ++counts[small_end(edge) - first];
  std::uint32_t index = 0;
  for (std::uint32_t& count : counts) index += std::exchange(count, index);
  for (const Edge edge : from) to[counts[small_end(edge) - first]++] = turned(edge);
  std::uint64_t twice = counts.size();
  Edge* row = to;
  for (std::uint64_t u = 0; u < counts.size(); ++u) {
    Edge* const end = to + counts[u];
    if (end - row > 1 && sort_edges_of_row(row, end)) twice = std::min(twice, u);
    row = end;
  }
  return first + twice;
}

/// The edges, sorted, in `sorted`. @return as make_canonical.
std::uint64_t sort_in_bins(std::uint64_t n, std::span<const Edge> edges,
                           UnwrittenVector<Edge>& sorted) {
  Bins bins(n, edges);
  bins.count(small_end);
  bins.make_indices([](std::uint64_t) { return 0u; });
  bins.deal(small_end,
            [&](Edge edge, std::uint32_t, std::uint32_t index) { sorted[index] = turned(edge); });
  std::vector<std::uint64_t> twice(bins.threads(), n);
  std::vector<UnwrittenVector<Edge>> dealt(bins.threads());
  for_each_in_threads(bins.threads(), bins.bins(), [&](std::uint32_t thread, std::uint64_t bin) {
    std::array<std::uint32_t, kBinVertices> counts{};
    const std::uint64_t first = bins.first_vertex(bin);
    const std::span used(counts.data(), bins.end_vertex(bin) - first);
    dealt[thread].assign(sorted.data() + bins.begin(bin), sorted.data() + bins.end(bin));
    const std::uint64_t found =
        sort_by_counting(dealt[thread], sorted.data() + bins.begin(bin), first, used);
    if (found != first + used.size()) twice[thread] = std::min(twice[thread], found);
  });
  return *std::min_element(twice.begin(), twice.end());
}

constexpr EdgeId kInChunk = kChunkEdges - 1;
constexpr Vertex kInBin = kBinVertices - 1;

/// The offsets count the ends at each vertex, then name the end of its list; filled from the last
/// edge to the first, every list ends with its offset at its first half-edge.
/// @return the largest degree.
std::uint32_t count_lists(std::uint64_t n, std::span<const Edge> edges, std::uint32_t* offsets,
                          HalfEdge* half_edges) {
  std::fill(offsets, offsets + n, 0u);
  for (const auto [u, v] : edges) {
    ++offsets[u];
    ++offsets[v];
  }
  std::uint32_t index = 0, max_degree = 0;
  for (std::uint64_t v = 0; v < n; ++v) {
    max_degree = std::max(max_degree, offsets[v]);
    index = offsets[v] += index;
  }
  for (std::size_t e = edges.size(); e-- > 0;) {
    const auto [u, v] = edges[e];
    half_edges[--offsets[u]] = {v, static_cast<EdgeId>(e)};
    half_edges[--offsets[v]] = {u, static_cast<EdgeId>(e)};
  }
  return max_degree;
}

class BinnedLists {
 public:
  BinnedLists(std::uint64_t n, std::span<const Edge> edges, std::uint32_t* offsets,
              HalfEdge* half_edges)
      : edges_(edges), bins_(n, edges), offsets_(offsets), half_edges_(half_edges) {
    for (std::uint64_t bin = 0; bin <= bins_.bins(); ++bin) {
      const auto first = std::partition_point(
          edges.begin(), edges.end(), [&](Edge edge) { return edge.u < bins_.first_vertex(bin); });
      first_edge_.push_back(static_cast<EdgeId>(first - edges.begin()));
    }
  }

  /// Writes the lists. @return the largest degree.
  std::uint32_t build() {
    const auto large_end = [](Edge edge) { return edge.v; };
    bins_.count(large_end);
    bins_.make_indices([&](std::uint64_t bin) { return first_edge_[bin + 1] - first_edge_[bin]; });
    bins_.deal(large_end, [&](Edge edge, std::uint32_t number, std::uint32_t index) {
      half_edges_[index] = {edge.u, (edge.v & kInBin) << kChunkBits | number};
    });
    std::vector<std::uint32_t> max_degree(bins_.threads(), 0);
    std::vector<UnwrittenVector<HalfEdge>> dealt(bins_.threads());
    for_each_in_threads(
        bins_.threads(), bins_.bins(), [&](std::uint32_t thread, std::uint64_t bin) {
          max_degree[thread] = std::max(max_degree[thread], sort_bin(bin, dealt[thread]));
        });
    return *std::max_element(max_degree.begin(), max_degree.end());
  }

 private:
  /// Writes the lists of the bin's vertices. @return their largest degree.
  std::uint32_t sort_bin(std::uint64_t bin, UnwrittenVector<HalfEdge>& dealt) {
    HalfEdge* const half_edges = half_edges_;
    const std::uint32_t begin = bins_.begin(bin);
    dealt.assign(half_edges + begin, half_edges + bins_.end(bin));
    const auto first = static_cast<Vertex>(bins_.first_vertex(bin));
    const auto forward = edges_.subspan(first_edge_[bin], first_edge_[bin + 1] - first_edge_[bin]);
    std::array<std::uint32_t, kBinVertices> next{};
    for (const HalfEdge& half : dealt) ++next[half.edge >> kChunkBits];
    for (const Edge edge : forward) ++next[edge.u - first];
    const std::uint32_t max_degree = *std::max_element(next.begin(), next.end());
    std::uint32_t index = begin;
    for (std::uint64_t v = first; v < bins_.end_vertex(bin); ++v) {
      index += std::exchange(next[v - first], index);
      offsets_[v] = next[v - first];
    }
    std::size_t i = 0;
    for (std::uint64_t chunk = 0; chunk < bins_.chunks(); ++chunk) {
      const auto first_edge = static_cast<EdgeId>(chunk * kChunkEdges);
      for (const std::size_t stop = bins_.indices(chunk + 1)[bin] - begin; i < stop; ++i) {
        const auto [to, packed] = dealt[i];
        half_edges[next[packed >> kChunkBits]++] = {to, first_edge | (packed & kInChunk)};
      }
    }
    EdgeId e = first_edge_[bin];
    for (const Edge edge : forward) half_edges[next[edge.u - first]++] = {edge.v, e++};
    return max_degree;
  }

  std::span<const Edge> edges_;
  Bins bins_;
  std::vector<EdgeId> first_edge_;  // of the bin's smaller ends
  std::uint32_t* offsets_;
  HalfEdge* half_edges_;
};

}  // namespace

bool are_canonical(std::span<const Edge> edges) {
  if (!edges.empty() && edges.front().u >= edges.front().v) return false;
  const auto ascend = [](Edge a, Edge b) {
    return b.u < b.v && (a.u < b.u || (a.u == b.u && a.v < b.v));
  };
  return std::adjacent_find(edges.begin(), edges.end(), std::not_fn(ascend)) == edges.end();
}

std::uint64_t make_canonical(std::uint64_t n, std::vector<Edge>& edges) {
  if (are_canonical(edges)) return n;
  UnwrittenVector<Edge> sorted(edges.size());
  std::uint64_t twice = n;
  if (worth_binning(n, edges.size())) {
    twice = sort_in_bins(n, edges, sorted);
  } else {
    std::vector<std::uint32_t> counts(n, 0);
    twice = sort_by_counting(edges, sorted.data(), 0, counts);
  }
  if (twice != n) return twice;
  for_ranges_in_threads(threads_for(edges.size()), edges.size(),
                        [&](std::uint32_t, std::size_t begin, std::size_t end) {
                          std::copy(&sorted[begin], &sorted[end - 1] + 1, &edges[begin]);
                        });
  return n;
}

// In canonical order the edges at a vertex come from its smaller neighbours first, ascending, then
// go to its larger ones, ascending: filled in order of the edges, lists ascend. The edges to larger
// neighbours stand side by side already; of many edges, only the half-edges at the larger ends are
// dealt to bins. A dealt half-edge holds its vertex within the bin and its edge
// within the chunk in place of the edge; bin and chunk follow from its index.

std::uint32_t make_adjacency_lists(std::uint64_t n, std::span<const Edge> edges,
                                   UnwrittenVector<std::uint32_t>& offsets,
                                   UnwrittenVector<HalfEdge>& half_edges) {
  offsets.resize(n + 1);
  offsets[n] = static_cast<std::uint32_t>(2 * edges.size());
  half_edges.resize(2 * edges.size());
  if (worth_binning(n, edges.size())) {
    return BinnedLists(n, edges, offsets.data(), half_edges.data()).build();
  }
  return count_lists(n, edges, offsets.data(), half_edges.data());
}

}  // namespace ar3d
