// Step 1.2 for large graphs. As in trails.h the paths and cycles are cut at every so many-th vertex
// and the stretches walked in turns; cycles without a cut are walked from each of their vertices
// until a smaller one is met. Then they are copied in the order in which the plain walk finds them.
// O(n).
#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "ar3d/algorithms/diamond/interleaved.h"
#include "ar3d/algorithms/diamond/lane_buffer.h"
#include "ar3d/algorithms/diamond/two_bit_marks.h"
#include "ar3d/base/error.h"
#include "ar3d/base/long_vector.h"

namespace ar3d::diamond {
namespace {

/// Vertices in the order of the colour, each with the edge by which it is left.
struct Stretch {
  Vertex start = 0;
  const Vertex* vertex = nullptr;
  const EdgeId* edge = nullptr;
  std::uint32_t size = 0;       ///< 0: a cycle that is not walked from its smallest vertex
  std::uint32_t low_place = 0;  ///< of the lowest vertex in it
  Vertex then = kNone;          ///< where the next one starts
};

struct Lane {
  Lane(LaneBlocks<Vertex>& vertices, LaneBlocks<EdgeId>& edges) : vertex(vertices), edge(edges) {}

  Vertex at = 0;
  Vertex lowest = 0;
  std::uint32_t low_place = 0;
  std::uint32_t stretch = 0;
  LaneBuffer<Vertex> vertex;
  LaneBuffer<EdgeId> edge;

  void begin(Vertex v, std::size_t number) {
    at = lowest = v;
    low_place = 0;
    stretch = static_cast<std::uint32_t>(number);
    vertex.begin();
    edge.begin();
  }
  void pass(EdgeId left_by) {
    vertex.put(at);
    edge.put(left_by);
  }
  void drop() {
    vertex.drop();
    edge.drop();
  }
  void end(Stretch& result, Vertex then) const {
    result.vertex = vertex.data();
    result.edge = edge.data();
    result.size = static_cast<std::uint32_t>(vertex.size());
    result.low_place = low_place;
    result.then = then;
  }
};

class ItemWalks {
 public:
  ItemWalks(const std::vector<HalfEdge>& next, const WalkSizes& sizes)
      : next_(next),
        sizes_(sizes),
        vertices_(next.size(), sizes.lanes),
        edges_(next.size(), sizes.lanes),
        lanes_(sizes.lanes, Lane(vertices_, edges_)),
        at_cut_(next.size() / sizes.stride + 1) {
    expect(std::has_single_bit(sizes.stride), "the stride is a power of two");
    std::size_t ends = 0;
    for (const HalfEdge& half : next) ends += half.to == kNone;
    if (ends > 0) {
      follows_.emplace(next.size(), false);
      for (const HalfEdge& half : next) {
        if (half.to != kNone) follows_->set(half.to, 0);
      }
    }
    stretches_.reserve(ends + at_cut_.size());
    reserve_long(items_.vertex, next.size());
    reserve_long(items_.edge, next.size());
    items_.begin.reserve(ends + 1);
  }

  Items run() {
    CutWalker walker{*this};
    walk_in_lanes(walker, sizes_.lanes);
    place_paths();
    place_cycles();
    return std::move(items_);
  }

 private:
  /// What begins a path or a cut.
  struct CutWalker {
    bool start(std::uint32_t number) {
      if (!walks.follows_) {  // no paths
        v = (v + walks.sizes_.stride - 1) / walks.sizes_.stride * walks.sizes_.stride;
      } else {
        while (v < walks.next_.size() && !walks.cuts(v) && !walks.begins_long_path(v)) ++v;
      }
      if (v >= walks.next_.size()) return false;
      walks.begin_stretch(number, v++);
      return true;
    }
    bool advance(std::uint32_t number) {
      Lane& lane = walks.lanes_[number];
      const HalfEdge half = walks.next_[lane.at];
      if (lane.at < lane.lowest) {
        lane.lowest = lane.at;
        lane.low_place = static_cast<std::uint32_t>(lane.vertex.size());
      }
      lane.pass(half.edge);
      if (half.to == kNone || walks.cuts(half.to)) {
        lane.end(walks.stretches_[lane.stretch], half.to);
        return false;
      }
      lane.at = half.to;
      __builtin_prefetch(&walks.next_[lane.at]);
      return true;
    }
    ItemWalks& walks;
    std::size_t v = 0;
  };

  /// Cycles without a cut, once the others are placed. A walk that comes to a smaller vertex than
  /// its first stops: another one begins there, or has begun.
  struct UncutWalker {
    bool start(std::uint32_t number) {
      v = walks.placed_->first_unmarked(v, end);
      if (v == end) return false;
      walks.begin_stretch(number, v++);
      return true;
    }
    bool advance(std::uint32_t number) {
      Lane& lane = walks.lanes_[number];
      const HalfEdge half = walks.next_[lane.at];
      lane.pass(half.edge);
      Stretch& stretch = walks.stretches_[lane.stretch];
      if (half.to <= stretch.start) {
        if (half.to == stretch.start) {
          lane.end(stretch, kNone);
          walks.mark_placed(stretch);
        } else {
          lane.drop();
        }
        return false;
      }
      lane.at = half.to;
      __builtin_prefetch(&walks.next_[lane.at]);
      return true;
    }
    ItemWalks& walks;
    std::uint32_t end;
    std::uint32_t v = 0;
  };

  /// A cycle that is cut: its smallest vertex, and the stretch with it.
  using CutCycle = std::pair<Vertex, std::uint32_t>;

