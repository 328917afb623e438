// A picture of a drawing: strokes cut where they pass behind others, painted from the farthest to
// the nearest.
#include "ar3d/formats/drawings/projection.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

using PaintedItem = Projection::PaintedItem;

constexpr std::size_t kMaxSegments = 20000;
constexpr double kMargin = 24;
constexpr double kBallToStroke = 1.7;

/// A point on the picture: x to the right, y down; z is larger for nearer points and linear along
/// projected segments.
using PicturePoint = Real3;

/// Picture coordinates before scaling.
class Camera {
 public:
  Camera(const Drawing& drawing, const ExportOptions& view)
      : embed_(drawing.lattice()),
        turn_(view.turn_degrees * std::numbers::pi / 180),
        tilt_(view.tilt_degrees * std::numbers::pi / 180) {
    const Box box = bounding_box(drawing);
    const Real3 low = embed_(box.low);
    const Real3 high = embed_(box.high);
    middle_ = 0.5 * (low + high);
    Real3 sides = high - low;
    if (view.stretch) {
      const double longest = std::max({sides.x, sides.y, sides.z});
      const auto factor = [&](double side) { return side > 0 ? longest / side : 1; };
      stretch_ = {factor(sides.x), factor(sides.y), factor(sides.z)};
      sides = {longest, longest, longest};
    }
    if (view.perspective > 0) eye_ = view.perspective * std::max(length(sides), 1.0);
  }
  PicturePoint operator()(Point p) const {
    Real3 q = embed_(p) - middle_;
    q = {q.x * stretch_.x, q.y * stretch_.y, q.z * stretch_.z};
    const double right = q.x * std::cos(turn_) + q.y * std::sin(turn_);
    const double away = -q.x * std::sin(turn_) + q.y * std::cos(turn_);
    const double down = -(away * std::cos(tilt_) + q.z * std::sin(tilt_));
    const double towards = q.z * std::cos(tilt_) - away * std::sin(tilt_);
    if (!eye_) return {right, down, towards};
    if (towards >= 0.98 * *eye_) {
      throw InputError("the eye of the perspective is in the drawing; --perspective 2 is outside");
    }
    const double scale = *eye_ / (*eye_ - towards);
    return {right * scale, down * scale, scale};
  }
  /// Size on the picture of what has size 1 at a spot.
  double scale(const PicturePoint& spot) const { return eye_ ? spot.z : 1; }

 private:
  Embedding embed_;
  double turn_;
  double tilt_;
  Real3 middle_;
  Real3 stretch_ = {1, 1, 1};
  std::optional<double> eye_;
};

struct PictureSegment {
  PicturePoint a;
  PicturePoint b;
  EdgeId edge = 0;
  Vertex from_vertex = kNoVertex;  // the vertex at a or b, if there is one
  Vertex to_vertex = kNoVertex;
  int role = 0;
  std::vector<std::pair<double, double>> gaps;  // where it is hidden, as parts of its length
  std::vector<double> splits;  // where it enters and leaves balls, so that depth orders the pieces

  static constexpr Vertex kNoVertex = std::numeric_limits<Vertex>::max();

  PicturePoint at(double t) const { return a + t * (b - a); }
  double length() const { return std::hypot(b.x - a.x, b.y - a.y); }
  bool joins(const PictureSegment& other) const {
    const auto shared = [](Vertex v, Vertex w) { return v != kNoVertex && v == w; };
    return (edge == other.edge) || shared(from_vertex, other.from_vertex) ||
           shared(from_vertex, other.to_vertex) || shared(to_vertex, other.from_vertex) ||
           shared(to_vertex, other.to_vertex);
  }
};

