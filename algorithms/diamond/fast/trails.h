#pragma once

// Step 1.1 for large graphs: the chains of linked edges, walked in many stretches at a time, as in
// asynchronous memory access chaining (Kocberber, Falsafi, Grot 2015). fast.h explains the words.
// Dropped: marks in records of 16 bytes at 4n random addresses; two bits a pair stay in the cache.

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <vector>

#include "ar3d/algorithms/diamond/fast/links.h"
#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"

namespace ar3d::diamond::fast {

/// A part of a chain, from the edge that leaves `start` on.
struct TrailStretch {
  PortNumber start = 0;
  PortNumber end = 0;  ///< the last arrival
  const PortNumber* kept = nullptr;
  std::uint32_t num_kept = 0;
  std::uint32_t size = 0;  ///< in edges
  bool starts_at_cut = false;
  bool ends_at_cut = false;
  /// The smallest port that the chain has inside the stretch, its ends not counted; which edge of
  /// the stretch is there, from 0 on; whether the stretch leaves by it or arrives.
  bool low_leaves = false;
  PortNumber low = kNoPort;
  std::uint32_t low_edge = 0;

  /// @param leaving_edge  the number of the edge that leaves.
  void take_low(PortNumber arrival, PortNumber leaving, std::uint32_t leaving_edge) {
    if (std::min(arrival, leaving) >= low) return;
    low = std::min(arrival, leaving);
    low_leaves = leaving < arrival;
    low_edge = low_leaves ? leaving_edge : size - 1;
  }
};

/// A stretch in its chain, as the plain walk takes it; an edge's number is its index in that walk.
struct TrailPiece {
  const TrailStretch* stretch = nullptr;
  bool backwards = false;
  std::uint32_t odd = 0;  ///< the number of the stretch's edge i is odd iff odd + i is
};

/// Walks chains of linked edges: first those that have an end or pass a cut (walk_cut), then the
/// others (walk_uncut).
template <class Link>
class Trails {
 public:
  /// @param all_linked  every entry of every vertex has a linked one.
  Trails(const Records& records, Link link, bool all_linked, const WalkSizes& sizes)
      : records_(records),
        all_linked_(all_linked),
        sizes_(sizes),
        link_(link),
        blocks_(2 * records.size(), std::size_t{sizes.lanes} * sizes.threads),
        lanes_(std::size_t{sizes.lanes} * sizes.threads, TrailLane(blocks_)),
        ended_(all_linked ? 0 : 2 * records.size(), sizes.threads > 1),
        stretch_at_(4 * (records.size() / sizes.stride + 1), kNone) {
    expect(std::has_single_bit(sizes.stride), "the stride is a power of two");
  }

  /// Calls write(piece), in threads, for pieces that cover the chains with an end or a cut; a chain
  /// may be written twice, then in the same way.
  template <class Write>
  void walk_cut(const Write& write);

  /// Calls write(piece), in threads, for the other chains, each of them one piece. They must be all
  /// that is not written.
  /// @param next_unwritten  (i, end): a port in an unwritten chain, by which a walk begins. It has
  /// the least key >= i and below `end` of all their ports that are kept where they are arrivals;
  /// kNoPort if there is none.
  template <class NextUnwritten, class Write>
  void walk_uncut(const NextUnwritten& next_unwritten, const Write& write);

 private:
  static constexpr std::uint32_t kWalked = kNone - 1;  ///< by a stretch without a number yet
  static constexpr std::size_t kPiecesAtATime = 16;

  struct TrailLane {
    explicit TrailLane(LaneBlocks<PortNumber>& blocks) : kept(blocks) {}

    Vertex from = 0;
    Vertex to = 0;
    TrailStretch stretch;
    LaneBuffer<PortNumber> kept;
  };
  struct ArrivalAndOnward {
    PortNumber at;
    std::uint32_t kept;
    PortNumber leaving;
    Vertex onward;  ///< kNone: the chain ends
  };
  template <class Write>
  struct CutWalker;
  template <class NextUnwritten, class Write>
  struct UncutWalker;

