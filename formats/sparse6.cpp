#include "ar3d/formats/sparse6.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "ar3d/formats/vertex_limit.h"

namespace ar3d {
namespace {

/// Bits of n - 1.
unsigned vertex_bits(std::uint64_t n) {
  return n == 0 ? 0 : static_cast<unsigned>(std::bit_width(n - 1));
}

/// The pairs (b, x) of a line, and the bits behind the last whole one.
class Pairs {
 public:
  Pairs(SixBits bits, unsigned width) : bits_(bits), width_(width + 1) {}

  /// True if a whole pair is left; it is then in `pair`, b as its highest bit.
  bool next(std::uint64_t& pair) {
    while (count_ < width_) {
      if (bits_.left() == 0) return false;
      held_ = (held_ << 6) | bits_.group();
      count_ += 6;
    }
    count_ -= width_;
    pair = (held_ >> count_) & ((std::uint64_t{1} << width_) - 1);
    return true;
  }
  /// True if what is left is the format's padding: less than a character, all ones. `with_last`
  /// counts the pair given last as part of it.
  bool rest_is_padding(std::uint64_t last_pair, bool with_last) const {
    const std::uint64_t tail = (std::uint64_t{1} << count_) - 1;
    const std::uint64_t whole = (std::uint64_t{1} << width_) - 1;
    const unsigned length = count_ + (with_last ? width_ : 0);
    return bits_.left() == 0 && length < 6 && (held_ & tail) == tail &&
           (!with_last || last_pair == whole);
  }
  std::size_t column() const { return bits_.column(); }

 private:
  SixBits bits_;
  unsigned width_;
  std::uint64_t held_ = 0;  // the low count_ bits are not given yet
  unsigned count_ = 0;
};

}  // namespace

EdgesOnVertices decode_sparse6(SixBits bits, const ReadOptions& options) {
  EdgesOnVertices result;
  const std::uint64_t n = result.n = bits.size();
  if (const auto problem = vertex_count_problem(n, bits.left(), options))
    bits.input().fail(1, *problem);
  const TextInput& input = bits.input();
  const unsigned width = vertex_bits(n);
  const std::uint64_t low = (std::uint64_t{1} << width) - 1;
  result.edges.reserve(bits.left() * 6 / (width + 1));
  Pairs pairs(bits, width);
  std::uint64_t v = 0;
  std::uint64_t pair = 0;
  bool ended = false;
  while (!ended && pairs.next(pair)) {
    const std::uint64_t x = pair & low;
    v += pair >> width;
    if (v >= n || (x > v && x >= n)) {
      ended = true;
    } else if (x > v) {
      v = x;
    } else if (x == v) {
      input.fail(pairs.column() - 1, fmt::format("edge ({0}, {0}) is a loop", v));
    } else {
      result.edges.push_back({static_cast<Vertex>(x), static_cast<Vertex>(v)});
    }
  }
  if (!pairs.rest_is_padding(pair, ended)) {
    input.fail(pairs.column() - 1, "wrong padding behind the last edge");
  }
  return result;
}

namespace {

/// The smaller neighbours of v, ascending.
void smaller_neighbours(const Graph& graph, Vertex v, std::vector<Vertex>& out) {
  out.clear();
  for (const HalfEdge& half : graph.incident(v)) {
    if (half.to < v) out.push_back(half.to);
  }
  std::sort(out.begin(), out.end());
}

/// Fills the last character with ones. A pair of ones would be read as the loop at n - 1 if n is a
/// power of two and the current vertex n - 2; a zero in front turns it into a harmless move to n
/// - 1.
void put_padding(SixBitWriter& bits, std::uint64_t n, unsigned width, std::uint64_t current) {
  const unsigned missing = bits.missing();
  if (missing == 0) return;
  const bool hidden_loop =
      missing > width && width > 0 && n == (std::uint64_t{1} << width) && current + 2 == n;
  const std::uint32_t ones = (1u << missing) - 1;
  bits.put(missing, hidden_loop ? ones >> 1 : ones);
}

}  // namespace

void append_sparse6(std::string& out, const Graph& graph) {
  const std::uint64_t n = graph.num_vertices();
  const unsigned width = vertex_bits(n);
  out += ':';
  append_size(out, n);
  SixBitWriter bits(out);
  Vertex current = 0;
  std::vector<Vertex> smaller;
  for (Vertex v = 0; v < n; ++v) {
    smaller_neighbours(graph, v, smaller);
    for (const Vertex u : smaller) {
      bits.put(1, v == current ? 0 : 1);
      if (v > current + 1) {  // x > v: a jump; the edge follows with b = 0
        bits.put(width, v);
        bits.put(1, 0);
      }
      bits.put(width, u);
      current = v;
    }
  }
  put_padding(bits, n, width, current);
  out += '\n';
}

}  // namespace ar3d
