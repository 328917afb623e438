// Step 3.9. Greedy labels with repair: where two earlier neighbours offer one label, all Kempe
// chains (Kempe 1879) that would help are followed in turn, one step each, and the first that ends
// is swapped, so that a long chain costs no more than the shortest. Cost: O(n), as the chains have
// 100 steps per vertex in all.
#include "ar3d/algorithms/grid/colouring.h"

#include <algorithm>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d::grid {
namespace {

/// A Kempe chain being followed: it begins at w with the label `wanted` and alternates with the
/// label `given` that w's half-edge to v has. Swapping the two labels on it frees `given` at w.
struct Walker {
  Place start = 0;
  Place at = 0;
  Colour wanted = 0;
  Colour given = 0;
  Colour follow = 0;
};

enum class Walk : std::uint8_t { goes_on, ends, fails, meets_v };

class Labeller {
 public:
  Labeller(const ProcessingOrder& order, std::span<const NeighbourPlaces> neighbours,
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
      const auto begin = static_cast<Place>(part.begin);
      const auto end = static_cast<Place>(part.end);
      f_ = part.cubic ? begin : kNoPlace;
      r_ = part.cubic ? end - 1 : kNoPlace;
      for (Place v = part.cubic ? begin + 1 : begin; v < end; ++v) {
        ask_for_ports(v + kAhead);
        label_at(v);
      }
    }
    result_.chain_steps = kStepsPerVertex * neighbours_.size() + 1000 - budget_;
    return std::move(result_);
  }

 private:
  /// The half-edges at a vertex v when it is processed.
  struct View {
    struct Back {
      Place from = 0;
      EdgeId edge = 0;
      Colour label = 0;  // at the other end
    };
    std::array<Back, 3> back;
    unsigned backs = 0;
    std::array<Place, 3> forward{};
    unsigned forwards = 0;
    bool next_to_f = false;
    ColourSet offered() const {
      ColourSet set = 0;
      for (unsigned i = 0; i < backs; ++i) set |= only(back[i].label);
      return set;
    }
  };

  /// Memory of v's neighbours, which label_at(v) reads, on its way.
  [[gnu::always_inline]] void ask_for_ports(Place v) const {
    if (v >= neighbours_.size()) return;
    for (const Place to : neighbours_[v].to) __builtin_prefetch(&result_.ports[to], 1);
  }

  Colour label_towards(Place from, Place to) const {
    const Ports& ports = result_.ports[from];
    return ports.to[0] == to ? 0 : ports.to[1] == to ? 1 : 2;
  }
  ColourSet used_at(Place v) const {
    ColourSet used = 0;
    for (Colour c = 0; c < kColours; ++c) {
      if (result_.ports[v].to[c] != kNoPlace) used |= only(c);
    }
    return used;
  }

  View look(Place v) const {
    View view;
    const NeighbourPlaces& own = neighbours_[v];
    for (unsigned i = 0; i < own.degree; ++i) {
      const Place to = own.to[i];
      if (to == f_) {
        view.next_to_f = true;
        if (v == r_) view.back[view.backs++] = {f_, own.edge[i], first_of(~used_at(f_))};
      } else if (to < v) {
        view.back[view.backs++] = {to, own.edge[i], label_towards(to, v)};
      } else {
        view.forward[view.forwards++] = to;
      }
    }
    return view;
  }

  static bool has_clash(const View& view) {
    for (unsigned i = 0; i < view.backs; ++i) {
      for (unsigned j = 0; j < i; ++j) {
        if (view.back[i].label == view.back[j].label) return true;
      }
    }
    return false;
  }

  void label_at(Place v) {
    View view = look(v);
    if (v == r_) set_port(f_, first_of(~used_at(f_)), v);
    for (unsigned attempt = 0; attempt < 2 && has_clash(view) && repair(v, view); ++attempt) {
      ++result_.repairs;
      for (unsigned i = 0; i < view.backs; ++i) {
        view.back[i].label = label_towards(view.back[i].from, v);
      }
    }
    if (has_clash(view)) return settle_clash(v, view);
    for (unsigned i = 0; i < view.backs; ++i) set_port(v, view.back[i].label, view.back[i].from);
    ColourSet free = kAllColours & ~view.offered();
    if (view.next_to_f && v != r_) free &= ~label_f_edge(v, free);
    label_forward(v, view, free);
  }

  void set_port(Place v, Colour label, Place to) { result_.ports[v].to[label] = to; }

  /// f gets its labels from its neighbours, so none of them but r ever clashes because of f.
  ColourSet label_f_edge(Place v, ColourSet free) {
    const ColourSet allowed = free & ~used_at(f_);
    expect(allowed != 0, "f and its neighbour share a free label");
    const Colour label = first_of(allowed);
    set_port(v, label, f_);
    set_port(f_, label, v);
    return only(label);
  }

