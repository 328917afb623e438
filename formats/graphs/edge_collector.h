#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "ar3d/formats/graphs/graph_format.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {

/// Collects the edges of a format that gives one edge per line, and remembers where each of them
/// stands.
class EdgeCollector {
 public:
  /// @param base  smallest vertex id of the format.
  EdgeCollector(const TextInput& input, const ReadOptions& options, unsigned base)
      : input_(&input), options_(options), base_(base) {}

  /// Starts a graph. @param n  number of vertices if the file states it.
  void begin(std::optional<std::uint64_t> n);
  /// Starts a graph whose smallest id is another one.
  void begin(std::optional<std::uint64_t> n, unsigned base) {
    base_ = base;
    begin(n);
  }
  /// Makes room for the edges announced, as far as the rest of the text can hold them.
  void expect_edges(std::uint64_t announced);
  /// Reads the two ends of an edge. @throws InputError on a bad id, or a loop if they are refused.
  void read_edge(Tokens& tokens);
  /// An id of the file as a vertex. @throws InputError if it is out of range.
  Vertex read_vertex(Tokens& tokens);
  Vertex vertex_of(std::uint64_t id, std::size_t column);
  void add(Vertex u, Vertex v);
  /// Reads and adds plain lines of one edge each (read_plain_pairs) behind `before`, at most
  /// `most`.
  /// @return their number.
  std::uint64_t read_plain_edges(TextInput& input, std::string_view before, std::uint64_t most);
  /// True if u and v are ids in range and differ (or loops are dropped); notes the largest and its
  /// line.
  bool accepts(std::uint64_t u, std::uint64_t v, std::uint64_t line) {
    if (u - base_ >= limit_ || v - base_ >= limit_ || (u == v && !options_.simplify)) return false;
    range_.smallest = std::min({range_.smallest, u - base_, v - base_});
    const std::uint64_t end = std::max(u, v) - base_ + 1;
    if (end > range_.end) {
      range_.end = end;
      range_.line = line;
    }
    return true;
  }

  /// Reads the two ends of an edge without collecting it. @throws InputError as read_edge.
  Edge read_ends(Tokens& tokens);
  /// The number of vertices: as begun, or up to the largest id.
  /// @throws InputError if it is more than the text accounts for.
  std::uint64_t checked_n() const;

  std::uint64_t num_edges() const { return edges_.size(); }
  const std::vector<Edge>& edges() const { return edges_; }
  /// The line of that edge.
  std::uint64_t line_of(std::uint64_t edge) const;
  /// Says which vertices the edges name, as far as they have been read since the last begin() or
  /// forget_range().
  struct Range {
    std::uint64_t smallest = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t end = 0;   ///< the largest + 1
    std::uint64_t line = 0;  ///< where that stands
  };
  const Range& range() const { return range_; }
  void forget_range() { range_ = {}; }
  void note(const Range& other);
  /// The number of vertices that the edges name. O(m + largest id) time.
  std::uint64_t num_named() const;
  /// From here on there are n vertices, the smallest id is `base`; the edges read so far have been
  /// numbered from the old one, which is at most that.
  void settle(std::uint64_t n, unsigned base);
  /// The first line read was no edge. O(m) time.
  void drop_first_edge();
  /// Ends the graph; without a known n it has the vertices up to the largest id.
  /// @throws InputError on parallel edges, or on more vertices than the text accounts for.
  Graph finish();

 private:
  /// From edge `first` on, edge e stands in line e + line - first, until the next entry.
  struct Run {
    std::uint64_t first = 0;
    std::uint64_t line = 0;
  };
  void reserve_for_the_rest();

  const TextInput* input_;
  ReadOptions options_;  // a copy: the caller's may be a temporary
  unsigned base_;
  std::optional<std::uint64_t> known_n_;
  std::uint64_t limit_ = 0;  // ids are below this
  Range range_;
  std::uint64_t first_byte_ = 0;  // of the graph's text
  std::uint64_t header_line_ = 0;
  std::vector<Edge> edges_;
  std::vector<Run> runs_;
};

}  // namespace ar3d