  bool cuts(Vertex v) const { return (v & (sizes_.stride - 1)) == 0; }
  /// The stretch that begins or ends at a port of a cut: kNone as long as none is known.
  std::uint32_t& stretch_at(PortNumber p) {
    return stretch_at_[port(vertex_of(p) / sizes_.stride, entry_of(p))];
  }
  /// The same while threads walk; no other thread's walk depends on when it sees it.
  std::atomic_ref<std::uint32_t> shared_stretch_at(PortNumber p) {
    return std::atomic_ref<std::uint32_t>(stretch_at(p));
  }
  /// The port linked with one, or kNoPort.
  PortNumber linked(PortNumber p) const {
    const std::uint32_t entry = link_(vertex_of(p), entry_of(p)).first;
    return records_[vertex_of(p)][entry] == kNone ? kNoPort : port(vertex_of(p), entry);
  }
  TrailLane* lanes_of(std::uint32_t thread) {
    return lanes_.data() + std::size_t{thread} * sizes_.lanes;
  }
  Vertex bound(std::uint32_t thread) const {
    return static_cast<Vertex>(std::uint64_t{records_.size()} * thread / sizes_.threads);
  }

  void begin_at(TrailLane& lane, PortNumber p) const {
    lane.stretch = TrailStretch{};
    lane.stretch.start = p;
    lane.kept.begin();
    lane.to = vertex_of(p);
    go_on(lane, records_[lane.to][entry_of(p)]);
  }
  [[gnu::always_inline]] void go_on(TrailLane& lane, Vertex onward) const {
    lane.from = lane.to;
    lane.to = onward;
    __builtin_prefetch(&records_[onward]);
  }
  [[gnu::always_inline]] ArrivalAndOnward arrive(TrailLane& lane) const {
    const Record& record = records_[lane.to];
    const std::uint32_t arriving = entry_to(record, lane.from);
    const auto [entry, kept] = link_(lane.to, arriving);
    const PortNumber at = port(lane.to, arriving);
    lane.kept.put(at, kept);
    ++lane.stretch.size;
    return {at, kept, port(lane.to, entry), record[entry]};
  }
  /// The stretch, complete except for its ends.
  static TrailStretch& take(TrailLane& lane) {
    lane.stretch.kept = lane.kept.data();
    lane.stretch.num_kept = static_cast<std::uint32_t>(lane.kept.size());
    return lane.stretch;
  }

  std::vector<TrailPiece> pieces_in_chains();
  /// Follows stretches from the end of one until the chain ends or is back, and forgets them on the
  /// way.
  void follow(std::uint32_t number, bool backwards, std::vector<TrailPiece>& pieces);

  const Records& records_;
  const bool all_linked_;
  const WalkSizes sizes_;
  const Link link_;
  LaneBlocks<PortNumber> blocks_;
  std::vector<TrailLane> lanes_;
  TwoBitMarks ended_;  ///< ends from which no walk is needed, by end_key()
  std::vector<TrailStretch> stretches_;
  std::vector<std::uint32_t> stretch_at_;
};

/// One thread's part: what begins in a range of vertices.
template <class Link>
template <class Write>
struct Trails<Link>::CutWalker {
  /// Ends of chains first, so that a short chain is one stretch. Then the ports of cuts at which no
  /// stretch has ended.
  bool start(std::uint32_t number) {
    PortNumber p = next_end();
    const bool at_cut = p == kNoPort;
    if (at_cut) p = next_cut();
    if (p == kNoPort) return false;
    trails.begin_at(lanes[number], p);
    lanes[number].stretch.starts_at_cut = at_cut;
    return true;
  }

  PortNumber next_end() {
    while (at_end < end) {
      const PortNumber p = at_end++;
      const Record& record = trails.records_[vertex_of(p)];
      if (record[3] != kNone) {  // all four are linked
        at_end |= 3;
        ++at_end;
      } else if (record[entry_of(p)] != kNone && trails.linked(p) == kNoPort &&
                 !trails.ended_.has(trails.link_.end_key(p))) {
        return p;
      }
    }
    return kNoPort;
  }

