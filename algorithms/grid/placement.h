#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ar3d/algorithms/grid/number_search.h"
#include "ar3d/algorithms/grid/order.h"
#include "ar3d/algorithms/grid/planes.h"
#include "ar3d/base/random.h"

namespace ar3d::grid {

/// The constants of Lemmas 3.4 and 3.5, for n vertices.
struct ZoneProof {
  std::int64_t n = 0;
  /// Twice the number of candidates that taken numbers (3n), their neighbours (9n in triple
  /// searches), sums of two vertices (2n) and joined vertices (18) can spoil.
  std::int64_t sure_length() const { return 10 * n + 36; }
  std::int64_t sure_triple_length() const { return 22 * n + 36; }
  /// Every ordinary number fits into [-far_window, far_window].
  std::int64_t far_window() const { return 5 * n + 18; }
  /// Numbers of other vertices than f and r never pass this.
  std::int64_t largest_zone() const { return 11 * n + 20; }
  /// Below this, X_gamma(w) forces Rule 3.1 (NT).
  std::int64_t lowest_for_pq() const { return -(61 * n + 100); }
  /// Half width of the preferred window: it has 1.1 n numbers, of which a colour takes about n.
  std::int64_t window() const { return std::min(55 * n / 100 + 3, far_window() - 1); }
};

/// One attempt to place one component with a given zone (-zone, zone) for ordinary numbers.
class Placement {
 public:
  /// @param part  the component; vertices and edges are those of the placed graph throughout.
  /// @param planes  has the component's labels; receives its numbers, slots and counts.
  Placement(const PlacedGraph& graph, const OrderPart& part, Planes& planes, std::int64_t window,
            std::int64_t zone);

  /// False if an ordinary number did not fit into the zone; then `planes` is as before.
  bool place_all();

 private:
  /// The edge fr that is set aside in a cubic component, and where f stands.
  struct Aside {
    Vertex f = 0;
    Vertex r = 0;
    EdgeId edge = 0;
    Colour phi = 0;            // label at f
    Colour psi = 0;            // label at r
    Colour p = 0;              // phi + 1; x_p is f's neighbour along it
    Colour m = 0;              // phi - 1
    std::int64_t a = 0;        // X_p(f), below every other number of colour p that matters
    std::int64_t a_prime = 0;  // kept for x_m's forward plane of colour p
    std::int64_t b = 0;        // X_m(f)
    bool is_defect() const { return phi != psi; }
  };
  /// A vertex about to be placed.
  struct Site {
    Vertex v = 0;
    std::array<HalfEdge, 3> forward{};  // by colour; valid where forward_colours says so
    ColourSet forward_colours = 0;
    std::array<HalfEdge, 2> open{};  // a clash vertex's two edges without label at v
    unsigned opens = 0;
    bool next_to_f = false;
    Colour label_to_f = 0;
    SumRule rule;  // joined: the sums of the neighbours along U-edges
  };

  /// A clash at v: lambda is the U-edge to w', the edge to w is the defect (w: lambda, v: lambda -
  /// 1).
  struct Clash {
    const Site* site = nullptr;
    HalfEdge w;
    HalfEdge w_prime;
    Colour lambda = 0;
    Colour beta = 0;         // lambda - 1, the colour of L
    Colour gamma = 0;        // lambda + 1, the colour of H
    std::int64_t a = 0;      // A = X_lambda(w) - X_lambda(w') > 0
    std::int64_t plane = 0;  // X_lambda(w') = X_lambda(v)
    std::int64_t w_beta = 0;
    std::int64_t w_gamma = 0;
    bool closes_u_edge = false;  // v = r and psi = phi: H is X_phi(f), too
  };

  /// Ordinary numbers of this component must stay inside the zone, since f will stand outside it.
  bool zoned() const { return part_.cubic && aside_.is_defect(); }
  bool place_vertices();
  void prefetch_ahead(Index v) const;
  void undo();
  Site look(Vertex v) const;
  bool is_placed(Vertex v) const;

  void set_aside();
  void place_f();
  void place_f_of_defect();
  bool place_ordinary(const Site& site);
  bool place_x_m(const Site& site);
  bool place_clash(const Site& site);
  bool place_clash_nt(const Clash& clash);
  bool place_clash_pq(const Clash& clash);
  Clash look_at_clash(const Site& site) const;
  std::int64_t highest_low_number(const Clash& clash) const;
  void settle_clash(const Clash& clash, std::int64_t high, std::int64_t low);
  bool place_last();
  bool place_r(const Site& site);
  void close_defect_m();
  void close_defect_p();
  void settle_f(std::int64_t number);
  SumRule f_rule() const;
  std::optional<SumRule> apart_rule(const Site& site, Colour c) const;

  /// A free number of colour c: at random in the window, else near it, in the zone.
  std::optional<std::int64_t> choose(Colour c, std::span<const SumRule> rules);
  std::optional<std::int64_t> random_in_window(Colour c, std::span<const SumRule> rules);

  bool choose_colours(const Site& site, ColourSet colours);
  ColourSet missing_colours(Vertex v) const;
  void assign(const Site& site, Colour c, std::int64_t number);
  void take(Colour c, std::int64_t number);
  void finish(const Site& site);

  const PlacedGraph& graph_;
  const OrderPart part_;
  const ZoneProof proof_;
  const std::int64_t window_;
  const std::int64_t zone_;

  Planes& planes_;
  const PlaneCounts counts_before_;
  const std::size_t slots_before_;
  std::array<NumberSet, kColours> taken_;
  std::array<NumberSet, kColours> near_taken_;  // x with x, x-1 or x-2 taken
  NumberSet sums_;
  RandomStream random_;
  NumberSearch search_;
  NumberSearch triple_search_;

  Aside aside_;
  std::vector<std::pair<Vertex, HalfEdge>> clash_edges_;  // labelled here, open before
};

}  // namespace ar3d::grid
