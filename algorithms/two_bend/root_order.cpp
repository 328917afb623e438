// The order of the trees of Rule 2.2 while effort 2 moves them: a list with insertion and
// comparison (Bender, Cole, Demaine, Farach-Colton and Zito 2002), whose labels are spread again
// where they run out. Cost: amortised O(log n) per insertion, O(1) per comparison.
#include "ar3d/algorithms/two_bend/root_order.h"

#include "ar3d/base/error.h"

namespace ar3d::two_bend {

void RootOrder::append(NodeId v) {
  links_[v] = {last_ == kNone ? 0 : (links_[last_].label / kStep + 1) * kStep, last_, kNone};
  (last_ == kNone ? first_ : links_[last_].next) = v;
  last_ = v;
}

std::int64_t RootOrder::room_after(NodeId u) const {
  return links_[links_[u].next].label - links_[u].label;
}

void RootOrder::insert_after(NodeId u, NodeId v) {
  if (u == last_) return append(v);
  if (room_after(u) < 2) spread(u);
  const NodeId next = links_[u].next;
  links_[v] = {links_[u].label + room_after(u) / 2, u, next};
  links_[u].next = v;
  links_[next].previous = v;
}

/// Ranges of 2^i labels may hold 1.5^i entries: fewer than labels from i = 2 on, more than 2^28 in
/// all.
void RootOrder::spread(NodeId u) {
  NodeId left = u;
  NodeId right = u;
  std::int64_t count = 1;
  double most = 1;
  for (int i = 1; i < 63; ++i) {
    const std::int64_t size = std::int64_t{1} << i;
    const std::int64_t base = links_[u].label & -size;
    most *= 1.5;
    while (links_[left].previous != kNone && links_[links_[left].previous].label >= base) {
      left = links_[left].previous;
      ++count;
    }
    while (links_[right].next != kNone && links_[links_[right].next].label < base + size) {
      right = links_[right].next;
      ++count;
    }
    if (static_cast<double>(count) > most || size / count < 2) continue;
    std::int64_t label = base;
    for (NodeId v = left;; v = links_[v].next) {
      links_[v].label = label;
      if (v == right) break;
      label += size / count;
    }
    return;
  }
  throw InternalError("internal error: a list of rows ran out of labels");
}

}  // namespace ar3d::two_bend