  PortNumber next_cut() {
    while (at_cut < end) {
      const PortNumber p = at_cut++;
      if (!trails.cuts(vertex_of(p))) {
        at_cut = port((vertex_of(p) / trails.sizes_.stride + 1) * trails.sizes_.stride, 0);
      } else if (trails.records_[vertex_of(p)][entry_of(p)] != kNone &&
                 trails.linked(p) != kNoPort &&
                 trails.shared_stretch_at(p).load(std::memory_order_relaxed) == kNone) {
        return p;
      }
    }
    return kNoPort;
  }

  bool advance(std::uint32_t number) {
    TrailLane& lane = lanes[number];
    const ArrivalAndOnward arrival = trails.arrive(lane);
    if (arrival.onward == kNone || trails.cuts(lane.to)) {
      finish(lane, arrival);
      return false;
    }
    lane.stretch.take_low(arrival.at, arrival.leaving, lane.stretch.size);
    trails.go_on(lane, arrival.onward);
    return true;
  }

  void finish(TrailLane& lane, const ArrivalAndOnward& arrival) {
    TrailStretch& stretch = take(lane);
    stretch.end = arrival.at;
    stretch.ends_at_cut = arrival.onward != kNone;
    if (!stretch.ends_at_cut) trails.ended_.set(trails.link_.end_key(stretch.end), 0);
    if (!stretch.starts_at_cut && !stretch.ends_at_cut) {
      const bool backwards = stretch.end < stretch.start;
      write({&stretch, backwards, backwards ? (stretch.size - 1) & 1 : 0});
      lane.kept.drop();
      return;
    }
    stretches.push_back(stretch);
    const auto mark = [&](PortNumber p) {
      trails.shared_stretch_at(p).store(kWalked, std::memory_order_relaxed);
    };
    if (stretch.starts_at_cut) mark(stretch.start);
    if (stretch.ends_at_cut) mark(stretch.end);
  }

