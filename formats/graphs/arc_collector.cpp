// Matches the two ends of every edge without looking anything up: both lists of arcs are sorted,
// as they nearly always come, and then read in step.
#include "ar3d/formats/graphs/arc_collector.h"

namespace ar3d {
namespace {

template <class Arc>
std::uint64_t number_of(const Arc& arc) {
  return (std::uint64_t{arc.small} << 32) | arc.large;
}

/// Sorts arcs by a key, those with the same one in the order given. Most texts are sorted already.
template <class Arcs, class Key>
void sort_by(Arcs& arcs, Key key) {
  if (!std::ranges::is_sorted(arcs, {}, key)) std::ranges::stable_sort(arcs, {}, key);
}

}  // namespace

void ArcCollector::begin(std::uint64_t announced) {
  loops_ = 0;
  forward_.clear();
  backward_.clear();
  const std::uint64_t most = std::min(announced, input_->bytes_left() / 2);  // "1 " an arc
  forward_.reserve(most / 2);
  backward_.reserve(most / 2);
}

void ArcCollector::fail(const Arc& arc, bool backward, const char* problem) const {
  const auto name = [&](Vertex v) {
    return name_ ? name_(v) : fmt::format("{}", std::uint64_t{v} + base_);
  };
  input_->fail_at(arc.line, 0,
                  fmt::format("({}, {}) {}", name(backward ? arc.large : arc.small),
                              name(backward ? arc.small : arc.large), problem));
}

void ArcCollector::refuse_repeats(const Arcs& arcs) const {
  for (std::size_t i = 1; i < arcs.size(); ++i) {
    if (number_of(arcs[i - 1]) == number_of(arcs[i]))
      fail(arcs[i], &arcs == &backward_, "stands twice");
  }
}

void ArcCollector::drop_repeats(Arcs& arcs) {
  const auto same = [](const Arc& a, const Arc& b) { return number_of(a) == number_of(b); };
  arcs.resize(static_cast<std::size_t>(std::unique(arcs.begin(), arcs.end(), same) - arcs.begin()));
}

/// The graph, if each arc has its counterpart and none stands twice. The rows of the graph of the
/// sorted forward arcs are sorted, so the backward arcs, sorted by the end that names them, must
/// read like the beginnings of the rows: nothing is looked up.
std::optional<Graph> ArcCollector::matched(std::uint64_t n) {
  if (forward_.size() != backward_.size()) return std::nullopt;
  sort_by(forward_, number_of<Arc>);
  sort_by(backward_, [](const Arc& arc) { return std::pair(arc.large, arc.small); });
  std::vector<Edge> edges;
  edges.reserve(forward_.size());
  for (std::size_t i = 0; i < forward_.size(); ++i) {
    if (i > 0 && number_of(forward_[i - 1]) == number_of(forward_[i])) return std::nullopt;
    edges.push_back({forward_[i].small, forward_[i].large});
  }
  Graph graph(n, std::move(edges));
  auto arc = backward_.begin();
  for (Vertex v = 0; v < n; ++v) {
    for (const HalfEdge& half : graph.incident(v)) {
      if (half.to > v) break;
      if (arc == backward_.end() || arc->large != v || arc->small != half.to) return std::nullopt;
      ++arc;
    }
  }
  return graph;
}

std::vector<Edge> ArcCollector::merged() {
  constexpr const char* kAlone = "stands without its counterpart";
  constexpr const char* kMixed =
      "stands at one of its ends, others at both: all edges stand at one, or all at both";
  const Arc* alone = nullptr;
  bool is_alone_backward = false;
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
    if (in_forward != in_backward) {
      if (!one_end_will_do_) fail(arc, in_backward, kAlone);
      alone = &arc;
      is_alone_backward = in_backward;
    }
    edges.push_back({arc.small, arc.large});
    f += in_forward ? 1 : 0;
    b += in_backward ? 1 : 0;
  }
  const std::size_t both = forward_.size() + backward_.size() - edges.size();
  if (alone != nullptr && both > 0 && !simplify_) fail(*alone, is_alone_backward, kMixed);
  return edges;
}

Graph ArcCollector::finish(std::uint64_t n, std::function<std::string(Vertex)> name) {
  name_ = std::move(name);
  if (std::optional<Graph> graph = matched(n)) {
    begin();
    return std::move(*graph);
  }
  for (Arcs* const arcs : {&forward_, &backward_}) {
    sort_by(*arcs, [](const Arc& arc) { return std::pair(number_of(arc), arc.line); });
    if (simplify_) {
      drop_repeats(*arcs);
    } else {
      refuse_repeats(*arcs);
    }
  }
  std::vector<Edge> edges = merged();
  begin();
  return Graph(n, std::move(edges));
}

}  // namespace ar3d
