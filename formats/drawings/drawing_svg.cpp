#include "ar3d/formats/drawings/drawing_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "ar3d/model/error.h"

namespace ar3d {
namespace {

struct Real3 {
  double x = 0, y = 0, z = 0;
};

constexpr std::size_t kMaxSegments = 20000;
constexpr double kBallRadius = 0.8;  // in lattice units, for the depth order only
constexpr int kPiecesPerSegment =
    12;  // painter's algorithm: long tubes are split so that depth order is right

/// Cholesky factor of gram / denominator: squared Euclidean length of embed(u) is the lattice's
/// squared length.
class Embedding {
 public:
  explicit Embedding(const Lattice& lattice) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        double sum = static_cast<double>(lattice.gram[i][j]) / lattice.gram_denominator;
        for (std::size_t k = 0; k < j; ++k) sum -= factor_[i][k] * factor_[j][k];
        factor_[i][j] = i == j ? std::sqrt(sum) : sum / factor_[j][j];
      }
    }
  }
  Real3 operator()(Point p) const {
    const double u[3] = {static_cast<double>(p.x), static_cast<double>(p.y),
                         static_cast<double>(p.z)};
    double out[3] = {0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j <= i; ++j) out[j] += factor_[i][j] * u[i];
    }
    return {out[0], out[1], out[2]};
  }

 private:
  double factor_[3][3] = {};
};

/// Picture coordinates: x to the right, y down, z towards the viewer.
class Camera {
 public:
  Camera(const Lattice& lattice, const SvgView& view)
      : embed_(lattice),
        turn_(view.turn_degrees * std::numbers::pi / 180),
        tilt_(view.tilt_degrees * std::numbers::pi / 180) {}
  Real3 operator()(Point p) const {
    const Real3 q = embed_(p);
    const double right = q.x * std::cos(turn_) + q.y * std::sin(turn_);
    const double away = -q.x * std::sin(turn_) + q.y * std::cos(turn_);
    return {right, -(away * std::cos(tilt_) + q.z * std::sin(tilt_)),
            q.z * std::cos(tilt_) - away * std::sin(tilt_)};
  }

 private:
  Embedding embed_;
  double turn_;
  double tilt_;
};

struct Tube {
  Real3 from;
  Real3 to;
  int colour = 0;  // -1: a vertex, drawn at `from`
  double depth() const { return colour < 0 ? from.z + kBallRadius : (from.z + to.z) / 2; }
};

/// Edges that share a vertex get different colours (greedy; at most 2 * maximum degree - 1
/// colours).
std::vector<int> edge_colours(const Drawing& drawing) {
  std::vector<std::vector<EdgeId>> at(drawing.num_vertices());
  std::vector<int> colour(drawing.num_edges(), -1);
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    const auto [u, v] = drawing.edge(e);
    int c = 0;
    const auto taken = [&](Vertex w) {
      return std::any_of(at[w].begin(), at[w].end(), [&](EdgeId f) { return colour[f] == c; });
    };
    while (taken(u) || taken(v)) ++c;
    colour[e] = c;
    at[u].push_back(e);
    at[v].push_back(e);
  }
  return colour;
}

std::vector<Tube> collect_tubes(const Drawing& drawing, const Camera& camera) {
  std::vector<Tube> tubes;
  const std::vector<int> colours = edge_colours(drawing);
  std::vector<Point> points;
  std::size_t segments = 0;
  for (EdgeId e = 0; e < drawing.num_edges(); ++e) {
    drawing.polyline(e, points);
    segments += points.size() - 1;
    if (segments > kMaxSegments) {
      throw InputError(fmt::format(
          "a picture of more than {} segments cannot be read; draw a smaller graph", kMaxSegments));
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Real3 a = camera(points[i - 1]);
      const Real3 b = camera(points[i]);
      const auto at = [&](int k) {
        const double t = static_cast<double>(k) / kPiecesPerSegment;
        return Real3{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
      };
      for (int k = 0; k < kPiecesPerSegment; ++k) tubes.push_back({at(k), at(k + 1), colours[e]});
    }
  }
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    const Real3 p = camera(drawing.vertex(static_cast<Vertex>(v)));
    tubes.push_back({p, p, -1});
  }
  std::stable_sort(tubes.begin(), tubes.end(),
                   [](const Tube& a, const Tube& b) { return a.depth() < b.depth(); });
  return tubes;
}

