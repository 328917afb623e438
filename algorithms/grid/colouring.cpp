// Step 3.9. Greedy labels with repair: where two earlier neighbours offer one label, all Kempe
// chains (Kempe 1879) that would help are followed in turn, one step each, and the first that ends
// is swapped, so that a long chain costs no more than the shortest. Cost: O(n), as the chains have
// 100 steps per vertex in all.
#include <algorithm>

#include "ar3d/algorithms/grid/flat.h"
#include "ar3d/base/error.h"

namespace ar3d::grid {
namespace {

/// A Kempe chain being followed: it begins at w with the label `wanted` and alternates with the
/// label `given` that w's half-edge to v has. Swapping the two labels on it frees `given` at w.
struct Walker {
  Index start = 0;
  Index at = 0;
  Colour wanted = 0;
  Colour given = 0;
  Colour follow = 0;
};

enum class ChainStep : std::uint8_t { goes_on, ends, fails };

class Labeller {
 public:
  Labeller(const ProcessingOrder& order, std::span<const PlacedRow> neighbours,
           std::uint64_t longest_chain)
      : order_(order),
        neighbours_(neighbours),
        longest_chain_(longest_chain),
        budget_(kStepsPerVertex * neighbours.size() + 1000),
        received_(neighbours.size(), 0) {
    result_.ports.resize(neighbours.size(), Ports{});
  }

  Colouring run() {
    for (const OrderPart& part : order_.parts) {
      f_ = part.cubic ? part.begin : kNoIndex;
      r_ = part.cubic ? part.end - 1 : kNoIndex;
      for (Index v = part.begin + (part.cubic ? 1 : 0); v < part.end; ++v) {
        prefetch_ports(v + kAhead);
        label_at(v);
      }
    }
    result_.chain_steps = kStepsPerVertex * neighbours_.size() + 1000 - budget_;
    return std::move(result_);
  }

 private:
  /// Memory of v's neighbours, which label_at(v) reads, on its way.
  [[gnu::always_inline]] void prefetch_ports(Index v) const {
    if (v >= neighbours_.size()) return;
    for (const HalfEdge& half : neighbours_[v].halves()) {
      __builtin_prefetch(&result_.ports[half.to], 1);
    }
  }

  Colour label_towards(Index from, Index to) const {
    const Ports& ports = result_.ports[from];
    return ports.to[0] == to ? 0 : ports.to[1] == to ? 1 : 2;
  }
  ColourSet used_at(Index v) const {
    ColourSet used = 0;
    for (Colour c = 0; c < kColours; ++c) {
      if (result_.ports[v].to[c] != kNoIndex) used |= only(c);
    }
    return used;
  }

  HalfEdgesAt look(Index v) const {
    HalfEdgesAt at;
    for (const HalfEdge& half : neighbours_[v].halves()) {
      if (half.to == f_) {
        at.to_f = &half;
        if (v == r_) at.add_back(half, first_of(~used_at(f_)));
      } else if (half.to < v) {
        at.add_back(half, label_towards(half.to, v));
      } else {
        at.forward[at.forwards++] = half;
      }
    }
    return at;
  }

  static bool has_clash(const HalfEdgesAt& view) {
    for (unsigned i = 0; i < view.backs; ++i) {
      for (unsigned j = 0; j < i; ++j) {
        if (view.back_label[i] == view.back_label[j]) return true;
      }
    }
    return false;
  }

  void label_at(Index v) {
    HalfEdgesAt view = look(v);
    if (v == r_) set_port(f_, first_of(~used_at(f_)), v);
    for (unsigned attempt = 0; attempt < 2 && has_clash(view) && repair(v, view); ++attempt) {
      for (unsigned i = 0; i < view.backs; ++i) {
        view.back_label[i] = label_towards(view.back[i].to, v);
      }
    }
    if (has_clash(view)) return settle_clash(v, view);
    for (unsigned i = 0; i < view.backs; ++i) set_port(v, view.back_label[i], view.back[i].to);
    ColourSet free = kAllColours & ~view.offered();
    if (view.to_f != nullptr && v != r_) free &= ~label_f_edge(v, free);
    label_forward(v, view, free);
  }

  void set_port(Index v, Colour label, Index to) { result_.ports[v].to[label] = to; }

  /// f gets its labels from its neighbours, so none of them but r ever clashes because of f.
  ColourSet label_f_edge(Index v, ColourSet free) {
    const ColourSet allowed = free & ~used_at(f_);
    expect(allowed != 0, "f and its neighbour share a free label");
    const Colour label = first_of(allowed);
    set_port(v, label, f_);
    set_port(f_, label, v);
    return only(label);
  }

