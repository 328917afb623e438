// Step 1.2 for large graphs. The paths and cycles are cut and walked in lanes as in trails.h;
// cycles without a cut are walked from each of their vertices until a smaller one is met. Then they
// are copied in the order in which the plain walk finds them, O(n). A further copy cost 4 to 6 %.
#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "ar3d/algorithms/diamond/fast/marks_and_lanes.h"
#include "ar3d/base/error.h"
#include "ar3d/base/long_vector.h"

namespace ar3d::diamond::fast {
namespace {

/// From so many vertices on many walks at a time are faster.
constexpr std::size_t kManyInItems = 1u << 15;

/// Vertices in the order of the colour, each with the edge by which it is left.
struct ItemStretch {
  Vertex start = 0;
  const Vertex* vertex = nullptr;
  const EdgeId* edge = nullptr;
  std::uint32_t size = 0;  ///< 0: a cycle that is not walked from its smallest vertex
  Vertex then = kNone;     ///< where the next one starts
};

struct ItemLane {
  ItemLane(LaneBlocks<Vertex>& vertices, LaneBlocks<EdgeId>& edges)
      : vertex(vertices), edge(edges) {}

  Vertex at = 0;
  std::uint32_t stretch = 0;
  LaneBuffer<Vertex> vertex;
  LaneBuffer<EdgeId> edge;

  void pass(EdgeId left_by) {
    vertex.put(at);
    edge.put(left_by);
  }
  void drop() {
    vertex.drop();
    edge.drop();
  }
};

class ItemWalks {
 public:
  ItemWalks(const std::vector<HalfEdge>& next, const WalkSizes& sizes)
      : next_(next),
        sizes_(sizes),
        vertices_(next.size(), sizes.lanes),
        edges_(next.size(), sizes.lanes),
        lanes_(sizes.lanes, ItemLane(vertices_, edges_)),
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
    CutItemWalker walker{*this};
    walk_in_lanes(walker, sizes_.lanes);
    place_paths();
    place_cycles();
    return std::move(items_);
  }

 private:
  /// Holds what begins a path or a cut.
  struct CutItemWalker {
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
      ItemLane& lane = walks.lanes_[number];
      const HalfEdge half = walks.next_[lane.at];
      lane.pass(half.edge);
      if (half.to == kNone || walks.cuts(half.to)) {
        walks.end_stretch(lane, half.to);
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
  struct UncutItemWalker {
    bool start(std::uint32_t number) {
      v = walks.placed_->first_unmarked(v, end);
      if (v == end) return false;
      walks.begin_stretch(number, v++);
      return true;
    }
    bool advance(std::uint32_t number) {
      ItemLane& lane = walks.lanes_[number];
      const HalfEdge half = walks.next_[lane.at];
      lane.pass(half.edge);
      const ItemStretch& stretch = walks.stretches_[lane.stretch];
      if (half.to <= stretch.start) {
        if (half.to == stretch.start) {
          walks.end_stretch(lane, kNone);
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

  /// The smallest vertex of a cycle that is cut, and the stretch that has it.
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
    ItemLane& lane = lanes_[number];
    lane.at = v;
    lane.stretch = static_cast<std::uint32_t>(stretches_.size());
    lane.vertex.begin();
    lane.edge.begin();
    stretches_.emplace_back().start = v;
  }

  void end_stretch(const ItemLane& lane, Vertex then) {
    ItemStretch& stretch = stretches_[lane.stretch];
    stretch.vertex = lane.vertex.data();
    stretch.edge = lane.edge.data();
    stretch.size = static_cast<std::uint32_t>(lane.vertex.size());
    stretch.then = then;
  }

  void place(const ItemStretch& stretch, std::uint32_t from, std::uint32_t to) {
    items_.vertex.insert(items_.vertex.end(), stretch.vertex + from, stretch.vertex + to);
    items_.edge.insert(items_.edge.end(), stretch.edge + from, stretch.edge + to);
  }
  void place(const ItemStretch& stretch) { place(stretch, 0, stretch.size); }
  void end_item() { items_.begin.push_back(static_cast<std::uint32_t>(items_.vertex.size())); }

  void mark_placed(const ItemStretch& stretch) {
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

  /// Returns those that no path has, from their smallest vertices around.
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
        const Vertex low = smallest_in(stretches_[s]);
        cycle = std::min(cycle, CutCycle{low, s});
      }
      if (cycle.first != kNone) cycles.push_back(cycle);
    }
    std::ranges::sort(cycles);
    return cycles;
  }

  static Vertex smallest_in(const ItemStretch& stretch) {
    return *std::min_element(stretch.vertex, stretch.vertex + stretch.size);
  }

  /// From its smallest vertex around.
  void place_cut_cycle(const CutCycle& cycle) {
    const auto [smallest, first] = cycle;
    const ItemStretch& begun = stretches_[first];
    const auto low = static_cast<std::uint32_t>(
        std::find(begun.vertex, begun.vertex + begun.size, smallest) - begun.vertex);
    place(begun, low, begun.size);
    for_others_around(first, [&](const ItemStretch& stretch) { place(stretch); });
    place(begun, 0, low);
    end_item();
  }

  template <class Visit>
  void for_others_around(std::uint32_t first, Visit visit) const {
    for (std::uint32_t s = after(first); s != first; s = after(s)) visit(stretches_[s]);
  }

  /// Walks them. They follow the other stretches, in ascending order of their smallest vertices.
  void walk_uncut_cycles() {
    placed_.emplace(next_.size(), false);
    for (const ItemStretch& stretch : stretches_) mark_placed(stretch);
    for (Vertex v = 0; follows_ && v < num_vertices(); ++v) {
      if (next_[v].to == kNone) placed_->set(v, 0);
    }
    UncutItemWalker walker{*this, num_vertices()};
    walk_in_lanes(walker, sizes_.lanes);
  }

  void place_cycles() {
    const std::vector<CutCycle> cut = cut_cycles();
    std::size_t left = next_.size() - items_.vertex.size();
    for (const auto& [smallest, first] : cut) {
      left -= stretches_[first].size;
      for_others_around(first, [&](const ItemStretch& stretch) { left -= stretch.size; });
    }
    auto uncut = static_cast<std::uint32_t>(stretches_.size());
    if (left > 0) walk_uncut_cycles();
    for (const CutCycle& cycle : cut) {
      place_uncut_below(cycle.first, uncut);
      place_cut_cycle(cycle);
    }
    place_uncut_below(kNone, uncut);
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
  std::vector<ItemLane> lanes_;
  std::vector<std::uint32_t> at_cut_;   ///< the stretch that starts there
  std::vector<ItemStretch> stretches_;  ///< in ascending order of their starts
  Items items_;
};

}  // namespace

Items items(const std::vector<HalfEdge>& next, const WalkSizes& sizes) {
  return ItemWalks(next, sizes).run();
}

Items items(const std::vector<HalfEdge>& next) {
  return next.size() >= kManyInItems ? items(next, walk_sizes(next.size())) : extract_items(next);
}

}  // namespace ar3d::diamond::fast
