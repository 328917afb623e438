// Step 3.2. The core's labels, without positions: greedy in processing order. A clash is only
// noted, since which of its two edges becomes the defect depends on plane numbers (Step 3.4).
// Labels of f are chosen late, so that no neighbour of f is a clash. O(n + m).
#include "ar3d/algorithms/grid/labels.h"

#include <algorithm>
#include <array>

#include "ar3d/base/error.h"

namespace ar3d::grid {
namespace {

class Labeller {
 public:
  Labeller(const PlacedGraph& graph, const ProcessingOrder& order)
      : graph_(graph),
        order_(order),
        labels_{EdgeLabels(graph.num_edges()), 0},
        received_(graph.num_vertices(), 0) {}

  Labels run() {
    for (const OrderPart& part : order_.parts) {
      const auto begin = static_cast<Place>(part.begin);
      const auto end = static_cast<Place>(part.end);
      f_ = part.cubic ? begin : kNoPlace;
      for (Place v = part.cubic ? begin + 1 : begin; v < (part.cubic ? end - 1 : end); ++v) {
        ask_ahead(v);
        label_at(v);
      }
      if (part.cubic) label_last(end - 1);
    }
    return std::move(labels_);
  }

 private:
  /// What the half-edges at a vertex v look like when v is processed.
  struct View {
    std::array<HalfEdge, 3> back{};  // to earlier vertices, labelled at the other end
    std::array<Colour, 3> back_label{};
    unsigned backs = 0;
    std::array<HalfEdge, 3> forward{};
    unsigned forwards = 0;
    const HalfEdge* to_f = nullptr;  // the edge to f, which is labelled lazily
  };

  /// The far ends of the edges that close cycles are nowhere near in memory.
  void ask_ahead(Place v) const {
    if (v + kAhead >= graph_.num_vertices()) return;
    for (const HalfEdge& half : graph_.incident(v + kAhead)) {
      labels_.of.ask_for(half.edge);
      __builtin_prefetch(&received_[half.to], 1);
    }
  }

  View look(Place v) const {
    View view;
    for (const HalfEdge& half : graph_.incident(v)) {
      const Colour there = labels_.of.at(half.edge, half.to, v);
      if (half.to == f_) {
        view.to_f = &half;
      } else if (there != kNoColour) {
        view.back_label[view.backs] = there;
        view.back[view.backs++] = half;
      } else {
        view.forward[view.forwards++] = half;
      }
    }
    return view;
  }

  void label_at(Place v) {
    const View view = look(v);
    expect(view.backs <= 2, "every vertex but the last has a later neighbour");
    if (is_clash(view)) return label_clash(v, view);
    ColourSet used = 0;
    for (unsigned i = 0; i < view.backs; ++i) used |= join(v, view.back[i], view.back_label[i]);
    if (view.to_f != nullptr) used |= label_f_edge(v, *view.to_f, used);
    label_forward(v, view, kAllColours & ~used);
  }

  static bool is_clash(const View& view) {
    return view.backs == 2 && view.back_label[0] == view.back_label[1];
  }

  /// Makes the edge a U-edge of the colour that its earlier end has chosen.
  ColourSet join(Place v, const HalfEdge& half, Colour label) {
    labels_.of.set(half.edge, v, half.to, label);
    return only(label);
  }

  /// Two earlier neighbours chose lambda: which of them gets the U-edge is decided with the
  /// positions.
  void label_clash(Place v, const View& view) {
    ++labels_.clashes;
    if (view.forwards == 0) return;
    const Colour label = next(view.back_label[0]);
    labels_.of.set(view.forward[0].edge, v, view.forward[0].to, label);
    received_[view.forward[0].to] |= static_cast<std::uint8_t>(only(label));
  }

  /// A label of f that v and f can both use; so no neighbour of f is a clash vertex.
  ColourSet label_f_edge(Place v, const HalfEdge& to_f, ColourSet used_at_v) {
    const ColourSet allowed = kAllColours & ~used_at_v & ~labels_at_f();
    expect(allowed != 0, "f and its neighbour share a free label");
    const Colour label = first_of(allowed);
    labels_.of.set(to_f.edge, v, f_, label);
    labels_.of.set(to_f.edge, f_, v, label);
    return only(label);
  }

  ColourSet labels_at_f() const {
    ColourSet used = 0;
    for (const HalfEdge& half : graph_.incident(f_)) {
      const Colour label = labels_.of.at(half.edge, f_, half.to);
      if (label != kNoColour) used |= only(label);
    }
    return used;
  }

  /// Distinct free labels for the forward half-edges, preferring labels that the other end has not
  /// received.
  void label_forward(Place v, const View& view, ColourSet free) {
    for (unsigned i = 0; i < view.forwards; ++i) {
      const HalfEdge& half = view.forward[i];
      ColourSet wanted = free & ~static_cast<ColourSet>(received_[half.to]);
      if (wanted == 0) wanted = free;
      if (i + 1 < view.forwards) {  // leave the next neighbour a label it has not received
        const HalfEdge& later = view.forward[i + 1];
        const ColourSet good_there = free & ~static_cast<ColourSet>(received_[later.to]);
        const ColourSet considerate = wanted & ~good_there;
        if (considerate != 0) wanted = considerate;
      }
      const Colour label = first_of(wanted);
      labels_.of.set(half.edge, v, half.to, label);
      received_[half.to] |= static_cast<std::uint8_t>(only(label));
      free &= ~only(label);
    }
  }

  /// r: an ordinary or clash vertex with back edges to its two neighbours other than f; then the
  /// edge fr gets the remaining labels phi at f and psi at r.
  void label_last(Place r) {
    const View view = look(r);
    expect(view.backs == 2 && view.to_f != nullptr, "r comes last and is a neighbour of f");
    ColourSet used = 0;
    Colour psi = next(view.back_label[0]);
    if (is_clash(view)) {
      ++labels_.clashes;
    } else {
      for (unsigned i = 0; i < 2; ++i) used |= join(r, view.back[i], view.back_label[i]);
      psi = first_of(kAllColours & ~used);
    }
    const EdgeId aside = view.to_f->edge;
    labels_.of.set(aside, r, f_, psi);
    labels_.of.set(aside, f_, r, first_of(kAllColours & ~labels_at_f()));
  }

  const PlacedGraph& graph_;
  const ProcessingOrder& order_;
  Labels labels_;
  std::vector<std::uint8_t> received_;  // labels of the half-edges that earlier vertices sent here
  Place f_ = kNoPlace;                  // of the current component, if cubic
};

}  // namespace

Labels label_half_edges(const PlacedGraph& graph, const ProcessingOrder& order) {
  return Labeller(graph, order).run();
}

}  // namespace ar3d::grid
