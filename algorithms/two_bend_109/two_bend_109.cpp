// Two bends at 109.47 degrees, component by component: Steps E.1 to E.4, parts, order along x,
// heights, places. What is tried is exact, so a drawing is right whatever the scale; the scale of
// Lemma E.5, at which no vertex can fail, is the last resort. Cost: that of Step E.4 and of the
// searches of Step E.1.
#include "ar3d/algorithms/two_bend_109/two_bend_109.h"

#include <fmt/format.h>

#include <numeric>

#include "ar3d/algorithms/two_bend_109/layout.h"
#include "ar3d/algorithms/two_bend_109/partition.h"
#include "ar3d/algorithms/two_bend_109/placement.h"
#include "ar3d/algorithms/two_bend_109/slots.h"
#include "ar3d/base/error.h"
#include "ar3d/base/random.h"

namespace ar3d::two_bend_109 {
namespace {

constexpr int kHighestEffort = 1;
constexpr std::int64_t kMostJitter = std::int64_t{1} << 30;  // its square fits 64 bits

/// Component after component, in each in the order that they have.
std::vector<VertexPart> by_component(std::vector<VertexPart> parts, const Components& components) {
  if (components.count <= 1) return parts;
  const auto of = [&](const VertexPart& part) { return components.of[part.vertices[0]]; };
  std::vector<std::size_t> next(components.count + 1);
  for (const VertexPart& part : parts) ++next[of(part) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<VertexPart> sorted(parts.size());
  for (VertexPart& part : parts) sorted[next[of(part)]++] = std::move(part);
  return sorted;
}

/// Draws component by component and collects them side by side.
class SideBySide {
 public:
  explicit SideBySide(const Graph& graph)
      : graph_(graph),
        found_(connected_components_of(graph)),
        all_parts_(by_component(find_partition(graph), found_)),
        arrangement_(arrange(graph, all_parts_)),
        names_(graph.num_vertices()),
        placement_(graph.num_vertices()) {
    for (const VertexPart& part : all_parts_) ++parts_[static_cast<std::size_t>(part.kind)];
  }

  /// Begins with this jitter in each component, or with the scale that is always enough.
  void add_all(std::optional<std::int64_t> first_jitter) {
    std::vector<std::size_t> end(found_.count + 1);
    for (const std::uint32_t component : found_.of) ++end[component + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    const std::vector<std::size_t> begin = end;
    std::vector<Vertex> vertices(graph_.num_vertices());  // by component
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      std::size_t& place = end[found_.of[v]];
      names_[v] = static_cast<Vertex>(place - begin[found_.of[v]]);
      vertices[place++] = v;
    }
    std::span<const VertexPart> rest = all_parts_;
    for (std::size_t i = 0; i < found_.count; ++i) {
      std::size_t count = 0, seen = begin[i];
      while (seen < begin[i + 1]) seen += rest[count++].vertices.size();
      add(rest.first(count), {&vertices[begin[i]], begin[i + 1] - begin[i]}, first_jitter);
      rest = rest.subspan(count);
    }
  }

  Drawing finish() const {
    const Vertex n = graph_.num_vertices();
    Coordinates vertices(n, largest_);
    auto bends = std::make_shared<StoredBends>();
    bends->reserve(graph_.num_edges(), std::size_t{2} * graph_.num_edges());
    std::vector<Point> two(2);
    std::vector<std::uint8_t> met(n);  // smaller neighbours, which come first
    for (Vertex v = 0; v < n; ++v) {
      vertices.set(v, placement_.at[v]);
      for (std::size_t i = met[v]; i < graph_.degree(v); ++i) {
        const Vertex to = graph_.incident(v)[i].to;
        two[0] = placement_.ends[v][i];
        two[1] = placement_.ends[to][met[to]++];
        bends->add_edge(two);
      }
    }
    Drawing drawing{"two-bend-109", kAxisLattice, std::move(vertices), graph_.shared_edges(),
                    std::move(bends)};
    if (n > 0) drawing.instance_bound = {bound_[0] - 1, bound_[1], bound_[2]};
    drawing.counters = {{"components", found_.count},
                        {"singles", parts_[0]},
                        {"cycles", parts_[1]},
                        {"bodies", parts_[2]},
                        {"slots", static_cast<std::int64_t>(arrangement_.kind.size())},
                        {"jitter", jitter_},
                        {"tried", placement_.tried}};
    return drawing;
  }

 private:
  void add(std::span<const VertexPart> parts, std::span<const Vertex> vertices,
           std::optional<std::int64_t> first_jitter) {
    std::uint64_t half_edges = 0;
    for (const Vertex v : vertices) half_edges += graph_.degree(v);
    const std::uint64_t seed = mix_seed(vertices.size(), half_edges / 2);
    const std::uint32_t slot = layout_.end_slot;
    const LayoutScale enough = LayoutScale::always_enough(vertices.size());
    LayoutScale scale = first_jitter ? LayoutScale{*first_jitter} : enough;
    for (;; scale = scale.next(vertices.size())) {
      layout_ = lay_out(graph_, parts, arrangement_, scale, slot, std::move(layout_));
      const auto jitter = static_cast<std::uint64_t>(scale.jitter);
      if (place(graph_, parts, arrangement_, layout_, mix_seed(seed, jitter), names_, placement_)) {
        break;
      }
      expect(scale.jitter < enough.jitter, "there are more points than closed ones");
    }
    jitter_ = std::max(jitter_, scale.jitter);
    add_bound(vertices);
    add(vertices);
  }

  /// Adds the extents of what is drawn over all choices of all vertices in their squares
  /// (instance_bound): a bend moves with its vertex.
  void add_bound(std::span<const Vertex> vertices) {
    GrowingBox box;
    for (const Vertex v : vertices) {
      const bool in_body = arrangement_.slot[v] == SlotList::kNone;
      const std::int64_t most = (in_body ? layout_.scale.body_jitter : layout_.scale.jitter) - 1;
      const auto add = [&](Point p) {
        box.add(p);
        box.add(p + Vector{most, most, 0});
      };
      add(layout_.place[v]);
      for (std::size_t i = 0; i < graph_.degree(v); ++i) {
        add(layout_.place[v] + (placement_.ends[v][i] - placement_.at[v]));
      }
    }
    const Point low = box.low(), high = box.high();
    bound_[0] += high.x - low.x + 1;
    bound_[1] = std::max(bound_[1], high.y - low.y);
    bound_[2] = std::max(bound_[2], high.z - low.z);
  }

  void add(std::span<const Vertex> vertices) {
    GrowingBox box;
    for (const Vertex v : vertices) {
      box.add(placement_.at[v]);
      for (std::size_t i = 0; i < graph_.degree(v); ++i) box.add(placement_.ends[v][i]);
    }
    const Point low = box.low();
    const Vector shift{next_x_ - low.x, -low.y, -low.z};
    for (const Vertex v : vertices) {
      placement_.at[v] = placement_.at[v] + shift;
      for (Point& end : placement_.ends[v]) end = end + shift;
    }
    next_x_ += box.high().x - low.x + 1;
    expect(next_x_ <= kMaxCoordinate, "x fits");
    largest_ = std::max({largest_, next_x_, box.high().y - low.y, box.high().z - low.z});
  }

  const Graph& graph_;
  Components found_;
  std::vector<VertexPart> all_parts_;
  SlotArrangement arrangement_;
  std::vector<Vertex> names_;  ///< of the vertices within their components
  Layout layout_;
  Placement placement_;
  std::int64_t next_x_ = 0;
  std::int64_t largest_ = 1;
  std::array<std::int64_t, 3> bound_{}, parts_{};  ///< parts by kind
  std::int64_t jitter_ = 0;
};

}  // namespace

Drawing draw(const Graph& graph, const Options& options) {
  check_effort("two-bend-109", options.effort, kHighestEffort);
  refuse_larger_degrees("two-bend-109", graph, 4);
  if (options.first_jitter < 1 || options.first_jitter > kMostJitter ||
      !std::has_single_bit(static_cast<std::uint64_t>(options.first_jitter))) {
    throw InputError(fmt::format("two-bend-109: a jitter is a power of 2 up to 2^30, not {}",
                                 options.first_jitter));
  }
  SideBySide output(graph);
  output.add_all(options.effort == 0 ? std::nullopt : std::optional(options.first_jitter));
  return output.finish();
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