std::vector<PictureSegment> collect(const Drawing& drawing, const Camera& camera,
                                    std::string_view format) {
  const EdgeRoles roles = edge_roles(drawing);
  std::vector<PictureSegment> segments;
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    if (segments.size() + points.size() - 1 > kMaxSegments) {
      throw InputError(
          fmt::format("a picture of more than {} segments cannot be read, {} holds at most these; "
                      "draw a smaller graph",
                      kMaxSegments, format));
    }
    for (std::size_t i = 1; i < points.size(); ++i) {
      PictureSegment segment{
          camera(points[i - 1]),     camera(points[i]), e,  PictureSegment::kNoVertex,
          PictureSegment::kNoVertex, roles.edges[e],    {}, {}};
      if (i == 1) segment.from_vertex = drawing.edge(e).u;
      if (i + 1 == points.size()) segment.to_vertex = drawing.edge(e).v;
      segments.push_back(std::move(segment));
    }
  });
  return segments;
}

/// Cuts the farther of two segments where they cross on the picture. `clear` is the distance that
/// must stay free beside the nearer one.
void cut_farther(PictureSegment& s, PictureSegment& t, double clear) {
  const double sx = s.b.x - s.a.x, sy = s.b.y - s.a.y;
  const double tx = t.b.x - t.a.x, ty = t.b.y - t.a.y;
  const double across = sx * ty - sy * tx;
  const double lengths = s.length() * t.length();
  if (std::abs(across) <= 1e-9 * lengths || s.joins(t)) return;
  const double dx = t.a.x - s.a.x, dy = t.a.y - s.a.y;
  const double on_s = (dx * ty - dy * tx) / across;
  const double on_t = (dx * sy - dy * sx) / across;
  if (on_s <= 0 || on_s >= 1 || on_t <= 0 || on_t >= 1) return;
  const bool s_is_farther = s.at(on_s).z < t.at(on_t).z;
  PictureSegment& farther = s_is_farther ? s : t;
  const double half = std::min(clear * lengths / std::abs(across), 6 * clear) / farther.length();
  const double middle = s_is_farther ? on_s : on_t;
  farther.gaps.emplace_back(middle - half, middle + half);
}

void cut_crossings(std::vector<PictureSegment>& segments, double clear) {
  const auto left = [](const PictureSegment& s) { return std::min(s.a.x, s.b.x); };
  const auto right = [](const PictureSegment& s) { return std::max(s.a.x, s.b.x); };
  std::vector<std::size_t> order(segments.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return left(segments[i]) < left(segments[j]);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    PictureSegment& s = segments[order[i]];
    for (std::size_t j = i + 1; j < order.size() && left(segments[order[j]]) < right(s); ++j) {
      cut_farther(s, segments[order[j]], clear);
    }
  }
}

/// Splits segments where they pass balls.
void split_at_balls(std::vector<PictureSegment>& segments, const std::vector<PicturePoint>& balls,
                    double radius, const Camera& camera) {
  for (PictureSegment& s : segments) {
    const double length = s.length();
    if (length <= 0) continue;
    const double ux = (s.b.x - s.a.x) / length, uy = (s.b.y - s.a.y) / length;
    for (const PicturePoint& ball : balls) {
      const double dx = ball.x - s.a.x, dy = ball.y - s.a.y;
      const double reach = radius * camera.scale(ball);
      const double off = std::abs(dx * uy - dy * ux);
      const double along = dx * ux + dy * uy;
      if (off >= reach || along < -reach || along > length + reach) continue;
      const double half = std::sqrt(reach * reach - off * off);
      s.splits.push_back((along - half) / length);
      s.splits.push_back((along + half) / length);
    }
  }
}

/// Appends what is left of a segment, piece by piece.
void append_pieces(const PictureSegment& s, const Camera& camera, std::vector<PaintedItem>& items) {
  std::vector<double> cuts = {0, 1};
  for (const auto& [from, to] : s.gaps) {
    cuts.push_back(from);
    cuts.push_back(to);
  }
  cuts.insert(cuts.end(), s.splits.begin(), s.splits.end());
  for (double& cut : cuts) cut = std::clamp(cut, 0.0, 1.0);
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const double middle = (cuts[i - 1] + cuts[i]) / 2;
    const bool hidden = std::any_of(s.gaps.begin(), s.gaps.end(), [&](const auto& gap) {
      return gap.first < middle && middle < gap.second;
    });
    if (hidden || (cuts[i] - cuts[i - 1]) * s.length() < 1e-9) continue;
    const PicturePoint spot = s.at(middle);
    items.push_back({s.at(cuts[i - 1]), s.at(cuts[i]), s.role, spot.z, 0, camera.scale(spot)});
  }
}