struct Frame {
  double low_x = 0, low_y = 0, low_z = 0, high_x = 0, high_y = 0, high_z = 0;
};

Frame frame_of(const std::vector<Tube>& tubes) {
  Frame f;
  bool first = true;
  for (const Tube& tube : tubes) {
    for (const Real3& p : {tube.from, tube.to}) {
      if (first) f = {p.x, p.y, p.z, p.x, p.y, p.z};
      first = false;
      f = {std::min(f.low_x, p.x),  std::min(f.low_y, p.y),  std::min(f.low_z, p.z),
           std::max(f.high_x, p.x), std::max(f.high_y, p.y), std::max(f.high_z, p.z)};
    }
  }
  return f;
}

/// Colour-blind safe base colours (Okabe and Ito), faded towards the background with distance.
std::string shade(int colour, double nearness) {
  static constexpr int kBase[7][3] = {{0, 114, 178},   {213, 94, 0},  {0, 158, 115},
                                      {204, 121, 167}, {230, 159, 0}, {86, 180, 233},
                                      {110, 110, 110}};
  const auto& base = kBase[colour % 7];
  const double keep = 0.55 + 0.45 * nearness;
  const auto channel = [&](int i) { return static_cast<int>(255 - keep * (255 - base[i])); };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(1), channel(2));
}

}  // namespace

std::string drawing_to_svg(const Drawing& drawing, const SvgView& view) {
  const std::vector<Tube> tubes = collect_tubes(drawing, Camera(drawing.lattice(), view));
  const Frame f = frame_of(tubes);
  const double margin = 24;
  const double span = std::max({f.high_x - f.low_x, f.high_y - f.low_y, 1e-9});
  const double scale = (view.longer_side - 2 * margin) / span;
  const double width = (f.high_x - f.low_x) * scale + 2 * margin;
  const double height = (f.high_y - f.low_y) * scale + 2 * margin;
  const double stroke = std::clamp(scale * 0.34, 1.2, 7.0);
  const auto sx = [&](double x) { return margin + (x - f.low_x) * scale; };
  const auto sy = [&](double y) { return margin + (y - f.low_y) * scale; };
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\">\n"
      "<defs><radialGradient id=\"ball\" cx=\"35%\" cy=\"30%\" r=\"75%\"><stop offset=\"0\" "
      "stop-color=\"#fff\"/>"
      "<stop offset=\"0.35\" stop-color=\"#777\"/><stop offset=\"1\" "
      "stop-color=\"#111\"/></radialGradient></defs>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
      width, height);
  for (const Tube& tube : tubes) {
    if (tube.colour < 0) {
      out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" fill=\"url(#ball)\"/>\n",
                         sx(tube.from.x), sy(tube.from.y), stroke * 1.7);
      continue;
    }
    const double nearness = (tube.depth() - f.low_z) / std::max(f.high_z - f.low_z, 1e-9);
    const std::string line = fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", sx(tube.from.x),
                                         sy(tube.from.y), sx(tube.to.x), sy(tube.to.y));
    out += fmt::format(
        "<path d=\"{0}\" stroke=\"#fff\" stroke-width=\"{1:.1f}\"/>"
        "<path d=\"{0}\" stroke=\"{2}\" stroke-width=\"{3:.1f}\" stroke-linecap=\"round\"/>\n",
        line, stroke * 1.9, shade(tube.colour, nearness), stroke);
  }
  return out + "</svg>\n";
}

}  // namespace ar3d
