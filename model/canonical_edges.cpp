#include "ar3d/model/canonical_edges.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <utility>

#include "ar3d/model/bins.h"

// Counting sort by the smaller end, then the edges of every smaller end sorted by the larger one:
// they are few where degrees are small. Many edges are dealt to bins first (model/bins.h).
namespace ar3d {
namespace {

Edge turned(Edge edge) { return {std::min(edge.u, edge.v), std::max(edge.u, edge.v)}; }
Vertex small_end(Edge edge) { return std::min(edge.u, edge.v); }

/// Sorts the edges at one smaller end by the larger one. @return true if one stands twice.
bool sort_row(Edge* begin, Edge* end) {
  constexpr std::ptrdiff_t kShort = 16;
  const auto before = [](Edge a, Edge b) { return a.v < b.v; };
  if (end - begin > kShort) {
    std::sort(begin, end, before);
  } else {
    for (Edge* i = begin; i != end; ++i) {
      for (Edge* j = i; j != begin && before(*j, *std::prev(j)); --j) std::swap(*j, *std::prev(j));
    }
  }
  return std::adjacent_find(begin, end) != end;
}

/// Sorts the edges of `from`, whose smaller ends are first..first + counts.size() - 1, into `to`.
/// @param counts  zeros; ends with the place behind the edges of each smaller end.
/// @return the first smaller end of a pair that stands twice; first + counts.size() if none does.
std::uint64_t sort_by_counting(std::span<const Edge> from, Edge* to, std::uint64_t first,
                               std::span<std::uint32_t> counts) {
  for (const Edge edge : from) ++counts[small_end(edge) - first];
  std::uint32_t place = 0;
  for (std::uint32_t& count : counts) place += std::exchange(count, place);
  for (const Edge edge : from) to[counts[small_end(edge) - first]++] = turned(edge);
  std::uint64_t twice = counts.size();
  Edge* row = to;
  for (std::uint64_t u = 0; u < counts.size(); ++u) {
    Edge* const end = to + counts[u];
    if (end - row > 1 && sort_row(row, end)) twice = std::min(twice, u);
    row = end;
  }
  return first + twice;
}

/// The edges, sorted, in `sorted`. @return as make_canonical.
std::uint64_t sort_in_bins(std::uint64_t n, std::span<const Edge> edges,
                           UnwrittenVector<Edge>& sorted) {
  Bins bins(n, edges);
  bins.count(small_end);
  bins.place([](std::uint64_t) { return 0u; });
  bins.deal(small_end,
            [&](Edge edge, std::uint32_t, std::uint32_t place) { sorted[place] = turned(edge); });
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

}  // namespace ar3d