  /// Distinct free labels for the forward half-edges, preferring labels that the other end has not
  /// been offered.
  void label_forward(Place v, const View& view, ColourSet free) {
    for (unsigned i = 0; i < view.forwards; ++i) {
      const Place to = view.forward[i];
      ColourSet wanted = free & ~static_cast<ColourSet>(received_[to]);
      if (wanted == 0) wanted = free;
      if (i + 1 < view.forwards) {  // leave the next neighbour a label that it can use
        const auto taken_there = static_cast<ColourSet>(received_[view.forward[i + 1]]);
        const ColourSet considerate = wanted & ~(free & ~taken_there);
        if (considerate != 0) wanted = considerate;
      }
      const Colour label = first_of(wanted);
      set_port(v, label, to);
      received_[to] |= static_cast<std::uint8_t>(only(label));
      free &= ~only(label);
    }
  }

  /// Follows, in turn, every Kempe chain that lets one of the clashing neighbours offer another
  /// label, and swaps the one that ends first.
  bool repair(Place v, const View& view) {
    std::array<Walker, 6> walkers;
    unsigned count = 0;
    for (unsigned i = 0; i < view.backs; ++i) {
      const Colour given = view.back[i].label;
      bool clashes = false;
      for (unsigned j = 0; j < view.backs; ++j) {
        clashes |= j != i && view.back[j].label == given;
      }
      if (!clashes || result_.ports[view.back[i].from].has_defect != 0) continue;
      for (const Colour wanted : {next(given), previous(given)}) {
        // At r all three labels are offered, so only an unoffered label helps.
        if (view.backs == 3 && contains(view.offered(), wanted)) continue;
        walkers[count++] = {view.back[i].from, view.back[i].from, wanted, given, wanted};
      }
    }
    for (std::uint64_t step = 0; step < longest_chain_ && count > 0; ++step) {
      for (unsigned i = 0; i < count;) {
        if (budget_ == 0) return false;
        --budget_;
        const Walk walk = advance(walkers[i], v);
        if (walk == Walk::ends) {
          swap_labels(walkers[i], v);
          return true;
        }
        if (walk == Walk::goes_on) {
          ++i;
        } else {
          walkers[i] = walkers[--count];
        }
      }
    }
    return false;
  }

  Walk advance(Walker& walker, Place v) const {
    const Place to = result_.ports[walker.at].to[walker.follow];
    if (to == v) return Walk::meets_v;
    if (to == kNoPlace || to > v) return Walk::ends;
    if (result_.ports[to].has_defect != 0) return Walk::fails;
    walker.at = to;
    walker.follow = walker.follow == walker.wanted ? walker.given : walker.wanted;
    return Walk::goes_on;
  }

  void swap_labels(const Walker& walker, Place v) {
    Colour follow = walker.wanted;
    for (Place at = walker.start; at != kNoPlace && at <= v;) {
      Ports& ports = result_.ports[at];
      const Place to = ports.to[follow];
      std::swap(ports.to[walker.wanted], ports.to[walker.given]);
      follow = follow == walker.wanted ? walker.given : walker.wanted;
      at = to;
    }
  }

  /// The labels of v's half-edges with the fewest defects, none of them with labels 0 and 1 if that
  /// can be.
  void settle_clash(Place v, const View& view) {
    static constexpr std::array<std::array<Colour, 3>, 6> kOrders = {
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    const auto cost = [&](const std::array<Colour, 3>& labels) {
      int sum = 0;
      for (unsigned i = 0; i < view.backs; ++i) {
        const Colour there = view.back[i].label;
        if (labels[i] != there) sum += labels[i] + there == 1 ? 50 : 10;
      }
      for (unsigned i = 0; i < view.forwards; ++i) {
        sum += contains(received_[view.forward[i]], labels[view.backs + i]) ? 1 : 0;
      }
      return sum;
    };
    const auto& labels = *std::ranges::min_element(kOrders, {}, cost);
    result_.ports[v].has_defect = 1;
    for (unsigned i = 0; i < view.backs; ++i) {
      set_port(v, labels[i], view.back[i].from);
      if (labels[i] != view.back[i].label) add_defect(v, labels[i], view.back[i]);
    }
    for (unsigned i = 0; i < view.forwards; ++i) {
      set_port(v, labels[view.backs + i], view.forward[i]);
      received_[view.forward[i]] |= static_cast<std::uint8_t>(only(labels[view.backs + i]));
    }
  }

  void add_defect(Place v, Colour label, const View::Back& back) {
    if (label == 2) {
      result_.defects.push_back({back.from, v, back.edge, back.label, label});
    } else {
      result_.defects.push_back({v, back.from, back.edge, label, back.label});
    }
  }

  const ProcessingOrder& order_;
  const std::span<const NeighbourPlaces> neighbours_;
  const std::uint64_t longest_chain_;
  std::uint64_t budget_;
  std::vector<std::uint8_t> received_;  // labels that earlier vertices sent to this place
  Colouring result_;
  Place f_ = kNoPlace;  // of the present component, if cubic
  Place r_ = kNoPlace;
};

}  // namespace

Colouring colour_half_edges(const ProcessingOrder& order,
                            std::span<const NeighbourPlaces> neighbours,
                            std::uint64_t longest_chain) {
  return Labeller(order, neighbours, longest_chain).run();
}

}  // namespace ar3d::grid
