// The list of Rule 2.3 while it is built. Order tests need no balanced tree: what is put next to an
// owner stays in its cluster, clusters keep their ranks, and inside one a short walk decides. Cost:
// O(1) per insertion, amortised.
#include "ar3d/algorithms/two_bend/entry_list.h"

#include "ar3d/base/error.h"

namespace ar3d::two_bend {
namespace {

constexpr std::size_t kWalkers = 16;

}  // namespace

EntryList::EntryList(std::size_t num_nodes, const LongVector<NodeId>& owners) : links_(num_nodes) {
  NodeId last = kNone;
  std::uint32_t rank = 0;
  for (const NodeId v : owners) {
    expect(!contains(v), "an owner is listed once");
    links_[v] = {last, kNone, v, rank++};
    (last == kNone ? first_ : links_[last].next) = v;
    last = v;
  }
  for (std::size_t i = 1; i < kWalkers; ++i) {
    const std::size_t place = i * owners.size() / kWalkers;
    if (place > (i - 1) * owners.size() / kWalkers) starts_.push_back(owners[place]);
  }
}

LongVector<NodeId> EntryList::in_order() const {
  LongVector<NodeId> begins{first_};
  for (const NodeId v : starts_) {
    if (v != first_) begins.push_back(v);
  }
  LongVector<LongVector<NodeId>> parts(begins.size());
  LongVector<NodeId> at = begins;
  begins.push_back(kNone);
  for (bool going = first_ != kNone; going;) {
    going = false;
    for (std::size_t k = 0; k < at.size(); ++k) {
      if (at[k] == kNone) continue;
      parts[k].push_back(at[k]);
      at[k] = links_[at[k]].next;
      if (at[k] == begins[k + 1]) at[k] = kNone;
      ask_for(links_, at[k]);
      going = true;
    }
  }
  LongVector<NodeId> result;
  result.reserve(links_.size());
  for (const auto& part : parts) result.insert(result.end(), part.begin(), part.end());
  return result;
}

bool EntryList::before(NodeId u, NodeId v) const {
  const NodeId a = links_[u].cluster;
  const NodeId b = links_[v].cluster;
  expect(a != kNone && b != kNone, "only entries of the list are compared");
  return a != b ? links_[a].rank < links_[b].rank : walk_before(u, v);
}

/// u and v lie in one cluster: looks for v from u in both directions at once.
bool EntryList::walk_before(NodeId u, NodeId v) const {
  if (u == v) return false;
  const NodeId cluster = links_[u].cluster;
  NodeId up = links_[u].next;
  NodeId down = links_[u].previous;
  while (true) {
    if (up == v) return true;
    if (down == v) return false;
    const bool up_ends = up == kNone || links_[up].cluster != cluster;
    const bool down_ends = down == kNone || links_[down].cluster != cluster;
    if (up_ends) return false;
    if (down_ends) return true;
    up = links_[up].next;
    down = links_[down].previous;
  }
}

void EntryList::insert_after(NodeId place, NodeId v) {
  link(place, v, links_[place].next, links_[place].cluster);
}

void EntryList::insert_before(NodeId place, NodeId v) {
  expect(links_[place].previous != kNone, "nothing is put before the first entry");
  link(links_[place].previous, v, place, links_[place].cluster);
}

void EntryList::link(NodeId left, NodeId v, NodeId right, NodeId cluster) {
  expect(cluster != kNone && !contains(v), "a new entry is put next to an entry of the list");
  links_[v] = {left, right, cluster, links_[v].rank};
  links_[left].next = v;
  if (right != kNone) links_[right].previous = v;
}

void EntryList::remove(NodeId v) {
  const Link link = links_[v];
  const auto shares = [&](NodeId u) { return u != kNone && links_[u].cluster == v; };
  expect(link.cluster == v && !shares(link.previous) && !shares(link.next),
         "a moved owner has nothing attached to it");
  (link.previous == kNone ? first_ : links_[link.previous].next) = link.next;
  if (link.next != kNone) links_[link.next].previous = link.previous;
  links_[v].cluster = kNone;
  std::erase(starts_, v);
}

}  // namespace ar3d::two_bend
