// Two bends at 109.47 degrees, component by component: Steps E.1 to E.4, parts, order along x,
// heights, places. What is tried is exact, so a drawing is right whatever the scale; the scale of
// Lemma E.5, at which no vertex can fail, is the last resort. Cost: that of Step E.4 and of the
// searches of Step E.1.
#include "ar3d/algorithms/two_bend_109/two_bend_109.h"

#include <fmt/format.h>

#include "ar3d/algorithms/efforts.h"
#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/partition.h"
#include "ar3d/algorithms/two_bend_109/slots.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::two_bend_109 {
namespace {

constexpr int kHighestEffort = 1;
constexpr std::int64_t kMostJitter = std::int64_t{1} << 30;  // its square fits 64 bits

/// Draws component by component and collects them side by side.
class SideBySide {
 public:
  explicit SideBySide(const Graph& graph)
      : graph_(graph),
        components_(connected_components_of(graph)),
        order_(graph, find_partition(graph), components_),
        arrangement_(arrange(order_)),
        placement_(graph.num_vertices()),
        bends_(std::size_t{2} * graph.num_edges()) {
    for (const VertexPart& part : order_.parts) ++parts_[static_cast<std::size_t>(part.kind)];
  }

  /// Begins with this jitter in each component, or with the scale that is always enough.
  void add_all(std::optional<std::int64_t> first_jitter) {
    const auto component_of = [&](const VertexPart& part) {
      return components_.of[order_.names[part.vertices[0]]];
    };
    const std::span<const VertexPart> all = order_.parts;
    for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
      while (end < all.size() && component_of(all[end]) == component_of(all[begin])) ++end;
      add(all.subspan(begin, end - begin), first_jitter);
    }
  }

  Drawing finish() const {
    const auto& at = placement_.at;
    Coordinates vertices(at.size(), largest_);
    for (Vertex v = 0; v < at.size(); ++v) vertices.set(order_.names[v], at[v]);
    auto bends = std::make_shared<StoredBends>();
    bends->reserve(graph_.num_edges(), bends_.size());
    std::vector<Point> two(2);
    for (std::size_t bend = 0; bend < bends_.size(); bend += 2) {
      two[0] = bends_[bend];
      two[1] = bends_[bend + 1];
      bends->add_edge(two);
    }
    Drawing drawing{"two-bend-109", kAxisLattice, std::move(vertices), graph_.shared_edges(),
                    std::move(bends)};
    if (!at.empty()) drawing.instance_bound = {bound_[0] - 1, bound_[1], bound_[2]};
    drawing.counters = {{"components", components_.count},
                        {"singles", parts_[0]},
                        {"cycles", parts_[1]},
                        {"bodies", parts_[2]},
                        {"slots", static_cast<std::int64_t>(arrangement_.kind.size())},
                        {"jitter", jitter_},
                        {"tried", placement_.tried}};
    return drawing;
  }

 private:
  void add(std::span<const VertexPart> parts, std::optional<std::int64_t> first_jitter) {
    const Vertex begin = parts.front().vertices.front(), end = parts.back().vertices.back() + 1;
    const Vertex size = end - begin;
    const std::uint64_t seed = mix_seed(size, (order_.offsets[end] - order_.offsets[begin]) / 2);
    const std::uint32_t slot = layout_.end_slot;
    const LayoutScale enough = LayoutScale::always_enough(size);
    LayoutScale scale = first_jitter ? LayoutScale{*first_jitter} : enough;
    for (;; scale = scale.next(size)) {
      layout_ = lay_out(order_, parts, arrangement_, scale, slot, std::move(layout_));
      const auto jitter = static_cast<std::uint64_t>(scale.jitter);
      if (place(order_, parts, arrangement_, layout_, mix_seed(seed, jitter), placement_)) break;
      expect(scale.jitter < enough.jitter, "there are more points than closed ones");
    }
    jitter_ = std::max(jitter_, scale.jitter);
    add(begin, end);
  }

