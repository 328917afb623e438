#pragma once

// Step 1.1 for large graphs: the chains of linked edges, walked in many stretches at the same time.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "ar3d/algorithms/diamond/in_threads.h"
#include "ar3d/algorithms/diamond/walk_lanes.h"
#include "ar3d/model/graph.h"
#include "ar3d/model/threads.h"

namespace ar3d::diamond {

/// The neighbours of a vertex in the order of incident(v), padded with kNoNeighbour, in the low 28
/// bits; above them what is known of the edge. A step of a walk reads one record of 16 bytes.
using Record = std::array<std::uint32_t, 4>;
using Records = UnwrittenVector<Record>;
inline constexpr std::uint32_t kNeighbourMask = (1u << 28) - 1;
inline constexpr std::uint32_t kNoNeighbour = kNeighbourMask;
inline constexpr std::uint32_t kOut = 1u << 28;  ///< the edge leaves this vertex
inline constexpr std::uint32_t kIn = 1u << 29;   ///< it enters this vertex
inline constexpr std::uint32_t kIsRed = 1u << 30;
inline constexpr std::uint32_t kColoured = 1u << 31;

inline std::uint32_t neighbour(const Record& record, std::uint32_t entry) {
  return record[entry] & kNeighbourMask;
}

/// An end of an edge: 4 * vertex + entry. n <= 2^27, so it fits 29 bits.
using Port = std::uint32_t;
inline constexpr Port port(Vertex v, std::uint32_t entry) { return v << 2 | entry; }
inline constexpr Vertex vertex_of(Port p) { return p >> 2; }
inline constexpr std::uint32_t entry_of(Port p) { return p & 3; }

inline constexpr std::uint32_t kNoEntry = 4;

/// Links the entries (0, 1) and (2, 3) of every vertex.
struct LinkPairs {
  std::uint32_t operator()(const Record& record, std::uint32_t entry) const {
    return neighbour(record, entry ^ 1u) == kNoNeighbour ? kNoEntry : entry ^ 1u;
  }
};

/// Links the two edges out of a vertex, and the two into it.
struct LinkSameDirection {
  std::uint32_t operator()(const Record& record, std::uint32_t entry) const {
    const std::uint32_t direction = record[entry] & (kOut | kIn);
    for (std::uint32_t other = 0; other < 4; ++other) {
      if (other != entry && (record[other] & direction) != 0) return other;
    }
    return kNoEntry;
  }
};

/// A part of a chain: the ports at which its edges arrive, from the edge that leaves `start` on.
struct Stretch {
  Port start = 0;
  Port end = 0;  ///< the last arrival
  std::uint32_t lane = 0;
  std::size_t begin = 0;  ///< of its arrivals among those of the lane
  std::uint32_t size = 0;
  /// The smallest port that the chain has inside the stretch, its ends not counted; which edge of
  /// the stretch is there, from 1 on; whether the stretch leaves by it or arrives.
  Port low = ~Port{0};
  std::uint32_t low_edge = 0;
  bool low_leaves = false;
};

/// A chain as stretches in order, each walked forwards or backwards, in the direction that the
/// plain walk takes: from the smaller of its two ends or, if it is closed, out of its smallest
/// port.
struct Trail {
  std::vector<std::pair<const Stretch*, bool>> pieces;  ///< true: backwards
  std::uint64_t first = 0;  ///< number of the edge at which the plain walk begins, counted from 0
};

/// Finds the chains that have an end or pass a vertex whose number is a multiple of the stride.
template <class Link>
class Trails {
 public:
  /// @param all_linked  every entry of every vertex has a linked one.
  Trails(const Records& records, bool all_linked, const WalkSizes& sizes)
      : records_(records),
        all_linked_(all_linked),
        sizes_(sizes),
        lanes_(std::size_t{sizes.lanes} * sizes.threads) {
    const std::size_t ends = all_linked ? records.size() / sizes.stride + 1 : records.size();
    stretch_at_.assign(4 * ends, kNone);
    for (Lane& lane : lanes_) lane.arrivals.reserve(2 * records.size() / lanes_.size() + 1024);
  }

  /// Calls visit(trail), once for each.
  template <class Visit>
  void for_each(Visit visit) {
    walk_all();
    visit_open(visit);
    visit_closed(visit);
  }

