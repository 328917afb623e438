#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "ar3d/base/parallel.h"
#include "ar3d/model/graph.h"

namespace ar3d {

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

/// The chunks and bins of many edges, and the places of the items of each chunk in each bin.
class Bins {
 public:
  Bins(std::uint64_t n, std::span<const Edge> edges)
      : n_(n),
        edges_(edges),
        bins_((n + kBinVertices - 1) / kBinVertices),
        chunks_((edges.size() + kChunkEdges - 1) / kChunkEdges),
        threads_(threads_for(edges.size())),
        places_((chunks_ + 1) * bins_) {}

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

  /// One number for each bin: while counting, how many items of the chunk it gets; after place(),
  /// where the first of them stands. Row chunks() then has the ends of the bins' items.
  std::uint32_t* places(std::uint64_t chunk) { return places_.data() + chunk * bins_; }
  const std::uint32_t* places(std::uint64_t chunk) const { return places_.data() + chunk * bins_; }
  std::uint32_t begin(std::uint64_t bin) const { return places(0)[bin]; }
  std::uint32_t end(std::uint64_t bin) const { return places(chunks_)[bin]; }

  /// Counts one item for each edge, in the bin of the end that bin_end(edge) gives.
  template <class BinEnd>
  void count(BinEnd bin_end) {
    for_each_in_threads(threads_, chunks_, [&](std::uint32_t, std::uint64_t chunk) {
      std::uint32_t* const counts = places(chunk);
      for (const Edge edge : edges_of(chunk)) ++counts[bin_end(edge) >> kBinBits];
    });
  }
  /// Turns counts into places; behind its items every bin has room for as many more as room(bin).
  template <class Room>
  void place(Room room) {
    std::uint32_t place = 0;
    for (std::uint64_t bin = 0; bin < bins_; ++bin) {
      for (std::uint64_t chunk = 0; chunk < chunks_; ++chunk) {
        place += std::exchange(places(chunk)[bin], place);
      }
      places(chunks_)[bin] = place;
      place += room(bin);
    }
  }
  /// Calls put(edge, number in the chunk, place) for every edge.
  template <class BinEnd, class Put>
  void deal(BinEnd bin_end, Put put) const {
    for_each_in_threads(threads_, chunks_, [&](std::uint32_t, std::uint64_t chunk) {
      std::vector<std::uint32_t> next(places(chunk), places(chunk) + bins_);
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
  std::vector<std::uint32_t> places_;
};

}  // namespace ar3d
