// Step L.2: the order in which vertices are placed, ear by ear (Whitney 1932), the shortest first,
// because a short ear between two placed vertices has few places in a lattice: a hexagon of the
// diamond lattice with four placed vertices has one. An ear that becomes shorter ends at a vertex
// placed since, and is found from there; so a heap of them needs no update. Cost: see ear_order().
#include <queue>
#include <tuple>

#include "ar3d/algorithms/lattice/embedding.h"

namespace ar3d::lattice {
namespace {

constexpr std::size_t kNearby = 256;  // vertices that the first search for an ear looks at
constexpr std::uint32_t kLong = 1u << 30, kNone = kLong + 1;  // lengths not known, and of no ear

class EarOrder {
 public:
  explicit EarOrder(const Graph& graph)
      : graph_(graph),
        step_(graph.num_vertices(), kNoStep),
        core_degree_(graph.num_vertices()),
        before_(graph.num_vertices()),
        seen_(graph.num_vertices()) {}

  std::vector<EarStep> run() {
    peel_trees();
    Vertex first = 0;
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      if (core_degree_[v] > core_degree_[first]) first = v;
    }
    place(first, kNoStep);
    while (!ears_.empty()) take_next();
    for (std::size_t i = 0; i < order_.size(); ++i) {  // trees, breadth-first
      for (const HalfEdge& half : graph_.incident(order_[i].vertex)) {
        if (step_[half.to] == kNoStep) place(half.to, static_cast<std::uint32_t>(i));
      }
    }
    return std::move(order_);
  }

 private:
  /// Takes vertices of degree 1 away, again and again; core_degree_ is 0 of what is gone.
  void peel_trees() {
    std::vector<Vertex> leaves;
    for (Vertex v = 0; v < graph_.num_vertices(); ++v) {
      core_degree_[v] = graph_.degree(v);
      if (core_degree_[v] == 1) leaves.push_back(v);
    }
    while (!leaves.empty()) {
      const Vertex leaf = leaves.back();
      leaves.pop_back();
      core_degree_[leaf] = 0;
      for (const HalfEdge& half : graph_.incident(leaf)) {
        if (core_degree_[half.to] > 0 && --core_degree_[half.to] == 1) leaves.push_back(half.to);
      }
    }
  }

  bool is_open(Vertex v) const { return core_degree_[v] > 0 && step_[v] == kNoStep; }

  void place(Vertex v, std::uint32_t from, std::uint32_t target = kNoStep, std::uint32_t left = 0) {
    step_[v] = static_cast<std::uint32_t>(order_.size());
    order_.push_back({v, from, target, left});
    if (core_degree_[v] == 0) return;
    for (const HalfEdge& half : graph_.incident(v)) {
      if (is_open(half.to)) push(v, half.to, search(v, half.to, kNearby));
    }
  }

  void push(Vertex from, Vertex to, std::uint32_t length) {
    ears_.emplace(length, pushed_++, from, to);
  }

  void take_next() {
    const auto [length, number, from, to] = ears_.top();
    ears_.pop();
    if (!is_open(to)) return;
    if (length == kNone) return place(to, step_[from]);  // a bridge
    const std::uint32_t now = search(from, to, length == kLong ? graph_.num_vertices() : kNearby);
    if (now > length) return push(from, to, now);
    std::vector<Vertex> ear;
    for (Vertex v = last_; v != from; v = before_[v]) ear.push_back(v);
    std::uint32_t at = step_[from];
    const std::uint32_t target = step_[end_];
    for (std::size_t left = ear.size(); left > 0; --left) {
      place(ear[left - 1], at, target, static_cast<std::uint32_t>(left));
      at = step_[ear[left - 1]];
    }
  }

  /// The number of edges of the shortest ear that begins with this edge; its last open vertex and
  /// its end are kept.
  std::uint32_t search(Vertex from, Vertex to, std::size_t most) {
    ++round_;
    std::vector<std::pair<Vertex, std::uint32_t>> queue = {{to, 1}};
    seen_[to] = round_;
    before_[to] = from;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      if (i == most) return kLong;
      const auto [v, length] = queue[i];
      for (const HalfEdge& half : graph_.incident(v)) {
        if (v == to && half.to == from) continue;
        if (step_[half.to] != kNoStep) {
          last_ = v;
          end_ = half.to;
          return length + 1;
        }
        if (core_degree_[half.to] == 0 || seen_[half.to] == round_) continue;
        seen_[half.to] = round_;
        before_[half.to] = v;
        queue.emplace_back(half.to, length + 1);
      }
    }
    return kNone;
  }

  const Graph& graph_;
  std::vector<EarStep> order_;
  std::vector<std::uint32_t> step_, core_degree_;
  std::vector<Vertex> before_;
  std::vector<std::uint64_t> seen_;
  std::uint64_t round_ = 0, pushed_ = 0;
  Vertex last_ = 0, end_ = 0;
  using Ear = std::tuple<std::uint32_t, std::uint64_t, Vertex, Vertex>;  // length, number, edge
  std::priority_queue<Ear, std::vector<Ear>, std::greater<>> ears_;
};

}  // namespace

std::vector<EarStep> ear_order(const Graph& graph) { return EarOrder(graph).run(); }

}  // namespace ar3d::lattice
