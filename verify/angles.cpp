// Measures the angles of a drawing. Doubles decide what is far from the optimum, and exact integers
// decide the rest; a valid certificate of one exact angle spares both.
#include <cmath>
#include <numbers>

#include "ar3d/model/cosine_comparison.h"
#include "ar3d/verify/examination.h"
#include "ar3d/verify/predicates/widths.h"

namespace ar3d {
namespace {

constexpr Vector kNone{0, 0, 0};

double cosine_of(const Lattice& lattice, Vector u, Vector v) {
  using cosine_comparison::inner;
  const auto a = cosine_comparison::converted<double>(u);
  const auto b = cosine_comparison::converted<double>(v);
  const double lengths = std::sqrt(inner(lattice, a, a) * inner(lattice, b, b));
  return std::clamp(inner(lattice, a, b) / lengths, -1.0, 1.0);
}

// @pre degree <= 4.
Cosine optimal_cosine(std::uint32_t degree) { return degree <= 3 ? Cosine{-1, 2} : Cosine{-1, 3}; }

double degrees(double cosine) { return std::acos(cosine) * 180 / std::numbers::pi; }

class AngleMeasurer {
 public:
  explicit AngleMeasurer(const Drawing& drawing)
      : drawing_(drawing),
        lattice_(drawing.lattice()),
        first_(drawing.num_edges(), kNone),
        last_(drawing.num_edges(), kNone),
        is_optimal_(drawing.num_edges(), true),
        offsets_(drawing.num_vertices() + 1, 0) {}

  void run(DrawingSummary& summary) {
    group_by_vertex();
    const std::uint32_t degree = largest_degree();
    has_optimum_ = degree <= 4;
    if (has_optimum_) optimum_ = optimal_cosine(degree);
    if (has_optimum_) compare_with_optimum_.emplace(lattice_, optimum_);
    for_each_polyline(drawing_,
                      [this](EdgeId e, const std::vector<Point>& points) { add_bends(e, points); });
    add_vertices();
    if (largest_cosine_at_vertices_ != kNoAngle) {
      summary.smallest_vertex_angle = degrees(largest_cosine_at_vertices_);
    }
    if (largest_cosine_at_bends_ != kNoAngle) {
      summary.smallest_bend_angle = degrees(largest_cosine_at_bends_);
    }
    if (has_optimum_) {
      summary.optimal_edges = std::count(is_optimal_.begin(), is_optimal_.end(), true);
    }
  }

 private:
  static constexpr double kNoAngle = -2;  // less than every cosine

  // Edges by vertex, in order.
  void group_by_vertex() {
    for (EdgeId e = 0; e < drawing_.num_edges(); ++e) {
      ++offsets_[drawing_.edge(e).u + 1];
      ++offsets_[drawing_.edge(e).v + 1];
    }
    for (std::size_t v = 1; v < offsets_.size(); ++v) offsets_[v] += offsets_[v - 1];
    edges_.resize(offsets_.back());
    std::vector<std::uint32_t> next(offsets_.begin(), offsets_.end() - 1);
    for (EdgeId e = 0; e < drawing_.num_edges(); ++e) {
      edges_[next[drawing_.edge(e).u]++] = e;
      edges_[next[drawing_.edge(e).v]++] = e;
    }
  }
  std::uint32_t largest_degree() const {
    std::uint32_t largest = 0;
    for (std::size_t v = 1; v < offsets_.size(); ++v) {
      largest = std::max(largest, offsets_[v] - offsets_[v - 1]);
    }
    return largest;
  }

  void add_bends(EdgeId e, const std::vector<Point>& points) {
    Vector before = kNone;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vector step = points[i] - points[i - 1];
      if (step == kNone) {
        is_optimal_[e] = false;
        continue;
      }
      if (first_[e] == kNone) first_[e] = step;
      if (before != kNone) judge(-before, step, e, e, largest_cosine_at_bends_);
      before = step;
    }
    last_[e] = -before;
  }