  /// The arrivals of a stretch.
  const Port* arrivals(const Stretch& stretch) const {
    return lanes_[stretch.lane].arrivals.data() + stretch.begin;
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static constexpr std::uint32_t kWalked = kNone - 1;  ///< by a stretch without a number yet
  struct Lane {
    Stretch stretch;
    Vertex from = 0;
    Vertex to = 0;
    std::vector<Port> arrivals;
  };
  /// One thread's part: the stretches that begin in a range of vertices.
  struct Walker {
    bool start(std::uint32_t number) { return trails->start(*this, trails->lanes_[lane + number]); }
    bool advance(std::uint32_t number) {
      return trails->advance(*this, trails->lanes_[lane + number]);
    }
    Trails* trails = nullptr;
    std::uint32_t lane = 0;  ///< the first one
    Port next = 0;           ///< where to look for the next start
    Vertex end = 0;
    std::vector<Stretch> stretches = {};
  };
  void walk_all();
  bool start(Walker& walker, Lane& lane);
  bool advance(Walker& walker, Lane& lane);

  bool cuts(Vertex v) const { return v % sizes_.stride == 0; }
  /// The stretch that begins or ends at a port where one may: kNone as long as none is known.
  std::uint32_t& stretch_at(Port p) {
    return stretch_at_[all_linked_ ? port(vertex_of(p) / sizes_.stride, entry_of(p)) : p];
  }
  std::uint32_t linked(Port p) const { return link_(records_[vertex_of(p)], entry_of(p)); }
  /// The same while threads walk; no other thread's walk depends on when it sees it.
  std::atomic_ref<std::uint32_t> shared_stretch_at(Port p) {
    return std::atomic_ref<std::uint32_t>(stretch_at(p));
  }
  bool next_start(Walker& walker, Port& p);
  void finish(Walker& walker, Lane& lane);

  template <class Visit>
  void visit_open(Visit& visit);
  template <class Visit>
  void visit_closed(Visit& visit);
  /// Follows stretches from a port until the chain ends or is back. Forgets them on the way.
  /// True if it leaves its smallest port, false if it arrives there.
  bool follow(Port from);
  void reverse();

  const Records& records_;
  const bool all_linked_;
  const WalkSizes sizes_;
  const Link link_{};
  std::vector<Lane> lanes_;
  std::vector<Stretch> stretches_;
  std::vector<std::uint32_t> stretch_at_;
  Trail trail_;  ///< the one at hand
};

/// The next port at which a stretch begins and none has ended.
template <class Link>
bool Trails<Link>::next_start(Walker& walker, Port& p) {
  while (vertex_of(walker.next) < walker.end) {
    p = walker.next++;
    const Vertex v = vertex_of(p);
    if (all_linked_ && !cuts(v)) {  // nothing begins before the next cut
      walker.next = port((v / sizes_.stride + 1) * sizes_.stride, 0);
      continue;
    }
    if (neighbour(records_[v], entry_of(p)) == kNoNeighbour) continue;
    if (!cuts(v) && linked(p) != kNoEntry) continue;
    if (shared_stretch_at(p).load(std::memory_order_relaxed) == kNone) return true;
  }
  return false;
}

template <class Link>
bool Trails<Link>::start(Walker& walker, Lane& lane) {
  Port p = 0;
  if (!next_start(walker, p)) return false;
  lane.stretch = Stretch{};
  lane.stretch.start = p;
  lane.stretch.lane = static_cast<std::uint32_t>(&lane - lanes_.data());
  lane.stretch.begin = lane.arrivals.size();
  lane.from = vertex_of(p);
  lane.to = neighbour(records_[lane.from], entry_of(p));
  __builtin_prefetch(&records_[lane.to]);
  return true;
}

template <class Link>
bool Trails<Link>::advance(Walker& walker, Lane& lane) {
  const Record& record = records_[lane.to];
  std::uint32_t entry = 0;
  while (neighbour(record, entry) != lane.from) ++entry;
  const Port arrival = port(lane.to, entry);
  lane.arrivals.push_back(arrival);
  ++lane.stretch.size;
  const std::uint32_t next = link_(record, entry);
  if (next == kNoEntry || cuts(lane.to)) {
    finish(walker, lane);
    return false;
  }
  const Port leaving = port(lane.to, next);
  if (std::min(arrival, leaving) < lane.stretch.low) {
    lane.stretch.low = std::min(arrival, leaving);
    lane.stretch.low_leaves = leaving < arrival;
    lane.stretch.low_edge = lane.stretch.size + (leaving < arrival ? 1 : 0);
  }
  lane.from = lane.to;
  lane.to = neighbour(record, next);
  __builtin_prefetch(&records_[lane.to]);
  return true;
}

template <class Link>
void Trails<Link>::finish(Walker& walker, Lane& lane) {
  lane.stretch.end = lane.arrivals.back();
  walker.stretches.push_back(lane.stretch);
  for (const Port p : {lane.stretch.start, lane.stretch.end}) {
    shared_stretch_at(p).store(kWalked, std::memory_order_relaxed);
  }
}

/// A stretch may have been walked from both of its ends at the same time: then both ports get the
/// number of the same one of the two, which is all that is asked of them.
template <class Link>
void Trails<Link>::walk_all() {
  const auto n = static_cast<Vertex>(records_.size());
  std::vector<Walker> walkers(sizes_.threads);
  for (std::uint32_t t = 0; t < sizes_.threads; ++t) {
    const auto bound = [&](std::uint32_t i) {
      return static_cast<Vertex>(std::uint64_t{n} * i / sizes_.threads);
    };
    walkers[t].trails = this;
    walkers[t].lane = t * sizes_.lanes;
    walkers[t].next = port(bound(t), 0);
    walkers[t].end = bound(t + 1);
  }
  in_threads(sizes_.threads, [&](std::uint32_t t) { walk_in_lanes(walkers[t], sizes_.lanes); });
  for (const Walker& walker : walkers) {
    stretches_.insert(stretches_.end(), walker.stretches.begin(), walker.stretches.end());
  }
  for (std::uint32_t number = 0; number < stretches_.size(); ++number) {
    stretch_at(stretches_[number].start) = stretch_at(stretches_[number].end) = number;
  }
}

template <class Link>
bool Trails<Link>::follow(Port from) {
  trail_.pieces.clear();
  std::uint64_t edges = 0;  // before the piece at hand
  Port lowest = ~Port{0};
  bool low_leaves = false;
  const auto take_low = [&](Port low, bool leaves, std::uint64_t edge) {
    if (low >= lowest) return;
    lowest = low;
    low_leaves = leaves;
    trail_.first = edge;
  };
  for (Port p = from;;) {
    const Stretch& stretch = stretches_[stretch_at(p)];
    const bool backwards = stretch.start != p;
    const Port end = backwards ? stretch.start : stretch.end;
    trail_.pieces.emplace_back(&stretch, backwards);
    stretch_at(p) = stretch_at(end) = kNone;
    if (stretch.size > 1) {
      take_low(stretch.low, stretch.low_leaves != backwards,
               edges + (backwards ? stretch.size - stretch.low_edge : stretch.low_edge - 1));
    }
    edges += stretch.size;
    const std::uint32_t next = linked(end);
    if (next == kNoEntry) return low_leaves;
    const Port leaving = port(vertex_of(end), next);
    // The edge after the last one of a closed chain is its first one.
    const std::uint64_t edge_after = leaving == from ? 0 : edges;
    take_low(std::min(end, leaving), leaving < end, leaving < end ? edge_after : edges - 1);
    if (leaving == from) return low_leaves;
    p = leaving;
  }
}

template <class Link>
void Trails<Link>::reverse() {
  std::uint64_t edges = 0;
  for (auto& [stretch, backwards] : trail_.pieces) {
    backwards = !backwards;
    edges += stretch->size;
  }
  std::reverse(trail_.pieces.begin(), trail_.pieces.end());
  trail_.first = edges - 1 - trail_.first;
}

template <class Link>
template <class Visit>
void Trails<Link>::visit_open(Visit& visit) {
  if (all_linked_) return;
  for (Port p = 0; vertex_of(p) < records_.size(); ++p) {
    if (stretch_at(p) == kNone || linked(p) != kNoEntry) continue;
    follow(p);
    trail_.first = 0;
    visit(trail_);
  }
}

template <class Link>
template <class Visit>
void Trails<Link>::visit_closed(Visit& visit) {
  for (std::size_t v = 0; v < records_.size(); v += sizes_.stride) {
    for (std::uint32_t entry = 0; entry < 4; ++entry) {
      const Port p = port(static_cast<Vertex>(v), entry);
      if (stretch_at(p) == kNone) continue;
      if (!follow(p)) reverse();
      visit(trail_);
    }
  }
}

}  // namespace ar3d::diamond