  Trails& trails;
  const Write& write;
  TrailLane* lanes;
  PortNumber at_end;  ///< where to look for the next end of a chain
  PortNumber at_cut;  ///< and for the next cut
  PortNumber end;
  std::vector<TrailStretch> stretches = {};
};

/// A stretch may have been walked from both of its ends at the same time: then its ports at cuts
/// get the number of the same one of the two, and the other one is not written.
template <class Link>
template <class Write>
void Trails<Link>::walk_cut(const Write& write) {
  std::vector<CutWalker<Write>> walkers;
  for (std::uint32_t t = 0; t < sizes_.threads; ++t) {
    const PortNumber begin = port(bound(t), 0);
    const PortNumber end = port(bound(t + 1), 0);
    walkers.push_back({*this, write, lanes_of(t), all_linked_ ? end : begin, begin, end});
  }
  for_each_in_threads(sizes_.threads, sizes_.threads, [&](std::uint32_t, std::size_t t) {
    walk_in_lanes(walkers[t], sizes_.lanes);
  });
  for (const auto& walker : walkers) {
    stretches_.insert(stretches_.end(), walker.stretches.begin(), walker.stretches.end());
  }
  for (std::uint32_t number = 0; number < stretches_.size(); ++number) {
    const TrailStretch& stretch = stretches_[number];
    if (stretch.starts_at_cut) stretch_at(stretch.start) = number;
    if (stretch.ends_at_cut) stretch_at(stretch.end) = number;
  }
  const std::vector<TrailPiece> pieces = pieces_in_chains();
  for_each_in_threads(
      sizes_.threads, pieces.size(), [&](std::uint32_t, std::size_t p) { write(pieces[p]); },
      kPiecesAtATime);
}

template <class Link>
std::vector<TrailPiece> Trails<Link>::pieces_in_chains() {
  std::vector<TrailPiece> pieces;
  pieces.reserve(stretches_.size());
  for (std::uint32_t number = 0; number < stretches_.size(); ++number) {
    const TrailStretch& stretch = stretches_[number];
    if (stretch.starts_at_cut && stretch.ends_at_cut) continue;
    if (stretch_at(stretch.starts_at_cut ? stretch.start : stretch.end) != number) continue;
    follow(number, stretch.starts_at_cut, pieces);
  }
  for (const TrailStretch& stretch : stretches_) {
    for (const PortNumber p : {stretch.start, stretch.end}) {
      const bool known = p == stretch.start ? stretch.starts_at_cut : stretch.ends_at_cut;
      if (!known || stretch_at(p) == kNone) continue;
      const std::uint32_t number = stretch_at(p);
      follow(number, stretches_[number].start != p, pieces);
    }
  }
  return pieces;
}

template <class Link>
void Trails<Link>::follow(std::uint32_t number, bool backwards, std::vector<TrailPiece>& pieces) {
  const std::size_t begin = pieces.size();
  const PortNumber from = backwards ? stretches_[number].end : stretches_[number].start;
  TrailStretch chain;  // its size so far, and its smallest port
  bool reversed = false;
  for (;;) {
    const TrailStretch& stretch = stretches_[number];
    const PortNumber last = backwards ? stretch.start : stretch.end;
    if (stretch.starts_at_cut) stretch_at(stretch.start) = kNone;
    if (stretch.ends_at_cut) stretch_at(stretch.end) = kNone;
    const std::uint32_t before = chain.size;
    pieces.push_back({&stretch, backwards, before + (backwards ? stretch.size - 1 : 0)});
    if (stretch.low < chain.low) {
      chain.low = stretch.low;
      chain.low_leaves = stretch.low_leaves != backwards;
      chain.low_edge =
          before + (backwards ? stretch.size - 1 - stretch.low_edge : stretch.low_edge);
    }
    chain.size += stretch.size;
    if (!(backwards ? stretch.starts_at_cut : stretch.ends_at_cut)) {  // from end to end
      reversed = last < from;
      chain.low_edge = reversed ? chain.size - 1 : 0;
      break;
    }
    const PortNumber leaving = linked(last);
    chain.take_low(last, leaving, leaving == from ? 0 : chain.size);
    if (leaving == from) {  // around
      reversed = !chain.low_leaves;
      break;
    }
    number = stretch_at(leaving);
    backwards = stretches_[number].start != leaving;
  }
  for (std::size_t p = begin; p < pieces.size(); ++p) {
    pieces[p].backwards = pieces[p].backwards != reversed;
    pieces[p].odd = (pieces[p].odd + chain.low_edge) & 1;  // the chain's edge low_edge is number 0
  }
}

/// One thread's part: the chains whose least key is in a range.
template <class Link>
template <class NextUnwritten, class Write>
struct Trails<Link>::UncutWalker {
  bool start(std::uint32_t number) {
    const PortNumber p = next_unwritten(next, end);
    next = p == kNoPort ? end : Link::key(p) + 1;
    if (p == kNoPort) return false;
    trails.begin_at(lanes[number], p);
    return true;
  }

  bool advance(std::uint32_t number) {
    TrailLane& lane = lanes[number];
    const ArrivalAndOnward arrival = trails.arrive(lane);
    TrailStretch& stretch = lane.stretch;
    const bool back = arrival.leaving == stretch.start;
    if (!back && arrival.kept && Link::key(arrival.at) < Link::key(stretch.start)) {
      lane.kept.drop();
      return false;
    }
    stretch.take_low(arrival.at, arrival.leaving, back ? 0 : stretch.size);
    if (back) {
      write({&take(lane), !stretch.low_leaves, stretch.low_edge & 1});
      lane.kept.drop();
      return false;
    }
    trails.go_on(lane, arrival.onward);
    return true;
  }

  Trails& trails;
  const NextUnwritten& next_unwritten;
  const Write& write;
  TrailLane* lanes;
  std::uint32_t next;  ///< key
  std::uint32_t end;
};

template <class Link>
template <class NextUnwritten, class Write>
void Trails<Link>::walk_uncut(const NextUnwritten& next_unwritten, const Write& write) {
  for_each_in_threads(sizes_.threads, sizes_.threads, [&](std::uint32_t, std::size_t i) {
    const auto t = static_cast<std::uint32_t>(i);
    UncutWalker<NextUnwritten, Write> walker{*this,
                                             next_unwritten,
                                             write,
                                             lanes_of(t),
                                             Link::key(port(bound(t), 0)),
                                             Link::key(port(bound(t + 1), 0))};
    walk_in_lanes(walker, sizes_.lanes);
  });
}

}  // namespace ar3d::diamond::fast
