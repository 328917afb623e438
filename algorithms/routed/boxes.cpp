// Steps R.6 to R.8, the boxes. The placement is scaled into a first box, which grows by layers while
// few edges in conflict are left. Then the layout is scaled into smaller boxes, all edges routed
// anew, until that fails once. Layers are cut off after that, one face after the other, and only what
// lay in them is routed anew. At last other layouts are tried. Cost: the searches, of which each
// effort has a count; a box holds 5 bytes a point.
#include "ar3d/algorithms/routed/boxes.h"

#include <algorithm>
#include <cstdlib>

#include "ar3d/algorithms/routed/check.h"
#include "ar3d/algorithms/routed/layouts.h"
#include "ar3d/base/error.h"

namespace ar3d::routed {
namespace {

constexpr std::uint64_t kSeed = 0x726f75746564;  // any fixed number
constexpr std::uint64_t kStepsPerVertex = 4000;  // of the annealing
constexpr int kPatience = 25;                    // rounds without gain, all edges routed anew
constexpr int kPatienceOfCuts = 15;
constexpr int kPatienceOfScattered = 6;
constexpr std::uint64_t kSearchesOfScaled = 6;  // for each edge, in a box that is scaled
constexpr std::uint64_t kEasySearches = 5;      // for each edge, in a box far too large
constexpr int kFirstBoxes = 10;
constexpr int kMostLayers = 5;              // that a box grows by before it is given up
constexpr std::uint64_t kMostOfSmall = 16;  // vertices of graphs that start on random points
constexpr std::uint64_t kMostEdgesOfSmall = 24;
constexpr std::uint64_t kMostPlaced = 50000;  // vertices, by other starts

class BoxSearch {
 public:
  BoxSearch(const Graph& graph, const PointClass& points, int bends, int effort,
            std::int64_t most_bytes, BoxCounts& counts)
      : graph_(graph),
        points_(points),
        bends_(bends),
        effort_(effort),
        most_bytes_(most_bytes),
        counts_(counts) {}

  std::optional<Routing> run() {
    const std::uint64_t edges = graph_.num_edges();
    const std::uint64_t most = bends_ == 3 ? std::max(12 * edges + 10000, 16 * edges)
                                           : std::min(25 * edges + 20000, 10 * edges + 50000);
    const std::uint64_t usual = std::min(150 * edges + 2500, most);  // of effort 1
    const std::uint64_t most_times = is_small() ? 20 : 10;
    most_searches_ = 2 * usual;
    if (find_first() && effort_ > 0) {
      most_searches_ = counts_.searches + (effort_ == 2 ? most_times * usual : usual);
      scale_down();
      cut_off_layers();
      try_other_starts();
    }
    expect(!best_ || is_drawing(graph_, points_, bends_, *best_),
           "a routing without conflicts is a drawing");
    return std::move(best_);
  }

 private:
  bool is_small() const {
    return graph_.num_vertices() <= kMostOfSmall && graph_.num_edges() <= kMostEdgesOfSmall;
  }
  bool may_go_on() const { return counts_.searches < most_searches_; }

  /// Negotiates in a box; the routing is the best one if it is a drawing.
  bool try_box(Routing given, int patience) {
    const std::int64_t bytes = CostBox::bytes(points_, given.layout.limits);
    if (bytes > most_bytes_ || !may_go_on()) return false;
    counts_.bytes = std::max(counts_.bytes, bytes);
    ++counts_.boxes;
    Negotiation negotiation(graph_, points_, bends_, std::move(given),
                            mix_seed(kSeed, static_cast<std::uint64_t>(counts_.boxes)));
    const std::size_t conflicts = negotiation.run(patience, most_searches_ - counts_.searches);
    searches_of_box_ = negotiation.searches();
    counts_.searches += searches_of_box_;
    last_ = negotiation.routing();
    if (conflicts > 0) {
      counts_.conflicts = conflicts;
      return false;
    }
    ++counts_.legal;
    best_ = last_;
    best_->layout.limits = tight_limits(graph_, points_, last_);
    return true;
  }