  void add_vertices() {
    constexpr std::uint32_t kCrowd = 64;
    for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) {
      if (offsets_[v + 1] - offsets_[v] > kCrowd) {
        add_crowded_vertex(static_cast<Vertex>(v));
        continue;
      }
      for (std::uint32_t i = offsets_[v]; i < offsets_[v + 1]; ++i) {
        for (std::uint32_t j = i + 1; j < offsets_[v + 1]; ++j) {
          const Vector a = leaving(edges_[i], static_cast<Vertex>(v));
          const Vector b = leaving(edges_[j], static_cast<Vertex>(v));
          if (a == kNone || b == kNone) continue;
          judge(a, b, edges_[i], edges_[j], largest_cosine_at_vertices_);
        }
      }
    }
  }
  // Only the smallest angle is asked for, since more than four segments have no optimum. Unit
  // vectors are no closer in space than along a line, by which they are sorted.
  void add_crowded_vertex(Vertex v) {
    constexpr Vector kLine{129898, 782331, -377193};    // hardly at right angles to all of them
    std::vector<std::pair<double, Vector>> directions;  // by place on the line
    for (std::uint32_t i = offsets_[v]; i < offsets_[v + 1]; ++i) {
      const Vector step = leaving(edges_[i], v);
      if (step != kNone) directions.emplace_back(cosine_of(lattice_, step, kLine), step);
    }
    std::sort(directions.begin(), directions.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    double largest = -1;
    const auto compare_following = [&](std::size_t most) {
      constexpr double kEqual = 1 - 1e-15;
      for (std::size_t i = 0; i < directions.size() && largest < kEqual; ++i) {
        const auto& [from, step] = directions[i];
        const std::size_t end = i + std::min(most, directions.size() - 1 - i);
        for (std::size_t j = i + 1; j <= end && largest < kEqual; ++j) {
          if (directions[j].first - from > std::sqrt(2 - 2 * largest) + 1e-7) break;
          largest = std::max(largest, cosine_of(lattice_, step, directions[j].second));
        }
      }
    };
    compare_following(8);
    compare_following(directions.size());
    if (directions.size() > 1) {
      largest_cosine_at_vertices_ = std::max(largest_cosine_at_vertices_, largest);
    }
  }
  Vector leaving(EdgeId e, Vertex v) const {
    return drawing_.edge(e).u == v ? first_[e] : last_[e];
  }

  // Doubles decide what is far from the optimum, exact integers the rest.
  void judge(Vector a, Vector b, EdgeId e, EdgeId f, double& largest_cosine) {
    constexpr double kFar = 1e-9;
    const double cosine = cosine_of(lattice_, a, b);
    largest_cosine = std::max(largest_cosine, cosine);
    if (!has_optimum_ || (!is_optimal_[e] && !is_optimal_[f])) return;
    const double excess = cosine - static_cast<double>(optimum_.numerator) / optimum_.denominator;
    const bool is_smaller =
        std::abs(excess) > kFar ? excess > 0 : (*compare_with_optimum_)(a, b) > 0;
    if (is_smaller) is_optimal_[e] = is_optimal_[f] = false;
  }

  const Drawing& drawing_;
  const Lattice lattice_;
  std::vector<Vector> first_;  // segment at end u, away from it
  std::vector<Vector> last_;   // segment at end v, away from it
  std::vector<bool> is_optimal_;
  std::vector<std::uint32_t> offsets_;
  std::vector<EdgeId> edges_;
  bool has_optimum_ = false;
  Cosine optimum_;
  std::optional<verify::AngleComparison> compare_with_optimum_;
  double largest_cosine_at_vertices_ = kNoAngle;
  double largest_cosine_at_bends_ = kNoAngle;
};

// Are inner products of segments exact in double, and so the cosines of rational angles rounded
// once? Then u v / sqrt(uu vv) is the quotient of two integers that a double holds.
bool has_exact_products(const Lattice& lattice, const Box& box) {
  double largest_gram = 0, largest = 0;
  for (const auto& row : lattice.gram) {
    for (const std::int32_t entry : row)
      largest_gram = std::max(largest_gram, std::abs(1.0 * entry));
  }
  for (const std::int64_t extent : box.extents()) {
    largest = std::max(largest, static_cast<double>(extent));
  }
  return 9 * largest_gram * largest * largest < 0x1p53;
}

// All angles are the same: the optimum, or less than it at a bend of every edge. False if it takes
// a look at the drawing.
bool set_proved_angles(const Graph& graph, const Lattice& lattice, Cosine cosine,
                       DrawingSummary& summary) {
  const Cosine optimum = optimal_cosine(graph.max_degree());
  const bool is_optimal = cosine == optimum;
  const bool none_is_optimal = cosine == Cosine{-1, 3} && optimum == Cosine{-1, 2} &&
                               (summary.bend_histogram.empty() || summary.bend_histogram[0] == 0);
  if (!is_optimal && !(none_is_optimal && has_exact_products(lattice, summary.box))) return false;
  const double angle = degrees(static_cast<double>(cosine.numerator) / cosine.denominator);
  if (graph.max_degree() >= 2) summary.smallest_vertex_angle = angle;
  if (summary.bend_histogram.size() > 1) summary.smallest_bend_angle = angle;
  summary.optimal_edges = is_optimal ? graph.num_edges() : 0;
  return true;
}

bool is_contact(ViolationKind kind) {
  return kind == ViolationKind::crossing || kind == ViolationKind::vertex_on_edge ||
         kind == ViolationKind::same_point;
}

}  // namespace

void set_angles(const Drawing& drawing, DrawingSummary& summary) {
  AngleMeasurer(drawing).run(summary);
}

void set_angles_and_crossings(const Graph& graph, const Drawing& drawing,
                              const Guarantee& guarantee, const Certificate& certificate,
                              DrawingSummary& summary) {
  if (!summary.in_range) return;
  if (certificate.complete && certificate.mode == CertificateMode::exact) {
    summary.crossings = std::count_if(certificate.violations.begin(), certificate.violations.end(),
                                      [](const Violation& v) { return is_contact(v.kind); });
  }
  const bool is_proved =
      certificate.valid() && guarantee.angle_rule == AngleRule::exactly && graph.max_degree() <= 4;
  if (is_proved && set_proved_angles(graph, drawing.lattice(), guarantee.cosine, summary)) return;
  set_angles(drawing, summary);
}

}  // namespace ar3d
