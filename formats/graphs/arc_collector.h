#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// Collects the edges of a format that gives them from one or both of their ends: adjacency lists,
/// full matrices, arcs.
class ArcCollector {
 public:
  /// @param base  smallest vertex id of the format, for messages.
  /// @param one_end_will_do  (u, v) needs no (v, u).
  ArcCollector(const TextInput& input, const ReadOptions& options, unsigned base,
               bool one_end_will_do = false)
      : input_(&input),
        simplify_(options.simplify),
        base_(base),
        one_end_will_do_(one_end_will_do) {}

  /// Starts a graph. @param announced  how many arcs the text claims to have.
  void begin(std::uint64_t announced = 0);
  /// True if loops and parallel edges are dropped, not refused.
  bool simplifies() const { return simplify_; }
  /// The vertex u names its neighbour v in a line. @pre u != v unless simplifies().
  void add(Vertex u, Vertex v, std::uint64_t line) {
    constexpr std::uint64_t kLastLine = std::numeric_limits<std::uint32_t>::max();
    const auto short_line = static_cast<std::uint32_t>(std::min(line, kLastLine));
    if (u == v) {
      ++loops_;
    } else if (u < v) {
      forward_.push_back({u, v, short_line});
    } else {
      backward_.push_back({v, u, short_line});
    }
  }
  std::uint64_t num_arcs() const { return forward_.size() + backward_.size() + loops_; }

  /// Calls use(u, v, line) for each arc; u names v.
  template <class Use>
  void for_each(const Use& use) const {
    for (const Arc& arc : forward_) use(arc.small, arc.large, std::uint64_t{arc.line});
    for (const Arc& arc : backward_) use(arc.large, arc.small, std::uint64_t{arc.line});
  }

  /// Ends the graph on n vertices (all ids are below n); its edges (u, v), u < v, are ordered by
  /// (u, v).
  /// @throws InputError on a neighbour named twice from the same end unless simplifies(), or
  /// from one end alone if that will not do, or some from one end and some from both. Cost: O(n + m), and O(m log m) if the rows are not
  /// sorted; arcs that come from both ends, by the vertex that names them, are read in order only.
  /// @param name  the vertex in messages; without it its number in the file.
  Graph finish(std::uint64_t n, std::function<std::string(Vertex)> name = {});

 private:
  struct Arc {
    Vertex small = 0;
    Vertex large = 0;
    std::uint32_t line = 0;  // saturated
  };
  using Arcs = UnwrittenVector<Arc>;
  std::optional<Graph> matched(std::uint64_t n);
  void refuse_repeats(const Arcs& arcs) const;
  static void drop_repeats(Arcs& arcs);
  std::vector<Edge> merged();
  [[noreturn]] void fail(const Arc& arc, bool backward, const char* problem) const;

  const TextInput* input_;
  bool simplify_;
  unsigned base_;
  std::function<std::string(Vertex)> name_;
  bool one_end_will_do_;
  std::uint64_t loops_ = 0;
  Arcs forward_;   // named by the smaller end
  Arcs backward_;  // named by the larger end
};

}  // namespace ar3d
