#include "ar3d/formats/arc_collector.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
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

void ArcCollector::fail(const Arc& arc, bool backward, const char* problem) const {
  const std::uint64_t from = std::uint64_t{backward ? arc.large : arc.small} + base_;
  const std::uint64_t to = std::uint64_t{backward ? arc.small : arc.large} + base_;
  input_->fail_at(arc.line, 0, fmt::format("({}, {}) {}", from, to, problem));
}

/// The arcs by smaller end, those of each in the order given (counting sort).
ArcCollector::Arcs ArcCollector::grouped(std::uint64_t n, const Arcs& arcs) {
  constexpr std::size_t kAhead = 16;  // arcs; hides the way to memory
  UnwrittenVector<std::uint32_t> place(n + 1);
  std::fill(place.begin(), place.end(), 0u);
  for (const Arc& arc : arcs) ++place[arc.small + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  Arcs result(arcs.size());
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (i + 2 * kAhead < arcs.size()) {
      __builtin_prefetch(&place[arcs[i + 2 * kAhead].small], 1);
      __builtin_prefetch(result.data() + place[arcs[i + kAhead].small], 1);
    }
    result[place[arcs[i].small]++] = arcs[i];
  }
  return result;
}

void ArcCollector::sort_and_refuse_repeats(std::uint64_t n, Arcs& arcs) const {
  const auto by_small = [](const Arc& a, const Arc& b) { return a.small < b.small; };
  const auto before = [](const Arc& a, const Arc& b) {
    return std::pair(number_of(a), a.line) < std::pair(number_of(b), b.line);
  };
  const bool countable = arcs.size() <= std::numeric_limits<std::uint32_t>::max();
  if (n > 8 * arcs.size() || !countable) {  // counting would cost more
    std::sort(arcs.begin(), arcs.end(), before);
  } else if (!std::is_sorted(arcs.begin(), arcs.end(), by_small)) {
    arcs = grouped(n, arcs);
  }
  for (auto row = arcs.begin(); row != arcs.end();) {
    auto end = row;
    while (end != arcs.end() && end->small == row->small) ++end;
    std::sort(row, end, before);
    row = end;
  }
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
  sort_and_refuse_repeats(n, forward_);
  sort_and_refuse_repeats(n, backward_);
  std::vector<Edge> edges = merged();
  begin();
  return Graph(n, std::move(edges));
}

}  // namespace ar3d
