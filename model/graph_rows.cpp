#include "ar3d/model/graph_rows.h"

#include <algorithm>
#include <utility>
#include <vector>

// Counting sort. The edges are cut into one part a thread; a counter for each part and vertex first
// counts the ends of the part's edges at the vertex, then names the end of the part's place in the
// vertex's row. The parts are filled from their last edge to their first, so every counter ends at
// the first of its places, and those of part 0 are the rows' offsets.
namespace ar3d {
namespace {

class RowBuilder {
 public:
  RowBuilder(std::uint64_t n, std::span<const Edge> edges)
      : n_(n), edges_(edges), parts_(static_cast<std::uint64_t>(threads_for(edges.size()))) {
    rows_.offsets.resize(n + 1);
    rows_.offsets[n] = static_cast<std::uint32_t>(2 * edges.size());
    rows_.half_edges.resize(2 * edges.size());
    counters_.push_back(rows_.offsets.data());
    more_counters_.resize(parts_ - 1);
    for (auto& counters : more_counters_) {
      counters.resize(n);
      counters_.push_back(counters.data());
    }
  }

  Rows build() && {
    std::vector<std::uint32_t> ends(parts_);  // of the edges in each range of vertices
    for_each_part([&](std::uint64_t part) { count(part); });
    for_each_part([&](std::uint64_t range) { ends[range] = add_up(range); });
    std::uint32_t place = 0;
    for (std::uint32_t& entry : ends) place += std::exchange(entry, place);
    for_each_part([&](std::uint64_t range) { turn_into_places(range, ends[range]); });
    for_each_part([&](std::uint64_t part) { fill(part); });
    for (Vertex v = 0; v < n_; ++v) {
      rows_.max_degree = std::max(rows_.max_degree, rows_.offsets[v + 1] - rows_.offsets[v]);
    }
    return std::move(rows_);
  }

 private:
  template <class Work>
  void for_each_part(Work work) const {
    const int threads = static_cast<int>(parts_);
#pragma omp parallel for schedule(static, 1) num_threads(threads)
    for (std::uint64_t part = 0; part < parts_; ++part) work(part);
  }
  std::uint64_t first_edge(std::uint64_t part) const { return edges_.size() * part / parts_; }
  std::uint64_t first_vertex(std::uint64_t range) const { return n_ * range / parts_; }

  void count(std::uint64_t part) {
    std::uint32_t* const counters = counters_[part];
    std::fill(counters, counters + n_, 0u);
    for (std::uint64_t e = first_edge(part); e < first_edge(part + 1); ++e) {
      ++counters[edges_[e].u];
      ++counters[edges_[e].v];
    }
  }
  std::uint32_t add_up(std::uint64_t range) const {
    std::uint32_t ends = 0;
    for (const std::uint32_t* const counters : counters_) {
      for (auto v = first_vertex(range); v < first_vertex(range + 1); ++v) ends += counters[v];
    }
    return ends;
  }
  void turn_into_places(std::uint64_t range, std::uint32_t place) {
    for (auto v = first_vertex(range); v < first_vertex(range + 1); ++v) {
      for (std::uint32_t* const counters : counters_) place = counters[v] += place;
    }
  }
  void fill(std::uint64_t part) {
    constexpr std::uint64_t kAhead = 32;  // edges; hides the way to memory
    std::uint32_t* const counters = counters_[part];
    HalfEdge* const half_edges = rows_.half_edges.data();
    const std::uint64_t begin = first_edge(part);
    for (std::uint64_t e = first_edge(part + 1); e-- > begin;) {
      if (e >= begin + 2 * kAhead) {
        const Edge far = edges_[e - 2 * kAhead];
        const Edge near = edges_[e - kAhead];
        __builtin_prefetch(&counters[far.u], 1);
        __builtin_prefetch(&counters[far.v], 1);
        __builtin_prefetch(half_edges + counters[near.u] - 1, 1);
        __builtin_prefetch(half_edges + counters[near.v] - 1, 1);
      }
      const auto [u, v] = edges_[e];
      half_edges[--counters[u]] = {v, static_cast<EdgeId>(e)};
      half_edges[--counters[v]] = {u, static_cast<EdgeId>(e)};
    }
  }

  std::uint64_t n_;
  std::span<const Edge> edges_;
  std::uint64_t parts_;
  Rows rows_;
  std::vector<UnwrittenVector<std::uint32_t>> more_counters_;
  std::vector<std::uint32_t*> counters_;  // n of them for each part
};

}  // namespace

Rows rows_of(std::uint64_t n, std::span<const Edge> edges) { return RowBuilder(n, edges).build(); }

}  // namespace ar3d