  bool find_first() {
    const Placement placement = place(graph_, kStepsPerVertex, RandomStream(kSeed, 1));
    const auto frames = choose_frames(graph_, points_, bends_, RandomStream(kSeed, 2));
    Limits box = first_box(points_, bends_, graph_.num_vertices());
    box.high = room_for(placement, box.high.x) * Spot{1, 1, 1};
    for (int go = 0; go < kFirstBoxes; ++go) {
      const auto layout = spread(points_, placement, frames, box);
      if (layout && (try_box({*layout, {}}, kPatience) || grow())) return true;
      box.high = box.high + (1 + box.longest() / 10) * Spot{1, 1, 1};
    }
    return false;
  }

  /// The last point of a side for a placement: boxes of `last` suit random graphs, whose edges take
  /// about a fifth of the cells in a row. Tori and trees have shorter ones.
  int room_for(const Placement& placement, int last) const {
    std::int64_t length = 0;  // of all edges, in hundredths of a cell
    for (const Edge& edge : graph_.edges()) {
      const Spot d = placement.of[edge.u] - placement.of[edge.v];
      length += 100 * std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    const auto edges = static_cast<std::int64_t>(graph_.num_edges());
    const std::int64_t usual = edges * placement.cells.x * (points_.is_body() ? 22 : 18);
    if (10 * length >= 7 * usual) return last;
    int least = last;
    while (least * least * usual > last * last * length) --least;
    return least;
  }

  /// Adds layers on all faces while few edges in conflict are left; all routes stay.
  bool grow() {
    for (int layers = 0; layers < kMostLayers; ++layers) {
      if (counts_.conflicts > 12 + graph_.num_edges() / 25) return false;
      Limits& limits = last_.layout.limits;
      limits = {limits.low - Spot{1, 1, 1}, limits.high + Spot{1, 1, 1}};
      if (try_box(last_, kPatience)) return true;
    }
    return false;
  }

  /// Boxes of sides smaller by 5 %, until one is not legal soon; by 20 % while that takes few
  /// searches, as in the first boxes of trees and grids.
  void scale_down() {
    const std::uint64_t most = most_searches_;
    bool is_easy = searches_of_box_ <= kEasySearches * graph_.num_edges();
    while (may_go_on()) {
      const Spot sides = best_->layout.limits.sides();
      const int share = is_easy ? 5 : 20;
      const auto last = [&](int side) { return side - 1 - std::max(1, side / share); };
      const Limits box{{0, 0, 0}, {last(sides.x), last(sides.y), last(sides.z)}};
      if (box.high.x < 1 || box.high.y < 1 || box.high.z < 1) return;
      const auto layout = rescaled(points_, best_->layout, box);
      most_searches_ = std::min(most, counts_.searches + kSearchesOfScaled * graph_.num_edges());
      const bool is_legal = layout && try_box({*layout, {}}, kPatience);
      most_searches_ = most;
      if (!is_legal && !is_easy) return;
      is_easy = is_legal && searches_of_box_ <= kEasySearches * graph_.num_edges();
    }
  }

  /// One layer at a time, until none of the six faces can lose one in two goes.
  void cut_off_layers() {
    int failed = 0;
    for (int face = 0; failed < 12 && may_go_on(); face = (face + 1) % 6) {
      Limits box = best_->layout.limits;
      const Spot unit = {face % 3 == 0, face % 3 == 1, face % 3 == 2};
      if (face < 3) {
        box.high = box.high - unit;
      } else {
        box.low = box.low + unit;
      }
      ++failed;
      if (box.sides().x < 1 || box.sides().y < 1 || box.sides().z < 1) continue;
      auto smaller = cut(graph_, points_, *best_, box);
      if (smaller && try_box(std::move(*smaller), kPatienceOfCuts)) failed = 0;
    }
  }

  /// New layouts in boxes of fewer points, for the searches that are left.
  void try_other_starts() {
    const std::uint64_t most = kMostPlaced / graph_.num_vertices();
    for (std::uint64_t start = 0; start < most && may_go_on(); ++start) {
      const auto layout = is_small() ? scattered(start) : placed_anew(start);
      const int patience = is_small() ? kPatienceOfScattered : kPatience;
      if (layout && try_box({*layout, {}}, patience)) cut_off_layers();
    }
  }

  /// Random points, in a box of random sides that holds at most a third fewer points.
  std::optional<Layout> scattered(std::uint64_t start) {
    RandomStream random(kSeed, 3 + start);
    const Spot best = best_->layout.limits.sides();
    const int most = best.x * best.y * best.z;
    std::vector<Spot> boxes;
    for (int x = 2; x * x * x < most; ++x) {
      for (int y = x; x * y * y < most; ++y) {
        for (int z = y; x * y * z < most; ++z) {
          if (3 * x * y * z >= 2 * most && z <= 2 * y) boxes.push_back({x, y, z});
        }
      }
    }
    if (boxes.empty()) return std::nullopt;
    const auto coin = [&] { return static_cast<int>(random.below(2)); };
    const Spot low = {coin(), coin(), coin()};  // which points are in the class
    const Spot sides = boxes[random.below(static_cast<std::uint32_t>(boxes.size()))];
    Layout layout{{low, low + sides - Spot{1, 1, 1}}, {}, {}};
    for (int i = 0; i < sides.x * sides.y * sides.z; ++i) {
      const Spot p = low + Spot{i % sides.x, i / sides.x % sides.y, i / sides.x / sides.y};
      if (points_.contains(p)) layout.at.push_back(p);
    }
    if (layout.at.size() < graph_.num_vertices()) return std::nullopt;
    random.shuffle(std::span(layout.at));
    layout.at.resize(graph_.num_vertices());
    const auto frames =
        points_.is_body() && coin() == 0 ? 1 : static_cast<std::uint32_t>(points_.frames().size());
    for (std::size_t v = 0; v < layout.at.size(); ++v) {
      layout.frame.push_back(static_cast<std::uint8_t>(random.below(frames)));
    }
    return layout;
  }

  /// Another placement, in the best box without a layer.
  std::optional<Layout> placed_anew(std::uint64_t start) {
    Limits box = best_->layout.limits;
    box.high = box.high - Spot{start % 3 == 0, start % 3 == 1, start % 3 == 2};
    return spread(points_, place(graph_, kStepsPerVertex, RandomStream(kSeed, 3 + start)),
                  choose_frames(graph_, points_, bends_, RandomStream(kSeed, 4 + start)), box);
  }

  const Graph& graph_;
  const PointClass& points_;
  int bends_;
  int effort_;
  std::int64_t most_bytes_;
  BoxCounts& counts_;
  std::uint64_t most_searches_ = 0;
  std::uint64_t searches_of_box_ = 0;  // of the last one
  std::optional<Routing> best_;
  Routing last_;
};

}  // namespace

Limits first_box(const PointClass& points, int bends, std::uint64_t n) {
  // c sqrt(n) + 3, c in twentieths; it grows if no box is legal.
  const std::int64_t above = n > 1000 ? static_cast<std::int64_t>(n) - 1000 : 0;
  const std::int64_t c =
      points.is_body()
          ? (bends == 5 ? 45 + above * 3 / 1000 : 60 + std::min<std::int64_t>(above, 4000) / 80)
          : (bends == 5 ? 22 + above / 1200 : 28 + above * 9 / 5000);
  std::int64_t side = 0;
  while (400 * side * side < c * c * static_cast<std::int64_t>(n)) ++side;
  side += 3;
  const int last = static_cast<int>(side) - 1;
  return {{0, 0, 0}, {last, last, last}};
}

std::optional<Routing> smallest_routing(const Graph& graph, const PointClass& points, int bends,
                                        int effort, std::int64_t most_bytes, BoxCounts& counts) {
  return BoxSearch(graph, points, bends, effort, most_bytes, counts).run();
}

}  // namespace ar3d::routed
