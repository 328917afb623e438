#include "ar3d/model/adjacency_lists.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "ar3d/model/bins.h"

// In canonical order the edges at a vertex come from its smaller neighbours first, ascending, then
// go to its larger ones, ascending: filled in order of the edges, lists ascend. The edges to larger
// neighbours stand side by side already; of many edges, only the half-edges at the larger ends are
// dealt to bins (model/bins.h). A dealt half-edge holds its vertex within the bin and its edge
// within the chunk in place of the edge; bin and chunk follow from its place.
namespace ar3d {
namespace {

constexpr EdgeId kInChunk = kChunkEdges - 1;
constexpr Vertex kInBin = kBinVertices - 1;

AdjacencyLists unwritten_lists(std::uint64_t n, std::uint64_t m) {
  AdjacencyLists lists;
  lists.offsets.resize(n + 1);
  lists.offsets[n] = static_cast<std::uint32_t>(2 * m);
  lists.half_edges.resize(2 * m);
  return lists;
}

/// The offsets count the ends at each vertex, then name the end of its list; filled from the last
/// edge to the first, every list ends with its offset at its first half-edge.
AdjacencyLists counted_lists(std::uint64_t n, std::span<const Edge> edges) {
  AdjacencyLists lists = unwritten_lists(n, edges.size());
  std::uint32_t* const offsets = lists.offsets.data();
  std::fill(offsets, offsets + n, 0u);
  for (const auto [u, v] : edges) {
    ++offsets[u];
    ++offsets[v];
  }
  std::uint32_t place = 0;
  for (std::uint64_t v = 0; v < n; ++v) {
    lists.max_degree = std::max(lists.max_degree, offsets[v]);
    place = offsets[v] += place;
  }
  for (std::size_t e = edges.size(); e-- > 0;) {
    const auto [u, v] = edges[e];
    lists.half_edges[--offsets[u]] = {v, static_cast<EdgeId>(e)};
    lists.half_edges[--offsets[v]] = {u, static_cast<EdgeId>(e)};
  }
  return lists;
}

class BinnedLists {
 public:
  BinnedLists(std::uint64_t n, std::span<const Edge> edges)
      : edges_(edges), bins_(n, edges), lists_(unwritten_lists(n, edges.size())) {
    for (std::uint64_t bin = 0; bin <= bins_.bins(); ++bin) {
      const auto first = std::partition_point(
          edges.begin(), edges.end(), [&](Edge edge) { return edge.u < bins_.first_vertex(bin); });
      first_edge_.push_back(static_cast<EdgeId>(first - edges.begin()));
    }
  }

  AdjacencyLists build() && {
    const auto large_end = [](Edge edge) { return edge.v; };
    bins_.count(large_end);
    bins_.place([&](std::uint64_t bin) { return first_edge_[bin + 1] - first_edge_[bin]; });
    bins_.deal(large_end, [&](Edge edge, std::uint32_t number, std::uint32_t place) {
      lists_.half_edges[place] = {edge.u, (edge.v & kInBin) << kChunkBits | number};
    });
    std::vector<std::uint32_t> max_degree(bins_.threads(), 0);
    std::vector<UnwrittenVector<HalfEdge>> dealt(bins_.threads());
    for_each_in_threads(
        bins_.threads(), bins_.bins(), [&](std::uint32_t thread, std::uint64_t bin) {
          max_degree[thread] = std::max(max_degree[thread], sort_bin(bin, dealt[thread]));
        });
    lists_.max_degree = *std::max_element(max_degree.begin(), max_degree.end());
    return std::move(lists_);
  }

 private:
  /// Writes the lists of the bin's vertices. @return their largest degree.
  std::uint32_t sort_bin(std::uint64_t bin, UnwrittenVector<HalfEdge>& dealt) {
    HalfEdge* const half_edges = lists_.half_edges.data();
    const std::uint32_t begin = bins_.begin(bin);
    dealt.assign(half_edges + begin, half_edges + bins_.end(bin));
    const auto first = static_cast<Vertex>(bins_.first_vertex(bin));
    const auto forward = edges_.subspan(first_edge_[bin], first_edge_[bin + 1] - first_edge_[bin]);
    std::array<std::uint32_t, kBinVertices> next{};
    for (const HalfEdge& half : dealt) ++next[half.edge >> kChunkBits];
    for (const Edge edge : forward) ++next[edge.u - first];
    const std::uint32_t max_degree = *std::max_element(next.begin(), next.end());
    std::uint32_t place = begin;
    for (std::uint64_t v = first; v < bins_.end_vertex(bin); ++v) {
      place += std::exchange(next[v - first], place);
      lists_.offsets[v] = next[v - first];
    }
    std::size_t i = 0;
    for (std::uint64_t chunk = 0; chunk < bins_.chunks(); ++chunk) {
      const auto first_edge = static_cast<EdgeId>(chunk * kChunkEdges);
      for (const std::size_t stop = bins_.places(chunk + 1)[bin] - begin; i < stop; ++i) {
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
  AdjacencyLists lists_;
};

}  // namespace

AdjacencyLists adjacency_lists(std::uint64_t n, std::span<const Edge> edges) {
  if (!worth_binning(n, edges.size())) return counted_lists(n, edges);
  return BinnedLists(n, edges).build();
}

}  // namespace ar3d
