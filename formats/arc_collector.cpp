#include "ar3d/formats/arc_collector.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace ar3d {
namespace {

template <class Arc>
std::uint64_t number_of(const Arc& arc) {
  return (std::uint64_t{arc.small} << 32) | arc.large;
}

}  // namespace

void ArcCollector::begin() {
  forward_.clear();
  backward_.clear();
}

void ArcCollector::add(Vertex u, Vertex v) {
  constexpr std::uint64_t kLastLine = std::numeric_limits<std::uint32_t>::max();
  const auto line = static_cast<std::uint32_t>(std::min(input_->line(), kLastLine));
  if (u < v) {
    forward_.push_back({u, v, line});
  } else {
    backward_.push_back({v, u, line});
  }
}

void ArcCollector::fail(const Arc& arc, bool backward, const char* problem) const {
  const std::uint64_t from = std::uint64_t{backward ? arc.large : arc.small} + base_;
  const std::uint64_t to = std::uint64_t{backward ? arc.small : arc.large} + base_;
  input_->fail_at(arc.line, 0, fmt::format("({}, {}) {}", from, to, problem));
}

void ArcCollector::sort_and_refuse_repeats(std::vector<Arc>& arcs) const {
  const auto before = [](const Arc& a, const Arc& b) {
    return std::pair(number_of(a), a.line) < std::pair(number_of(b), b.line);
  };
  if (!std::is_sorted(arcs.begin(), arcs.end(), before))
    std::sort(arcs.begin(), arcs.end(), before);
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    if (number_of(arcs[i - 1]) == number_of(arcs[i]))
      fail(arcs[i], &arcs == &backward_, "stands twice");
  }
}

std::vector<Edge> ArcCollector::merged() {
  constexpr const char* kAlone = "stands without its counterpart";
  std::vector<Edge> edges;
  edges.reserve(std::max(forward_.size(), backward_.size()));
  std::size_t f = 0;
  std::size_t b = 0;
  while (f < forward_.size() || b < backward_.size()) {
    const bool in_forward =
        b == backward_.size() ||
        (f < forward_.size() && number_of(forward_[f]) <= number_of(backward_[b]));
    const bool in_backward =
        f == forward_.size() ||
        (b < backward_.size() && number_of(backward_[b]) <= number_of(forward_[f]));
    const Arc& arc = in_forward ? forward_[f] : backward_[b];
    if (rule_ == Rule::both_ends && in_forward != in_backward) fail(arc, in_backward, kAlone);
    edges.push_back({arc.small, arc.large});
    f += in_forward ? 1 : 0;
    b += in_backward ? 1 : 0;
  }
  return edges;
}

Graph ArcCollector::finish(std::uint64_t n) {
  sort_and_refuse_repeats(forward_);
  sort_and_refuse_repeats(backward_);
  std::vector<Edge> edges = merged();
  begin();
  return Graph(n, std::move(edges));
}

}  // namespace ar3d
