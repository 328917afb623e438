#pragma once

#include <algorithm>
#include <cstdint>
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

  /// Starts a graph. @param n  number of vertices where the file tells it.
  void begin(std::optional<std::uint64_t> n);
  /// Makes room for the edges announced, as far as the rest of the text can hold them.
  void expect_edges(std::uint64_t announced);
  /// Reads the two ends of an edge. @throws InputError on a bad id, or a loop if they are refused.
  void read_edge(Tokens& tokens);
  /// An id of the file as a vertex. @throws InputError if it is out of range.
  Vertex read_vertex(Tokens& tokens);
  void add(Vertex u, Vertex v);
  /// Reads and adds plain lines of one edge each (read_plain_pairs) behind `before`, at most
  /// `most`.
  /// @return their number.
  std::uint64_t read_plain_edges(TextInput& input, std::string_view before, std::uint64_t most);
  /// True if u and v are ids in range and differ (or loops are dropped); notes the largest and its
  /// line.
  bool accepts(std::uint64_t u, std::uint64_t v, std::uint64_t line) {
    if (u - base_ >= limit_ || v - base_ >= limit_ || (u == v && !options_.simplify)) return false;
    const std::uint64_t end = std::max(u, v) - base_ + 1;
    if (end > largest_end_) {
      largest_end_ = end;
      largest_line_ = line;
    }
    return true;
  }

  /// Reads the two ends of an edge without collecting it. @throws InputError as read_edge.
  Edge read_ends(Tokens& tokens);
  /// The number of vertices: as begun, or up to the largest id.
  /// @throws InputError if it is more than the text accounts for.
  std::uint64_t checked_n() const;

  std::uint64_t num_edges() const { return edges_.size(); }
  /// Largest vertex + 1 so far, and the same counted anew from here on.
  std::uint64_t largest_end() const { return largest_end_; }
  void forget_largest_end() { largest_end_ = 0; }
  /// The smallest vertex of the edges from the given one on; the largest number if there is none.
  /// O(m) time.
  Vertex smallest_vertex(std::size_t first_edge) const;
  /// Notes a largest vertex + 1 that stands in a line.
  void note_end(std::uint64_t end, std::uint64_t line);
  /// The first line read was no edge but said that there are n vertices. @throws InputError as
  /// begin. `collected`: it has been collected as an edge. O(m) time.
  void first_was_header(std::uint64_t n, bool collected);
  /// Ends the graph; without a known n it has the vertices up to the largest id.
  /// @throws InputError on parallel edges, or on more vertices than the text accounts for.
  Graph finish();

 private:
  /// From edge `first` on, edge e stands in line e + line - first, until the next entry.
  struct Run {
    std::uint64_t first = 0;
    std::uint64_t line = 0;
  };
  std::uint64_t line_of(std::uint64_t edge) const;
  void reserve_for_the_rest();

  const TextInput* input_;
  ReadOptions options_;  // a copy: the caller's may be a temporary
  unsigned base_;
  std::optional<std::uint64_t> known_n_;
  std::uint64_t limit_ = 0;         // ids are below this
  std::uint64_t largest_end_ = 0;   // largest vertex + 1
  std::uint64_t largest_line_ = 0;  // where it stands
  std::uint64_t first_byte_ = 0;    // of the graph's text
  std::uint64_t header_line_ = 0;
  std::vector<Edge> edges_;
  std::vector<Run> runs_;
};

}  // namespace ar3d