  /// Distinct free labels for the forward half-edges, preferring labels that the other end has not
  /// been offered.
  void label_forward(Index v, const HalfEdgesAt& view, ColourSet free) {
    for (unsigned i = 0; i < view.forwards; ++i) {
      const Colour label = view.forward_label(i, free, received_);
      set_port(v, label, view.forward[i].to);
      received_[view.forward[i].to] |= static_cast<std::uint8_t>(only(label));
      free &= ~only(label);
    }
  }

  /// Follows, in turn, every Kempe chain that lets one of the clashing neighbours offer another
  /// label, and swaps the one that ends first.
  bool repair(Index v, const HalfEdgesAt& view) {
    std::array<Walker, 6> walkers;
    unsigned count = 0;
    for (unsigned i = 0; i < view.backs; ++i) {
      const Colour given = view.back_label[i];
      bool clashes = false;
      for (unsigned j = 0; j < view.backs; ++j) {
        clashes |= j != i && view.back_label[j] == given;
      }
      if (!clashes || result_.ports[view.back[i].to].has_defect != 0) continue;
      for (const Colour wanted : {next(given), previous(given)}) {
        // At r all three labels are offered, so only an unoffered label helps.
        if (view.backs == 3 && contains(view.offered(), wanted)) continue;
        walkers[count++] = {view.back[i].to, view.back[i].to, wanted, given, wanted};
      }
    }
    for (std::uint64_t round = 0; round < longest_chain_ && count > 0; ++round) {
      for (unsigned i = 0; i < count;) {
        if (budget_ == 0) return false;
        --budget_;
        const ChainStep step = advance(walkers[i], v);
        if (step == ChainStep::ends) {
          swap_labels(walkers[i], v);
          return true;
        }
        if (step == ChainStep::goes_on) {
          ++i;
        } else {
          walkers[i] = walkers[--count];
        }
      }
    }
    return false;
  }

  ChainStep advance(Walker& walker, Index v) const {
    const Index to = result_.ports[walker.at].to[walker.follow];
    if (to == v) return ChainStep::fails;
    if (to == kNoIndex || to > v) return ChainStep::ends;
    if (result_.ports[to].has_defect != 0) return ChainStep::fails;
    walker.at = to;
    walker.follow = walker.follow == walker.wanted ? walker.given : walker.wanted;
    return ChainStep::goes_on;
  }

  void swap_labels(const Walker& walker, Index v) {
    Colour follow = walker.wanted;
    for (Index at = walker.start; at != kNoIndex && at <= v;) {
      Ports& ports = result_.ports[at];
      const Index to = ports.to[follow];
      std::swap(ports.to[walker.wanted], ports.to[walker.given]);
      follow = follow == walker.wanted ? walker.given : walker.wanted;
      at = to;
    }
  }

  /// The labels of v's half-edges with the fewest defects, none of them with labels 0 and 1 if that
  /// can be.
  void settle_clash(Index v, const HalfEdgesAt& view) {
    static constexpr std::array<std::array<Colour, 3>, 6> kOrders = {
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    const auto cost = [&](const std::array<Colour, 3>& labels) {
      int sum = 0;
      for (unsigned i = 0; i < view.backs; ++i) {
        const Colour there = view.back_label[i];
        if (labels[i] != there) sum += labels[i] + there == 1 ? 50 : 10;
      }
      for (unsigned i = 0; i < view.forwards; ++i) {
        sum += contains(received_[view.forward[i].to], labels[view.backs + i]) ? 1 : 0;
      }
      return sum;
    };
    const auto& labels = *std::ranges::min_element(kOrders, {}, cost);
    result_.ports[v].has_defect = 1;
    for (unsigned i = 0; i < view.backs; ++i) {
      set_port(v, labels[i], view.back[i].to);
      if (labels[i] != view.back_label[i]) {
        add_defect(v, labels[i], view.back[i], view.back_label[i]);
      }
    }
    for (unsigned i = 0; i < view.forwards; ++i) {
      set_port(v, labels[view.backs + i], view.forward[i].to);
      received_[view.forward[i].to] |= static_cast<std::uint8_t>(only(labels[view.backs + i]));
    }
  }

  void add_defect(Index v, Colour label, const HalfEdge& back, Colour there) {
    if (label == 2) {
      result_.defects.push_back({back.to, v, back.edge, there, label});
    } else {
      result_.defects.push_back({v, back.to, back.edge, label, there});
    }
  }

  const ProcessingOrder& order_;
  const std::span<const PlacedRow> neighbours_;
  const std::uint64_t longest_chain_;
  std::uint64_t budget_;
  std::vector<std::uint8_t> received_;  // labels that earlier vertices sent to this index
  Colouring result_;
  Index f_ = kNoIndex;  // of the present component, if cubic
  Index r_ = kNoIndex;
};

}  // namespace

Colouring colour_half_edges(const ProcessingOrder& order, std::span<const PlacedRow> neighbours,
                            std::uint64_t longest_chain) {
  return Labeller(order, neighbours, longest_chain).run();
}

}  // namespace ar3d::grid
