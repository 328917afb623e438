// Remembers in which line each edge stands, as runs of successive lines: an error far behind names
// its line.
#include "ar3d/formats/graphs/edge_collector.h"

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/plain_lines.h"

namespace ar3d {
namespace {
constexpr std::uint64_t kMaxVertices = std::numeric_limits<Vertex>::max() - 1;
constexpr const char* kFromOne = ", ids from 0 (--base 1 reads ids from 1)";
}  // namespace

void EdgeCollector::begin(std::optional<std::uint64_t> n) {
  if (n > kMaxVertices) input_->fail(0, *vertex_count_problem(*n, 0, options_));
  known_n_ = n;
  limit_ = n.value_or(kMaxVertices);
  range_ = {};
  first_byte_ = input_->bytes();
  header_line_ = input_->line();
  edges_.clear();
  runs_.clear();
}

void EdgeCollector::expect_edges(std::uint64_t announced) {
  constexpr std::uint64_t kShortestLine = 4;  // "1 2\n"
  reserve_long(edges_, std::min(announced, input_->bytes_left() / kShortestLine + 1));
}

Vertex EdgeCollector::read_vertex(Tokens& tokens) {
  const std::uint64_t id = tokens.number("a vertex id");
  return vertex_of(id, tokens.column());
}

Vertex EdgeCollector::vertex_of(std::uint64_t id, std::size_t column) {
  if (id < base_)
    input_->fail(column, fmt::format("vertex id {} is below {}, the smallest here", id, base_));
  if (id - base_ >= limit_) {
    input_->fail(column,
                 known_n_ ? fmt::format("vertex id {} is out of range, the graph has {} vertices{}",
                                        id, limit_, base_ == 0 && id == limit_ ? kFromOne : "")
                          : fmt::format("vertex id {} is too large, ids fit 32 bits", id));
  }
  note({id - base_, id - base_ + 1, input_->line()});
  return static_cast<Vertex>(id - base_);
}

void EdgeCollector::note(const Range& other) {
  range_.smallest = std::min(range_.smallest, other.smallest);
  if (other.end <= range_.end) return;
  range_.end = other.end;
  range_.line = other.line;
}

std::uint64_t EdgeCollector::num_named() const {
  std::vector<bool> is_named(range_.end);
  for (const Edge& edge : edges_) is_named[edge.u] = is_named[edge.v] = true;
  return static_cast<std::uint64_t>(std::ranges::count(is_named, true));
}

void EdgeCollector::settle(std::uint64_t n, unsigned base) {
  if (n > kMaxVertices) input_->fail_at(header_line_, 0, *vertex_count_problem(n, 0, options_));
  for (Edge& edge : edges_) {
    edge.u -= base - base_;
    edge.v -= base - base_;
  }
  known_n_ = n;
  base_ = base;
}

void EdgeCollector::drop_first_edge() {
  edges_.erase(edges_.begin());
  for (Run& run : runs_) {
    if (run.first > 0)
      --run.first;
    else
      ++run.line;
  }
}

Edge EdgeCollector::read_ends(Tokens& tokens) {
  const Vertex u = read_vertex(tokens);
  const Vertex v = read_vertex(tokens);
  if (u == v && !options_.simplify)
    tokens.fail(fmt::format("edge ({0}, {0}) is a loop", std::uint64_t{u} + base_));
  return {u, v};
}

void EdgeCollector::read_edge(Tokens& tokens) {
  const auto [u, v] = read_ends(tokens);
  add(u, v);
}

void EdgeCollector::add(Vertex u, Vertex v) {
  const std::uint64_t edge = edges_.size();
  if (runs_.empty() || line_of(edge) != input_->line()) runs_.push_back({edge, input_->line()});
  edges_.push_back({u, v});
}

/// Grows eightfold where the rest of the text may need it: less is copied than by doubling, and a
/// text that lies about its length gets no more than eight times what it has paid for.
void EdgeCollector::reserve_for_the_rest() {
  constexpr std::uint64_t kMany = 1 << 14;
  const std::uint64_t count = edges_.size();
  if (count < kMany || edges_.capacity() - count > count / 8) return;
  const std::uint64_t bytes_an_edge = (input_->bytes() - first_byte_) / count + 1;
  reserve_long(edges_,
               count + std::clamp(input_->bytes_left() / bytes_an_edge * 9 / 8, count, 7 * count));
}

std::uint64_t EdgeCollector::read_plain_edges(TextInput& input, std::string_view before,
                                              std::uint64_t most) {
  reserve_for_the_rest();
  const std::uint64_t first_edge = edges_.size();
  const std::uint64_t first_line = input.line() + 1;
  const std::uint64_t lines =
      read_plain_pairs(input, before, most, [&](auto u, auto v, std::uint64_t line) {
        if (!accepts(u, v, line)) return false;
        edges_.push_back({static_cast<Vertex>(u - base_), static_cast<Vertex>(v - base_)});
        return true;
      });
  if (lines > 0 && (runs_.empty() || line_of(first_edge) != first_line)) {
    runs_.push_back({first_edge, first_line});
  }
  return lines;
}

std::uint64_t EdgeCollector::line_of(std::uint64_t edge) const {
  if (edge >= runs_.back().first) return runs_.back().line + (edge - runs_.back().first);
  const auto after =
      std::upper_bound(runs_.begin(), runs_.end(), edge,
                       [](std::uint64_t e, const Run& run) { return e < run.first; });
  const Run& run = *std::prev(after);
  return run.line + (edge - run.first);
}

std::uint64_t EdgeCollector::checked_n() const {
  const std::uint64_t n = known_n_.value_or(range_.end);
  const std::uint64_t bytes = input_->bytes() - first_byte_;
  if (const auto problem = vertex_count_problem(n, bytes, options_)) {
    input_->fail_at(known_n_ ? header_line_ : range_.line, 0, *problem);
  }
  return n;
}

Graph EdgeCollector::finish() {
  const std::uint64_t n = checked_n();
  std::vector<Edge> edges = std::exchange(edges_, {});
  if (options_.simplify) simplify(edges);
  try {
    return Graph(n, std::move(edges));
  } catch (const EdgeError& error) {
    input_->fail_at(line_of(error.edge()), 0,
                    fmt::format("edge ({}, {}) is parallel to an earlier edge", error.u() + base_,
                                error.v() + base_));
  }
}

}  // namespace ar3d
