// Groups of six bits, the number of vertices, and graph6, whose bits are the upper triangle of the
// adjacency matrix. Reference: nauty (copyg, showg).
#include "ar3d/formats/graphs/graph6.h"

#include <algorithm>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr unsigned kEscape = 63;  // the group '~': a longer form of N(n) follows

constexpr std::uint64_t kMaxWritten = std::uint64_t{1} << 18;

/// Entries above the diagonal, in groups of six; n < 2^32.
std::uint64_t body_groups(std::uint64_t n) { return n == 0 ? 0 : (n * (n - 1) / 2 + 5) / 6; }

/// Reads N(n). @throws InputError unless as many groups follow as `groups` gives for n.
std::uint64_t read_size(SixBits& bits, const ReadOptions& options,
                        std::uint64_t (*groups)(std::uint64_t n)) {
  const std::uint64_t n = bits.size();
  if (const auto problem = vertex_count_problem(n, bits.left(), options)) {
    bits.input().fail(1, *problem);
  }
  if (bits.left() != groups(n)) {
    bits.input().fail(bits.column(),
                      fmt::format("{} vertices take {} characters after the size, found {}", n,
                                  groups(n), bits.left()));
  }
  return n;
}

}  // namespace

void SixBits::fail_group() const {
  if (left() == 0) input_->fail(column(), "the line ends too early");
  input_->fail(column(), fmt::format("character {} is not one of graph6 and sparse6 ('?' to '~')",
                                     shown(line_.substr(at_, 1))));
}

std::uint64_t SixBits::size() {
  std::uint64_t n = group();
  if (n < kEscape) return n;
  unsigned groups = 3;
  n = group();
  if (n == kEscape) {
    groups = 6;
    n = group();
  }
  for (unsigned i = 1; i < groups; ++i) n = (n << 6) | group();
  return n;
}

void append_size(std::string& out, std::uint64_t n) {
  unsigned groups = 1;
  if (n > 62) {
    out += '~';
    groups = 3;
  }
  if (n > 258047) {
    out += '~';
    groups = 6;
  }
  for (unsigned i = groups; i-- > 0;) out.push_back(static_cast<char>(63 + ((n >> (6 * i)) & 63)));
}

EdgesOnVertices decode_graph6(SixBits bits, const ReadOptions& options) {
  const std::uint64_t n = read_size(bits, options, body_groups);
  const std::uint64_t groups = bits.left();
  std::vector<Edge> edges;
  std::uint64_t u = 0;  // the group's first entry is (u, v)
  std::uint64_t v = 1;
  for (std::uint64_t i = 0; i < groups; ++i) {
    unsigned group = bits.group();
    while (group != 0) {
      const auto skipped = static_cast<unsigned>(std::countl_zero(group)) - 26;  // of the six bits
      std::uint64_t row = u + skipped;
      std::uint64_t column = v;
      while (row >= column) row -= column++;
      if (column >= n) bits.input().fail(bits.column() - 1, "the padding bits are not zero");
      edges.push_back({static_cast<Vertex>(row), static_cast<Vertex>(column)});
      group &= ~(32u >> skipped);
    }
    u += 6;
    while (u >= v) u -= v++;
  }
  return {n, std::move(edges)};
}

EdgesOnVertices decode_digraph6(SixBits bits, const ReadOptions& options) {
  const std::uint64_t n = read_size(bits, options, [](std::uint64_t n) { return (n * n + 5) / 6; });
  std::vector<Edge> edges;
  for (std::uint64_t first = 0; bits.left() > 0; first += 6) {
    for (unsigned group = bits.group(); group != 0; group &= group - 1) {
      const std::uint64_t bit = first + 5 - static_cast<unsigned>(std::countr_zero(group));
      if (bit >= n * n) bits.input().fail(bits.column() - 1, "the padding bits are not zero");
      edges.push_back({static_cast<Vertex>(bit / n), static_cast<Vertex>(bit % n)});
    }
  }
  return {n, std::move(edges)};
}

void append_graph6(std::string& out, const Graph& graph) {
  const std::uint64_t n = graph.num_vertices();
  if (n >= kMaxWritten) {
    throw InputError(
        fmt::format("graph6 of {} vertices would be gigabytes, choose another format", n));
  }
  append_size(out, n);
  const std::size_t body = out.size();
  out.append(body_groups(n), '?');
  for (const auto [a, b] : graph.edges()) {
    const std::uint64_t u = std::min(a, b);
    const std::uint64_t v = std::max(a, b);
    const std::uint64_t bit = v * (v - 1) / 2 + u;
    char& group = out[body + bit / 6];
    group = static_cast<char>(63 + ((group - 63) | (32 >> (bit % 6))));
  }
  out += '\n';
}

}  // namespace ar3d
