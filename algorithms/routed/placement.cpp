// Step R.2, the placement: simulated annealing (Kirkpatrick, Gelatt and Vecchi 1983) that swaps
// vertices on a grid of cells. A proposal is a cell near the median of the neighbours, three times
// out of four. Lengths, temperatures and chances are integers, so every platform draws the same.
// Cost: O(degree) for a proposal.
#include "ar3d/algorithms/routed/placement.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

namespace ar3d::routed {
namespace {

constexpr std::uint32_t kEmpty = 0xffffffff;
constexpr int kUnit = 4096;  // length of a side of the whole grid
constexpr int kStages = 128;

/// The exponential distribution in 1/1024: -ln((i + 1) / 4096).
std::vector<std::int32_t> exponential_table() {
  constexpr std::int64_t kOne = std::int64_t{1} << 40;
  std::vector<std::int32_t> table(4096);
  std::int64_t sum = 0;
  for (std::int64_t i = 4095; i > 0; --i) {
    const std::int64_t t = kOne / (2 * i + 1);  // ln((i + 1) / i) = 2 (t + t^3 / 3 + t^5 / 5 ...)
    std::int64_t power = t;
    for (std::int64_t k = 1; k < 60 && power > 0; k += 2) {
      sum += 2 * power / k;
      power = power / (2 * i + 1) / (2 * i + 1);
    }
    table[static_cast<std::size_t>(i - 1)] = static_cast<std::int32_t>(sum >> 30);
  }
  return table;
}

class Annealing {
 public:
  Annealing(const Graph& graph, Spot cells, RandomStream random)
      : graph_(graph), cells_(cells), random_(random), exponential_(exponential_table()) {
    const auto count = static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y) *
                       static_cast<std::size_t>(cells.z);
    spots_.resize(count);
    lengths_.resize(count);
    for (int z = 0, i = 0; z < cells.z; ++z) {
      for (int y = 0; y < cells.y; ++y) {
        for (int x = 0; x < cells.x; ++x, ++i) {
          spots_[static_cast<std::size_t>(i)] = {x, y, z};
          lengths_[static_cast<std::size_t>(i)] = length({x, y, z});
        }
      }
    }
    at_.resize(count);
    std::iota(at_.begin(), at_.end(), 0u);
    random_.shuffle(std::span(at_));
    of_.resize(graph.num_vertices());
    for (std::uint32_t i = 0; i < count; ++i) {
      if (at_[i] < graph.num_vertices()) {
        of_[at_[i]] = i;
      } else {
        at_[i] = kEmpty;
      }
    }
  }

  void run(std::uint64_t steps) {
    temperature_ = (kUnit * 15 / 100) << 10;
    for (int stage = 0; stage < kStages; ++stage) {
      for (std::uint64_t i = 0; i < steps / kStages; ++i) propose((i & 3) != 0);
      temperature_ = temperature_ * 31 / 32;
    }
  }

  std::vector<Spot> result() const {
    std::vector<Spot> result;
    for (const std::uint32_t cell : of_) result.push_back(spots_[cell]);
    return result;
  }

 private:
  /// How long an edge is in a cube of side kUnit: steps, a little for crowding, and long ones more.
  int length(Spot d) const {
    const int x = kUnit * d.x / cells_.x;
    const int y = kUnit * d.y / cells_.y;
    const int z = kUnit * d.z / cells_.z;
    const int largest = std::max({x, y, z});
    return largest + (x + y + z) / 10 + largest * largest / kUnit * 3 / 10;
  }

  std::uint32_t cell(Spot p) const {
    return static_cast<std::uint32_t>(p.x + cells_.x * (p.y + cells_.y * p.z));
  }

  int between(std::uint32_t a, std::uint32_t b) const {
    const Spot d = spots_[a] - spots_[b];
    return lengths_[cell({std::abs(d.x), std::abs(d.y), std::abs(d.z)})];
  }

  /// Edges of v if it were in that cell, and `other` in `of_other`.
  int cost(Vertex v, std::uint32_t cell, Vertex other, std::uint32_t of_other) const {
    int total = 0;
    for (const HalfEdge& half : graph_.incident(v)) {
      total += between(cell, half.to == other ? of_other : of_[half.to]);
    }
    return total;
  }

  std::uint32_t cell_near_neighbours(Vertex v) {
    const auto edges = graph_.incident(v);
    std::array<std::array<int, 4>, 3> of;  // no vertex has more neighbours
    for (std::array<int, 4>& list : of) list.fill(std::numeric_limits<int>::max());
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const Spot p = spots_[of_[edges[k].to]];
      of[0][k] = p.x;
      of[1][k] = p.y;
      of[2][k] = p.z;
    }
    const int side = std::max({cells_.x, cells_.y, cells_.z});
    const std::int64_t reach = std::min<std::int64_t>(temperature_ * 3 >> 10, kUnit * 45 / 100);
    const int radius = 1 + static_cast<int>(side * reach / kUnit);
    const std::array<int, 3> sides = {cells_.x, cells_.y, cells_.z};
    std::array<int, 3> p{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::ranges::sort(of[axis]);
      const int median = (of[axis][(edges.size() - 1) / 2] + of[axis][edges.size() / 2]) / 2;
      const int shift = static_cast<int>(random_.below(static_cast<std::uint32_t>(2 * radius + 1)));
      p[axis] = std::clamp(median + shift - radius, 0, sides[axis] - 1);
    }
    return cell({p[0], p[1], p[2]});
  }

  void propose(bool near_neighbours) {
    const Vertex v = random_.below(static_cast<std::uint32_t>(of_.size()));
    const std::uint32_t from = of_[v];
    const std::uint32_t to = near_neighbours && graph_.degree(v) > 0
                                 ? cell_near_neighbours(v)
                                 : random_.below(static_cast<std::uint32_t>(at_.size()));
    if (to == from) return;
    const std::uint32_t w = at_[to];
    int change = cost(v, to, w, from) - cost(v, from, kEmpty, 0);
    if (w != kEmpty) change += cost(w, from, v, to) - cost(w, to, kEmpty, 0);
    if (change > 0 && change > (temperature_ * exponential_[random_.next32() >> 20]) >> 20) return;
    at_[to] = v;
    at_[from] = w;
    of_[v] = to;
    if (w != kEmpty) of_[w] = from;
  }

  const Graph& graph_;
  Spot cells_;
  RandomStream random_;
  std::vector<std::int32_t> exponential_;
  std::vector<Spot> spots_;        // of a cell
  std::vector<int> lengths_;       // by difference
  std::vector<std::uint32_t> at_;  // vertex in a cell
  std::vector<std::uint32_t> of_;  // cell of a vertex
  std::int64_t temperature_ = 0;   // in 1/1024 of lengths
};

}  // namespace

Placement place(const Graph& graph, std::uint64_t steps_per_vertex, RandomStream random) {
  const auto n = static_cast<std::int64_t>(graph.num_vertices());
  Spot cells = {1, 1, 1};
  while (std::int64_t{cells.x} * cells.y * cells.z < n) {
    int& shortest = cells.z <= cells.y && cells.z <= cells.x ? cells.z
                    : cells.y <= cells.x                     ? cells.y
                                                             : cells.x;
    ++shortest;
  }
  Annealing annealing(graph, cells, random);
  if (graph.num_edges() > 0) {
    annealing.run(steps_per_vertex * graph.num_vertices());
  }
  return {cells, annealing.result()};
}

}  // namespace ar3d::routed
