// Draws and judges one graph of a search. Seeded faults break finished drawings on purpose; with
// them tests show that searching and shrinking find what they should.
#include <fmt/ranges.h>

#include <functional>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/bench/search/hunt.h"
#include "ar3d/verify/certificate.h"

namespace ar3d {

bool has_edge(const Graph& graph, Vertex u, Vertex v) {
  const auto edges = graph.incident(u);
  return std::any_of(edges.begin(), edges.end(),
                     [v](const HalfEdge& half) { return half.to == v; });
}

namespace {

std::array<double, 3> bound_of(const Subject& subject, const Graph& graph, const Drawing& drawing) {
  std::array<double, 3> bound{};
  if (graph.num_vertices() == 0) return bound;
  const Algorithm& algorithm = *subject.choice.algorithm;
  if (algorithm.guarantee.claim == Claim::measured) {
    throw InputError(fmt::format("{} promises no box to search against", algorithm.name));
  }
  if (subject.against_instance && !drawing.instance_bound) {
    throw InputError(fmt::format("{} states no bound for the instance", algorithm.name));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bound[axis] = subject.against_instance
                      ? static_cast<double>((*drawing.instance_bound)[axis])
                      : algorithm.guarantee.bound.axes[axis].value(graph.num_vertices());
  }
  return bound;
}

double ratio_of(const Trial& trial, const std::string& measure) {
  std::array<double, 3> share{};
  double volume = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto extent = static_cast<double>(trial.extents[axis]);
    if (trial.bound[axis] > 0) share[axis] = extent / trial.bound[axis];
    volume *= (extent + 1) / (trial.bound[axis] + 1);
  }
  if (measure == "volume") return volume;
  if (measure == "side") return std::ranges::max(share);
  return share.at(static_cast<std::size_t>(measure.front() - 'x'));
}

// The first edge that lies on a triangle, and the vertex across.
std::optional<std::pair<EdgeId, Vertex>> first_triangle(const Graph& graph) {
  for (EdgeId e = 0; e < graph.num_edges(); ++e) {
    for (const HalfEdge& half : graph.incident(graph.edge(e).u)) {
      if (has_edge(graph, half.to, graph.edge(e).v)) return std::pair(e, half.to);
    }
  }
  return std::nullopt;
}

/// True if two vertices have two common neighbours.
bool has_four_cycle(const Graph& graph) {
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    for (const HalfEdge& a : graph.incident(v)) {
      for (const HalfEdge& b : graph.incident(v)) {
        if (a.to >= b.to) continue;
        for (const HalfEdge& c : graph.incident(a.to)) {
          if (c.to != v && has_edge(graph, c.to, b.to)) return true;
        }
      }
    }
  }
  return false;
}

/// The drawing with its points changed: every vertex and every edge's bends pass through the given
/// functions.
Drawing changed(const Drawing& drawing, const std::function<Point(Point)>& vertex,
                const std::function<void(EdgeId, std::vector<Point>&)>& bends) {
  Coordinates positions(drawing.num_vertices(), kMaxCoordinate);
  for (Vertex v = 0; v < drawing.num_vertices(); ++v) positions.set(v, vertex(drawing.vertex(v)));
  const auto edges = std::make_shared<std::vector<Edge>>();
  const auto stored = std::make_shared<StoredBends>();
  std::vector<Point> points;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    edges->push_back(drawing.edge(e));
    drawing.polyline(e, points);
    std::vector<Point> inner(points.begin() + 1, points.end() - 1);
    bends(e, inner);
    stored->add_edge(inner);
  }
  return {drawing.algorithm(), drawing.lattice(), std::move(positions), edges, stored};
}

/// An edge of a triangle bends on the triangle's third vertex instead.
Drawing seed_wrong_bend(const Graph& graph, const Drawing& drawing, const Guarantee&) {
  const auto triangle = first_triangle(graph);
  if (!triangle) return drawing;
  const Point wrong = drawing.vertex(triangle->second);
  return changed(
      drawing, [](Point p) { return p; },
      [&](EdgeId e, std::vector<Point>& bends) {
        if (e != triangle->first) return;
        if (bends.empty()) bends.push_back(wrong);
        bends.front() = wrong;
      });
}

/// Stretched until it leaves the theorem's box: angles, directions and crossings stay right. The
/// points stay within a few times the bound, so below 2^60 for n <= 10^6.
Drawing seed_passed_bound(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee) {
  if (!has_four_cycle(graph)) return drawing;
  if (graph.num_vertices() > 1000000) {
    throw InputError("this fault is seeded in graphs of at most 1000000 vertices only");
  }
  const std::array<std::int64_t, 3> extents = bounding_box(drawing).extents();
  std::int64_t factor = kMaxCoordinate;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (extents[axis] == 0) continue;
    const double share =
        guarantee.bound.axes[axis].value(graph.num_vertices()) / static_cast<double>(extents[axis]);
    factor = std::min(factor, 1 + static_cast<std::int64_t>(std::ceil(share)));
  }
  const auto stretched = [factor](Point p) {
    return Point{factor * p.x, factor * p.y, factor * p.z};
  };
  return changed(drawing, stretched, [&](EdgeId, std::vector<Point>& bends) {
    for (Point& bend : bends) bend = stretched(bend);
  });
}

Drawing draw_subject(const Subject& subject, const Graph& graph) {
  const Algorithm& algorithm = *subject.choice.algorithm;
  Drawing drawing = draw(algorithm, graph, subject.choice.options);
  return subject.fault == nullptr ? drawing
                                  : subject.fault->plant(graph, drawing, algorithm.guarantee);
}

}  // namespace

Trial try_graph(const Subject& subject, Graph graph) {
  Trial trial;
  trial.graph = std::move(graph);
  try {
    trial.drawing = std::make_shared<const Drawing>(draw_subject(subject, trial.graph));
    const Drawing& drawing = *trial.drawing;
    trial.extents = bounding_box(drawing).extents();
    trial.bound = bound_of(subject, trial.graph, drawing);
    const Algorithm& algorithm = *subject.choice.algorithm;
    const bool has_box = algorithm.guarantee.bound.promises_box();
    trial.ratio = has_box ? ratio_of(trial, subject.measure) : 0;
    if (!subject.choice.is_judged()) return trial;
    const Certificate certificate = certify(trial.graph, drawing, algorithm.guarantee);
    if (certificate.violated()) {
      const Violation& first = certificate.violations.front();
      trial.failure = to_string(first.kind);
      trial.message = first.message;
    }
  } catch (const ProgramFailure& failure) {
    trial.failure = to_string(failure.status());
    trial.message = failure.what();
  } catch (const InternalError& error) {
    trial.drawing.reset();
    trial.failure = "internal_error";
    trial.message = error.what();
  }
  return trial;
}

const std::vector<SeededFault>& seeded_faults() {
  static const std::vector<SeededFault> rows = {
      {"wrong-bend", "an edge of a triangle bends on the triangle's third vertex", seed_wrong_bend},
      {"passed-bound", "graphs with a cycle of length 4 are drawn larger than the theorem allows",
       seed_passed_bound}};
  return rows;
}

const SeededFault& find_seeded_fault(std::string_view name) {
  for (const SeededFault& row : seeded_faults()) {
    if (row.name == name) return row;
  }
  const auto known = names_of(seeded_faults());
  throw InputError(fmt::format("unknown seeded fault '{}'{} (known: {})", name,
                               did_you_mean(name, known), fmt::join(known, ", ")));
}

}  // namespace ar3d