  bool cuts(std::size_t v) const { return (v & (sizes_.stride - 1)) == 0; }
  bool begins_path(Vertex v) const { return follows_ && !follows_->has(v); }
  bool begins_long_path(std::size_t v) const {
    return !follows_->has(static_cast<Vertex>(v)) && next_[v].to != kNone;
  }
  std::uint32_t after(std::uint32_t stretch) const {
    return at_cut_[stretches_[stretch].then / sizes_.stride];
  }

  void begin_stretch(std::uint32_t number, std::size_t at) {
    const auto v = static_cast<Vertex>(at);
    if (cuts(v)) at_cut_[v / sizes_.stride] = static_cast<std::uint32_t>(stretches_.size());
    lanes_[number].begin(v, stretches_.size());
    stretches_.emplace_back().start = v;
  }

  void place(const Stretch& stretch, std::uint32_t from, std::uint32_t to) {
    items_.vertex.insert(items_.vertex.end(), stretch.vertex + from, stretch.vertex + to);
    items_.edge.insert(items_.edge.end(), stretch.edge + from, stretch.edge + to);
  }
  void place(const Stretch& stretch) { place(stretch, 0, stretch.size); }
  void end_item() { items_.begin.push_back(static_cast<std::uint32_t>(items_.vertex.size())); }

  void mark_placed(const Stretch& stretch) {
    for (std::uint32_t i = 0; i < stretch.size; ++i) placed_->set(stretch.vertex[i], 0);
  }

  /// By their first vertices, as are the stretches. A vertex alone has none, but at a cut.
  void place_paths() {
    if (!follows_) return;
    std::uint32_t i = 0;
    for (Vertex v = follows_->first_unmarked(0, num_vertices()); v < num_vertices();
         v = follows_->first_unmarked(v + 1, num_vertices())) {
      if (next_[v].to == kNone) {
        items_.vertex.push_back(v);
        items_.edge.push_back(kNone);
      } else {
        while (stretches_[i].start != v) ++i;
        std::uint32_t stretch = i;
        place(stretches_[stretch]);
        while (stretches_[stretch].then != kNone) place(stretches_[stretch = after(stretch)]);
      }
      end_item();
    }
  }

  std::uint32_t num_vertices() const { return static_cast<std::uint32_t>(next_.size()); }

  /// Those that no path has, from their smallest vertices around.
  std::vector<CutCycle> cut_cycles() const {
    std::vector<CutCycle> cycles;
    std::vector<bool> seen(stretches_.size(), false);
    const auto number = static_cast<std::uint32_t>(stretches_.size());
    for (std::uint32_t i = 0; i < number; ++i) {
      if (!begins_path(stretches_[i].start)) continue;
      for (std::uint32_t s = i; !seen[s]; s = after(s)) {
        seen[s] = true;
        if (stretches_[s].then == kNone) break;
      }
    }
    for (std::uint32_t i = 0; i < number; ++i) {
      CutCycle cycle{kNone, 0};
      for (std::uint32_t s = i; !seen[s]; s = after(s)) {
        seen[s] = true;
        cycle = std::min(cycle, CutCycle{stretches_[s].vertex[stretches_[s].low_place], s});
      }
      if (cycle.first != kNone) cycles.push_back(cycle);
    }
    std::sort(cycles.begin(), cycles.end());
    return cycles;
  }

  /// From its smallest vertex around.
  void place_cut_cycle(std::uint32_t first) {
    const Stretch& begun = stretches_[first];
    place(begun, begun.low_place, begun.size);
    for (std::uint32_t s = after(first); s != first; s = after(s)) place(stretches_[s]);
    place(begun, 0, begun.low_place);
    end_item();
  }

  /// Walks them. They follow the other stretches, in ascending order of their smallest vertices.
  void walk_uncut_cycles() {
    placed_.emplace(next_.size(), false);
    for (const Stretch& stretch : stretches_) mark_placed(stretch);
    for (Vertex v = 0; follows_ && v < num_vertices(); ++v) {
      if (next_[v].to == kNone) placed_->set(v, 0);
    }
    UncutWalker walker{*this, num_vertices()};
    walk_in_lanes(walker, sizes_.lanes);
  }

  void place_cycles() {
    const std::vector<CutCycle> cut = cut_cycles();
    std::size_t left = next_.size() - items_.vertex.size();
    for (const CutCycle& cycle : cut) left -= size_around(cycle.second);
    auto uncut = static_cast<std::uint32_t>(stretches_.size());
    if (left > 0) walk_uncut_cycles();
    for (const auto& [smallest, stretch] : cut) {
      place_uncut_below(smallest, uncut);
      place_cut_cycle(stretch);
    }
    place_uncut_below(kNone, uncut);
  }

  std::size_t size_around(std::uint32_t first) const {
    std::size_t size = stretches_[first].size;
    for (std::uint32_t s = after(first); s != first; s = after(s)) size += stretches_[s].size;
    return size;
  }

  void place_uncut_below(Vertex bound, std::uint32_t& uncut) {
    for (; uncut < stretches_.size() && stretches_[uncut].start < bound; ++uncut) {
      if (stretches_[uncut].size == 0) continue;
      place(stretches_[uncut]);
      end_item();
    }
  }

  const std::vector<HalfEdge>& next_;
  const WalkSizes sizes_;
  std::optional<TwoBitMarks> follows_;  ///< vertices with a predecessor; nothing: all
  std::optional<TwoBitMarks> placed_;
  LaneBlocks<Vertex> vertices_;
  LaneBlocks<EdgeId> edges_;
  std::vector<Lane> lanes_;
  std::vector<std::uint32_t> at_cut_;  ///< the stretch that starts there
  std::vector<Stretch> stretches_;     ///< in ascending order of their starts
  Items items_;
};

}  // namespace

Items interleaved_items(const std::vector<HalfEdge>& next, const WalkSizes& sizes) {
  return ItemWalks(next, sizes).run();
}

}  // namespace ar3d::diamond