/// The least and the largest of all coordinates.
using PictureFrame = std::pair<PicturePoint, PicturePoint>;

PictureFrame frame_of(const std::vector<PictureSegment>& segments,
                      const std::vector<PicturePoint>& balls) {
  std::vector<PicturePoint> spots = balls;
  for (const PictureSegment& s : segments) {
    spots.push_back(s.a);
    spots.push_back(s.b);
  }
  if (spots.empty()) return {};
  PicturePoint low = spots[0], high = spots[0];
  for (const auto& [x, y, z] : spots) {
    low = {std::min(low.x, x), std::min(low.y, y), std::min(low.z, z)};
    high = {std::max(high.x, x), std::max(high.y, y), std::max(high.z, z)};
  }
  return {low, high};
}

/// From the drawing's units to those of the picture.
void place_on_paper(Projection& picture, const PictureFrame& frame, double scale) {
  const auto& low = frame.first;
  const double depth = std::max(frame.second.z - low.z, 1e-9);
  const auto placed = [&low, scale](PicturePoint p) {
    return PicturePoint{kMargin + (p.x - low.x) * scale, kMargin + (p.y - low.y) * scale, p.z};
  };
  for (PaintedItem& item : picture.items) {
    item.from = placed(item.from);
    item.to = placed(item.to);
    item.nearness = std::clamp((item.depth - low.z) / depth, 0.0, 1.0);
  }
  std::stable_sort(picture.items.begin(), picture.items.end(),
                   [](const PaintedItem& a, const PaintedItem& b) { return a.depth < b.depth; });
}

}  // namespace

Projection project(const Drawing& drawing, const ExportOptions& view, std::string_view format) {
  const Camera camera(drawing, view);
  std::vector<PictureSegment> segments = collect(drawing, camera, format);
  std::vector<PicturePoint> balls;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    balls.push_back(camera(drawing.vertex(static_cast<Vertex>(v))));
  }
  const PictureFrame frame = frame_of(segments, balls);
  const auto& [low, high] = frame;
  const double width = high.x - low.x, height = high.y - low.y;
  const double span = std::max({width, height, 1e-9});
  const double scale = (view.longer_side - 2 * kMargin) / span;
  Projection picture;
  picture.width = width * scale + 2 * kMargin;
  picture.height = height * scale + 2 * kMargin;
  const double crowded = 42 / std::sqrt(static_cast<double>(segments.size() + 1));
  picture.stroke = std::clamp(scale * 0.34, std::clamp(crowded, 1.2, 5.0), 7.0);
  picture.ball = kBallToStroke * picture.stroke;
  cut_crossings(segments, 1.35 * picture.stroke / scale);
  split_at_balls(segments, balls, picture.ball / scale, camera);
  for (const PictureSegment& s : segments) append_pieces(s, camera, picture.items);
  for (Vertex v = 0; v < balls.size(); ++v) {
    const PicturePoint& ball = balls[v];
    // In front of the strokes that end at it.
    const double front =
        (high.z - low.z) * 1e-6 + picture.ball / scale * (view.perspective > 0 ? 0 : 1);
    picture.items.push_back({ball, ball, -1, ball.z + front, 0, camera.scale(ball), v});
  }
  place_on_paper(picture, frame, scale);
  return picture;
}

Rgb faded(Rgb colour, double nearness) {
  const double keep = 0.55 + 0.45 * nearness;
  for (std::uint8_t& channel : colour) {
    channel = static_cast<std::uint8_t>(255 - keep * (255 - channel));
  }
  return colour;
}

}  // namespace ar3d
