// Step 3.2. The core's labels, without positions: greedy in processing order. A clash is only
// noted, since which of its two edges becomes the defect depends on plane numbers (Step 3.4).
// Labels of f are chosen late, so that no neighbour of f is a clash. O(n + m).
#include "ar3d/algorithms/grid/labels.h"

#include "ar3d/base/error.h"

namespace ar3d::grid {
namespace {

class CoreLabeller {
 public:
  CoreLabeller(const PlacedGraph& graph, const ProcessingOrder& order)
      : graph_(graph),
        order_(order),
        labels_(graph.num_edges()),
        received_(graph.num_vertices(), 0) {}

  EdgeLabels run() {
    for (const OrderPart& part : order_.parts) {
      f_ = part.cubic ? part.begin : kNoIndex;
      const Index ends = part.cubic ? 1 : 0;
      for (Index v = part.begin + ends; v < part.end - ends; ++v) {
        prefetch_ahead(v);
        label_at(v);
      }
      if (part.cubic) label_last(part.end - 1);
    }
    return std::move(labels_);
  }

 private:
  /// The far ends of the edges that close cycles are nowhere near in memory.
  void prefetch_ahead(Index v) const {
    if (v + kAhead >= graph_.num_vertices()) return;
    for (const HalfEdge& half : graph_.incident(v + kAhead)) {
      labels_.prefetch(half.edge);
      __builtin_prefetch(&received_[half.to], 1);
    }
  }

  HalfEdgesAt look(Index v) const {
    HalfEdgesAt view;
    for (const HalfEdge& half : graph_.incident(v)) {
      const Colour there = labels_.at(half.edge, half.to, v);
      if (half.to == f_) {
        view.to_f = &half;
      } else if (there != kNoColour) {
        view.add_back(half, there);
      } else {
        view.forward[view.forwards++] = half;
      }
    }
    return view;
  }

  void label_at(Index v) {
    const HalfEdgesAt view = look(v);
    expect(view.backs <= 2, "every vertex but the last has a later neighbour");
    if (is_clash(view)) return label_clash(v, view);
    ColourSet used = 0;
    for (unsigned i = 0; i < view.backs; ++i) used |= join(v, view.back[i], view.back_label[i]);
    if (view.to_f != nullptr) used |= label_f_edge(v, *view.to_f, used);
    label_forward(v, view, kAllColours & ~used);
  }

  static bool is_clash(const HalfEdgesAt& view) {
    return view.backs == 2 && view.back_label[0] == view.back_label[1];
  }

  /// Makes the edge a U-edge of the colour that its earlier end has chosen.
  ColourSet join(Index v, const HalfEdge& half, Colour label) {
    labels_.set(half.edge, v, half.to, label);
    return only(label);
  }

  /// Two earlier neighbours chose lambda: which of them gets the U-edge is decided with the
  /// positions.
  void label_clash(Index v, const HalfEdgesAt& view) {
    if (view.forwards == 0) return;
    const Colour label = next(view.back_label[0]);
    labels_.set(view.forward[0].edge, v, view.forward[0].to, label);
    received_[view.forward[0].to] |= static_cast<std::uint8_t>(only(label));
  }

  /// A label of f that v and f can both use; so no neighbour of f is a clash vertex.
  ColourSet label_f_edge(Index v, const HalfEdge& to_f, ColourSet used_at_v) {
    const ColourSet allowed = kAllColours & ~used_at_v & ~labels_at_f();
    expect(allowed != 0, "f and its neighbour share a free label");
    const Colour label = first_of(allowed);
    labels_.set(to_f.edge, v, f_, label);
    labels_.set(to_f.edge, f_, v, label);
    return only(label);
  }

  ColourSet labels_at_f() const {
    ColourSet used = 0;
    for (const HalfEdge& half : graph_.incident(f_)) {
      const Colour label = labels_.at(half.edge, f_, half.to);
      if (label != kNoColour) used |= only(label);
    }
    return used;
  }

  void label_forward(Index v, const HalfEdgesAt& view, ColourSet free) {
    for (unsigned i = 0; i < view.forwards; ++i) {
      const HalfEdge& half = view.forward[i];
      const Colour label = view.forward_label(i, free, received_);
      labels_.set(half.edge, v, half.to, label);
      received_[half.to] |= static_cast<std::uint8_t>(only(label));
      free &= ~only(label);
    }
  }

  /// r: an ordinary or clash vertex with back edges to its two neighbours other than f; then the
  /// edge fr gets the remaining labels phi at f and psi at r.
  void label_last(Index r) {
    const HalfEdgesAt view = look(r);
    expect(view.backs == 2 && view.to_f != nullptr, "r comes last and is a neighbour of f");
    ColourSet used = 0;
    Colour psi = next(view.back_label[0]);
    if (!is_clash(view)) {
      for (unsigned i = 0; i < 2; ++i) used |= join(r, view.back[i], view.back_label[i]);
      psi = first_of(kAllColours & ~used);
    }
    const EdgeId aside = view.to_f->edge;
    labels_.set(aside, r, f_, psi);
    labels_.set(aside, f_, r, first_of(kAllColours & ~labels_at_f()));
  }

  const PlacedGraph& graph_;
  const ProcessingOrder& order_;
  EdgeLabels labels_;
  std::vector<std::uint8_t> received_;  // labels of the half-edges that earlier vertices sent here
  Index f_ = kNoIndex;                  // of the current component, if cubic
};

}  // namespace

EdgeLabels label_half_edges(const PlacedGraph& graph, const ProcessingOrder& order) {
  return CoreLabeller(graph, order).run();
}

}  // namespace ar3d::grid
