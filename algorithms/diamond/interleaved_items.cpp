// Step 1.2 for large graphs. As in interleaved_colouring.cpp the paths and cycles are cut at every
// so many-th vertex and the stretches walked in turns; then they are copied in the order in which
// the plain walk finds them. O(n).
#include <algorithm>
#include <utility>

#include "ar3d/algorithms/diamond/interleaved.h"
#include "ar3d/model/long_vector.h"

namespace ar3d::diamond {
namespace {

class ItemWalks {
 public:
  ItemWalks(const std::vector<HalfEdge>& next, const WalkSizes& sizes)
      : next_(next),
        sizes_(sizes),
        begins_path_(next.size(), 1),
        placed_(next.size(), 0),
        lanes_(sizes.lanes),
        at_cut_(next.size() / sizes.stride + 1, kNone) {
    for (const HalfEdge& half : next) {
      if (half.to != kNone) begins_path_[half.to] = 0;
    }
    for (Lane& lane : lanes_) lane.passed.reserve(next.size() / sizes.lanes + 1024);
    reserve_long(items_.vertex, next.size());
    reserve_long(items_.edge, next.size());
  }

  Items run() {
    walk_in_lanes(*this, sizes_.lanes);
    place_paths();
    place_cycles();
    return std::move(items_);
  }

  // For walk_in_lanes.
  bool start(std::uint32_t number) {
    while (next_start_ < next_.size() && !begins_path_[next_start_] && !cuts(next_start_)) {
      ++next_start_;
    }
    if (next_start_ == next_.size()) return false;
    const Vertex v = next_start_++;
    Lane& lane = lanes_[number];
    lane.at = v;
    lane.stretch = static_cast<std::uint32_t>(stretches_.size());
    if (cuts(v)) at_cut_[v / sizes_.stride] = lane.stretch;
    stretches_.push_back({v, v, number, lane.passed.size(), 0, 0, kNone});
    return true;
  }

  bool advance(std::uint32_t number) {
    Lane& lane = lanes_[number];
    Stretch& stretch = stretches_[lane.stretch];
    const HalfEdge half = next_[lane.at];
    if (lane.at < stretch.lowest) {
      stretch.lowest = lane.at;
      stretch.low_place = stretch.size;
    }
    lane.passed.push_back({lane.at, half.edge});
    ++stretch.size;
    if (half.to == kNone || cuts(half.to)) {
      stretch.then = half.to;
      return false;
    }
    lane.at = half.to;
    __builtin_prefetch(&next_[lane.at]);
    return true;
  }

 private:
  struct Stretch {
    Vertex start;
    Vertex lowest;  ///< vertex
    std::uint32_t lane;
    std::size_t begin;  ///< among what the lane has passed
    std::uint32_t size;
    std::uint32_t low_place;  ///< of the lowest vertex in it
    Vertex then;              ///< where the next one starts, or kNone
  };
  struct Lane {
    Vertex at = 0;
    std::uint32_t stretch = 0;
    std::vector<HalfEdge> passed;  ///< a vertex and the edge by which it is left
  };
  /// A cycle that is cut: its smallest vertex, and the stretch with it.
  using CutCycle = std::pair<Vertex, std::uint32_t>;

  bool cuts(Vertex v) const { return (v & (sizes_.stride - 1)) == 0; }
  std::uint32_t after(std::uint32_t stretch) const {
    return at_cut_[stretches_[stretch].then / sizes_.stride];
  }

  void place(const Stretch& stretch, std::uint32_t from, std::uint32_t to) {
    const HalfEdge* passed = lanes_[stretch.lane].passed.data() + stretch.begin;
    for (std::uint32_t i = from; i < to; ++i) place(passed[i]);
  }
  void place(HalfEdge passed) {
    placed_[passed.to] = 1;
    items_.vertex.push_back(passed.to);
    items_.edge.push_back(passed.edge);
  }
  void end_item() { items_.begin.push_back(static_cast<std::uint32_t>(items_.vertex.size())); }

  /// Stretches are numbered by their starts, so the paths come by their first vertices.
  void place_paths() {
    for (std::uint32_t i = 0; i < stretches_.size(); ++i) {
      if (!begins_path_[stretches_[i].start]) continue;
      std::uint32_t stretch = i;
      place(stretches_[stretch], 0, stretches_[stretch].size);
      while (stretches_[stretch].then != kNone) {
        stretch = after(stretch);
        place(stretches_[stretch], 0, stretches_[stretch].size);
      }
      end_item();
    }
  }

  std::vector<CutCycle> cut_cycles() const {
    std::vector<CutCycle> cycles;
    std::vector<std::uint8_t> seen(stretches_.size(), 0);
    for (std::uint32_t i = 0; i < stretches_.size(); ++i) {
      if (seen[i] || placed_[stretches_[i].start]) continue;
      CutCycle cycle{kNone, 0};
      for (std::uint32_t s = i; !seen[s]; s = after(s)) {
        seen[s] = 1;
        cycle = std::min(cycle, CutCycle{stretches_[s].lowest, s});
      }
      cycles.push_back(cycle);
    }
    std::sort(cycles.begin(), cycles.end());
    return cycles;
  }

  /// From its smallest vertex around.
  void place_cut_cycle(std::uint32_t first) {
    const Stretch& begun = stretches_[first];
    place(begun, begun.low_place, begun.size);
    for (std::uint32_t s = after(first); s != first; s = after(s)) {
      place(stretches_[s], 0, stretches_[s].size);
    }
    place(begun, 0, begun.low_place);
    end_item();
  }

  void place_cycles() {
    const auto cycles = cut_cycles();
    auto cut = cycles.begin();
    for (Vertex v = 0; v < next_.size(); ++v) {
      if (placed_[v]) continue;
      if (cut != cycles.end() && cut->first == v) {
        place_cut_cycle((cut++)->second);
        continue;
      }
      Vertex at = v;  // a cycle without a cut
      do {
        place({at, next_[at].edge});
        at = next_[at].to;
      } while (at != v);
      end_item();
    }
  }

  const std::vector<HalfEdge>& next_;
  const WalkSizes sizes_;
  std::vector<std::uint8_t> begins_path_;
  std::vector<std::uint8_t> placed_;
  std::vector<Lane> lanes_;
  std::vector<std::uint32_t> at_cut_;  ///< the stretch that starts there
  std::vector<Stretch> stretches_;     ///< in ascending order of their starts
  Vertex next_start_ = 0;
  Items items_;
};

}  // namespace

Items interleaved_items(const std::vector<HalfEdge>& next, const WalkSizes& sizes) {
  return ItemWalks(next, sizes).run();
}

}  // namespace ar3d::diamond
