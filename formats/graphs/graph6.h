#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ar3d/formats/graphs/graph_format.h"

// Lines of nauty's formats (https://users.cecs.anu.edu.au/~bdm/data/formats.txt): graph6 in
// graph6.cpp, sparse6 and its increments in sparse6.cpp.
namespace ar3d {

/// The printable characters of a graph6 or sparse6 line as groups of 6 bits.
class SixBits {
 public:
  /// @param at  where in `line` the groups begin.
  SixBits(const TextInput& input, std::string_view line, std::size_t at)
      : input_(&input), line_(line), at_(at) {}

  std::size_t left() const { return line_.size() - at_; }
  std::size_t column() const { return at_ + 1; }  ///< of the next group, from 1
  /// The next group. @throws InputError at the end of the line or on any other byte than '?' to
  /// '~'.
  unsigned group() {
    const unsigned value = left() > 0 ? static_cast<unsigned char>(line_[at_]) - 63u : 64u;
    if (value >= 64) fail_group();
    ++at_;
    return value;
  }
  /// The next four groups as 24 bits, the first of them highest; false, and nothing is read, if
  /// there are fewer or one is no such character.
  bool four_groups(std::uint32_t& bits) {
    if (left() < 4) return false;
    std::uint32_t c = 0;
    std::memcpy(&c, line_.data() + at_, sizeof c);
    if constexpr (std::endian::native == std::endian::big) c = __builtin_bswap32(c);
    const bool below_128 = (c & 0x80808080u) == 0;
    const bool up_to_tilde = ((c + 0x01010101u) & 0x80808080u) == 0;
    const bool from_mark = ((c + 0x41414141u) & 0x80808080u) == 0x80808080u;  // from '?' = 63
    if (!below_128 || !up_to_tilde || !from_mark) return false;
    c -= 0x3f3f3f3fu;
    bits = (c & 63) << 18 | (c >> 8 & 63) << 12 | (c >> 16 & 63) << 6 | c >> 24;
    at_ += 4;
    return true;
  }
  /// The number of vertices, N(n) in the format's description; up to 36 bits.
  std::uint64_t size();
  const TextInput& input() const { return *input_; }

 private:
  [[noreturn]] void fail_group() const;

  const TextInput* input_;
  std::string_view line_;
  std::size_t at_;
};

/// Appends N(n).
void append_size(std::string& out, std::uint64_t n);

/// Holds what a line of text says before it is known to be a simple graph: the number of vertices,
/// and the edges.
using EdgesOnVertices = std::pair<std::uint64_t, std::vector<Edge>>;

/// Decodes the graph6 line at `bits`: N(n), then the upper triangle of the adjacency matrix column
/// by column. Edges come as (u, v) with u < v, ordered by (v, u).
/// @throws InputError on a wrong length, a wrong character or padding bits that are not zero.
/// Cost: O(line) time; memory for the edges only.
EdgesOnVertices decode_graph6(SixBits bits, const ReadOptions& options);

/// Decodes the digraph6 line at `bits` (behind its '&'): N(n), then the adjacency matrix row by row.
/// Arcs come as they are. @throws InputError as decode_graph6. Cost: as decode_graph6.
EdgesOnVertices decode_digraph6(SixBits bits, const ReadOptions& options);

/// Appends the graph6 line of a graph with its newline. @throws InputError if n >= 2^18 (4 GiB a
/// line). Cost: O(n^2) time.
void append_graph6(std::string& out, const Graph& graph);

/// Decodes the sparse6 line at `bits` (behind its ':'): N(n), then pairs (b, x) of 1 and k bits, k
/// the number of bits of n - 1; b moves the current vertex v on by one, then x > v moves it to x
/// and x <= v is an edge. Edges come as (x, v) in the line's order (for most writers ordered by (v,
/// x)).
/// @throws InputError on a wrong character, a loop unless options.simplify, or padding that is not
/// the format's. Cost: O(line) time; memory for the edges only.
EdgesOnVertices decode_sparse6(SixBits bits, const ReadOptions& options);

/// Decodes the incremental sparse6 line at `bits` (behind its ';'): the pairs of the edges in which
/// the graph differs from the previous one. Edges come as (x, v) ordered by (v, x).
/// @throws InputError as decode_sparse6, and on an edge given twice.
EdgesOnVertices decode_incremental_sparse6(SixBits bits, std::uint64_t n,
                                           const std::vector<Edge>& previous);

/// Appends the sparse6 line of a graph with its newline. O(n + m) time.
/// @param pass_on  called now and then; may take the text away, so that no long line is held.
void append_sparse6(
    std::string& out, const Graph& graph, const std::function<void()>& pass_on = [] {});

/// Appends the line that turns `previous` into `graph` (both on the same number of vertices).
/// O(m log m) time.
void append_incremental_sparse6(std::string& out, const Graph& previous, const Graph& graph);

}  // namespace ar3d
