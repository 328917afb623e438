// sparse6 and incremental sparse6: edges in ascending order as moves of a current vertex.
// Reference: nauty (copyg -s, copyg -i, showg).
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <iterator>
#include <span>

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/graph6.h"
#include "ar3d/formats/graphs/graph_format.h"

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
      std::uint32_t four = 0;
      if (bits_.four_groups(four)) {
        held_ = (held_ << 24) | four;
        count_ += 24;
        continue;
      }
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
  /// Returns the column of the group behind the last pair; of the end of the line if that holds no
  /// whole pair.
  std::size_t column() const { return bits_.column() - (count_ < width_ ? 0 : count_ / 6); }

 private:
  SixBits bits_;
  unsigned width_;
  std::uint64_t held_ = 0;  // the low count_ bits are not given yet; width_ + 23 <= 56 at most
  unsigned count_ = 0;
};

std::vector<Edge> decode_pairs(const SixBits& bits, std::uint64_t n, bool drop_loops) {
  const TextInput& input = bits.input();
  const unsigned width = vertex_bits(n);
  const std::uint64_t low = (std::uint64_t{1} << width) - 1;
  std::vector<Edge> edges;
  edges.reserve(bits.left() * 6 / (width + 1));
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
      if (!drop_loops) input.fail(pairs.column() - 1, fmt::format("edge ({0}, {0}) is a loop", v));
    } else {
      edges.push_back({static_cast<Vertex>(x), static_cast<Vertex>(v)});
    }
  }
  if (!pairs.rest_is_padding(pair, ended)) {
    input.fail(pairs.column() - 1, "wrong padding behind the last edge");
  }
  return edges;
}

/// An edge as a number: edges in sparse6's order are ascending numbers.
std::uint64_t number_of(Edge e) {
  return (std::uint64_t{std::max(e.u, e.v)} << 32) | std::min(e.u, e.v);
}

std::vector<std::uint64_t> sorted_numbers(std::span<const Edge> edges) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(edges.size());
  for (const Edge e : edges) numbers.push_back(number_of(e));
  if (!std::is_sorted(numbers.begin(), numbers.end())) std::sort(numbers.begin(), numbers.end());
  return numbers;
}

/// Writes the pairs of edges (u, v), u < v, given in ascending order of (v, u), six bits a
/// character.
class PairWriter {
 public:
  PairWriter(std::string& out, std::uint64_t n) : out_(&out), n_(n), width_(vertex_bits(n)) {}

  void put(Vertex u, Vertex v) {
    put_bits(1, v == current_ ? 0 : 1);
    if (v > current_ + 1) {  // x > v: a jump; the edge follows with b = 0
      put_bits(width_, v);
      put_bits(1, 0);
    }
    put_bits(width_, u);
    current_ = v;
  }

  /// Fills the last character with ones. A pair of ones would be read as the loop at n - 1 if n is
  /// a power of two and the current vertex n - 2; a zero in front turns it into a harmless move to
  /// n - 1.
  void finish() {
    if (count_ == 0) return;
    const unsigned missing = 6 - count_;
    const bool hidden_loop =
        missing > width_ && width_ > 0 && n_ == (std::uint64_t{1} << width_) && current_ + 2 == n_;
    const std::uint32_t ones = (1u << missing) - 1;
    put_bits(missing, hidden_loop ? ones >> 1 : ones);
  }

 private:
  void put_bits(unsigned width, std::uint32_t value) {  // width <= 32
    held_ = (held_ << width) | value;
    count_ += width;
    while (count_ >= 6) {
      count_ -= 6;
      out_->push_back(static_cast<char>(63 + ((held_ >> count_) & 63)));
    }
  }

  std::string* out_;
  std::uint64_t held_ = 0;  // the low count_ bits wait; count_ < 6 between calls
  unsigned count_ = 0;
  std::uint64_t n_;
  unsigned width_;
  std::uint64_t current_ = 0;
};

}  // namespace

EdgesOnVertices decode_sparse6(SixBits bits, const ReadOptions& options) {
  const std::uint64_t n = bits.size();
  if (const auto problem = vertex_count_problem(n, bits.left(), options))
    bits.input().fail(1, *problem);
  return {n, decode_pairs(bits, n, options.simplify)};
}

EdgesOnVertices decode_incremental_sparse6(SixBits bits, std::uint64_t n,
                                           const std::vector<Edge>& previous) {
  const std::vector<std::uint64_t> changes = sorted_numbers(decode_pairs(bits, n, false));
  const auto twice = std::adjacent_find(changes.begin(), changes.end());
  if (twice != changes.end()) {
    bits.input().fail(
        0, fmt::format("edge ({}, {}) is changed twice", *twice & 0xffffffff, *twice >> 32));
  }
  const std::vector<std::uint64_t> before = sorted_numbers(previous);
  std::vector<std::uint64_t> after;
  std::set_symmetric_difference(before.begin(), before.end(), changes.begin(), changes.end(),
                                std::back_inserter(after));
  std::vector<Edge> edges;
  edges.reserve(after.size());
  for (const std::uint64_t edge : after) {
    edges.push_back({static_cast<Vertex>(edge & 0xffffffff), static_cast<Vertex>(edge >> 32)});
  }
  return {n, std::move(edges)};
}

void append_sparse6(std::string& out, const Graph& graph, const std::function<void()>& pass_on) {
  constexpr Vertex kVerticesBetween = 1024;
  out += ':';
  append_size(out, graph.num_vertices());
  PairWriter pairs(out, graph.num_vertices());
  std::vector<Vertex> smaller;
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    smaller.clear();
    for (const HalfEdge& half : graph.incident(v)) {
      if (half.to < v) smaller.push_back(half.to);
    }
    std::sort(smaller.begin(), smaller.end());
    for (const Vertex u : smaller) pairs.put(u, v);
    if (v % kVerticesBetween == 0) pass_on();
  }
  pairs.finish();
  out += '\n';
}

void append_incremental_sparse6(std::string& out, const Graph& previous, const Graph& graph) {
  expect(previous.num_vertices() == graph.num_vertices(), "incremental graphs have equal sizes");
  const std::vector<std::uint64_t> before = sorted_numbers(previous.edges());
  const std::vector<std::uint64_t> after = sorted_numbers(graph.edges());
  std::vector<std::uint64_t> changes;
  std::set_symmetric_difference(before.begin(), before.end(), after.begin(), after.end(),
                                std::back_inserter(changes));
  out += ';';
  PairWriter pairs(out, graph.num_vertices());
  for (const std::uint64_t edge : changes) {
    pairs.put(static_cast<Vertex>(edge & 0xffffffff), static_cast<Vertex>(edge >> 32));
  }
  pairs.finish();
  out += '\n';
}

}  // namespace ar3d