  /// Adds what is drawn of these vertices, and to the bound the extents of that over all choices of
  /// all vertices in their squares: a bend moves with its vertex.
  void add(Vertex begin, Vertex end) {
    GrowingBox box, of_choices;
    for (Vertex v = begin; v < end; ++v) {
      const bool in_body = arrangement_.slot[v] == SlotList::kNone;
      const std::int64_t most = (in_body ? layout_.scale.body_jitter : layout_.scale.jitter) - 1;
      const Vector to_place = layout_.position[v] - placement_.at[v];
      const auto add = [&](Point p) {
        box.add(p);
        of_choices.add(p + to_place);
        of_choices.add(p + to_place + Vector{most, most, 0});
      };
      add(placement_.at[v]);
      for (std::size_t i = 0; i < order_.degree(v); ++i) add(placement_.ends[v][i]);
    }
    const Vector bound = of_choices.high() - of_choices.low(), size = box.high() - box.low();
    bound_[0] += bound.x + 1;
    bound_[1] = std::max(bound_[1], bound.y);
    bound_[2] = std::max(bound_[2], bound.z);
    const Vector shift{next_x_ - box.low().x, -box.low().y, -box.low().z};
    for (Vertex v = begin; v < end; ++v) {
      placement_.at[v] = placement_.at[v] + shift;
      const auto incident = order_.incident(v);
      for (std::size_t i = 0; i < incident.size(); ++i) {
        bends_[incident[i].edge] = placement_.ends[v][i] + shift;
      }
    }
    next_x_ += size.x + 1;
    expect(next_x_ <= kMaxCoordinate, "x fits");
    largest_ = std::max({largest_, next_x_, size.y, size.z});
  }

  const Graph& graph_;
  Components components_;
  OrderedGraph order_;
  SlotArrangement arrangement_;
  Layout layout_;
  Placement placement_;
  UnwrittenVector<Point> bends_;  ///< two of each edge
  std::int64_t next_x_ = 0;
  std::int64_t largest_ = 1;
  std::array<std::int64_t, 3> bound_{}, parts_{};  ///< parts by kind
  std::int64_t jitter_ = 0;
};

Drawing draw_alone(const Graph& graph, const Options& options) {
  SideBySide output(graph);
  output.add_all(options.effort == 0 ? std::nullopt : std::optional(options.first_jitter));
  return output.finish();
}

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  check_effort("two-bend-109", options.effort, kHighestEffort);
  refuse_larger_degrees("two-bend-109", graph, 4);
  if (options.first_jitter < 1 || options.first_jitter > kMostJitter ||
      !std::has_single_bit(static_cast<std::uint64_t>(options.first_jitter))) {
    throw InputError(fmt::format("two-bend-109: a jitter is a power of 2 up to 2^30, not {}",
                                 options.first_jitter));
  }
  return smallest_of_efforts(graph, options, draw_alone);
}

Algorithm row() {
  return {
      .name = "two-bend-109",
      .summary =
          "degree at most 4, at most 2 bends per edge, angles of at least 109.47 degrees, in a box "
          "of O(n^2) x O(n) x O(n^3)",
      .source = "the paper's second open question",
      .guarantee = {.max_degree = 4,
                    .max_bends = 2,
                    .angle_rule = AngleRule::at_least,
                    .cosine = {-1, 3},
                    .lattice = kAxisLattice,
                    .directions = {},
                    .bound = {"proved here",
                              "docs/two-bend-109.md",
                              {quadratic(640) + 220000, linear(240) + 38000,
                               cubic(5000) + 220000000}},
                    .published = {}},
      .options = {effort_option(
          kHighestEffort,
          "0: the scale of the size bound's proof; 1: the smallest of ever larger ones that does")},
      .draw = draw_with_effort<draw>};
}

}  // namespace ar3d::two_bend_109
