#pragma once

#include <cstdint>
#include <vector>

#include "ar3d/algorithms/two_bend/flow.h"

namespace ar3d::two_bend {

/// A linked list with order tests in O(1): labels that grow along the list. Where labels run out,
/// the smallest aligned range of labels that is not too full is spread evenly (Bender, Cole,
/// Demaine, Farach-Colton and Zito 2002), so an insertion costs amortised O(log n).
class RootOrder {
 public:
  /// For entries below num_nodes <= 2^28.
  explicit RootOrder(std::size_t num_nodes) : links_(num_nodes) {}

  NodeId first() const { return first_; }
  NodeId next(NodeId v) const { return links_[v].next; }
  bool before(NodeId u, NodeId v) const { return links_[u].label < links_[v].label; }
  void append(NodeId v);
  void insert_after(NodeId u, NodeId v);

 private:
  struct Link {
    std::int64_t label = 0;
    NodeId previous = kNone;
    NodeId next = kNone;
  };
  static constexpr std::int64_t kStep = std::int64_t{1} << 32;  // between appended entries

  std::int64_t room_after(NodeId u) const;
  void spread(NodeId u);

  LongVector<Link> links_;
  NodeId first_ = kNone;
  NodeId last_ = kNone;
};

}  // namespace ar3d::two_bend
