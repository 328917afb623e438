#include "decisions.h"

#include <algorithm>
#include <utility>

namespace ar3d::precision {
namespace {

using Segment = std::array<Point, 2>;

Box box_of(const Segment& s) {
  GrowingBox box;
  box.add(s[0]);
  box.add(s[1]);
  return box.box();
}

bool boxes_meet(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y &&
         a.low.z <= b.high.z && b.low.z <= a.high.z;
}

void add_pairs(std::vector<Segment> segments, std::size_t most, Decisions& decisions) {
  std::sort(segments.begin(), segments.end(), [](const Segment& a, const Segment& b) {
    return std::min(a[0].z, a[1].z) < std::min(b[0].z, b[1].z);
  });
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i < 200 ? 0 : i - 200; j < i; ++j) {
      if (decisions.pairs.size() == most) return;
      const Segment &s = segments[j], &t = segments[i];
      if (boxes_meet(box_of(s), box_of(t))) decisions.pairs.push_back({s[0], s[1], t[0], t[1]});
    }
  }
}

/// Every k-th, so that at most so many are left.
void thin(std::vector<std::array<Point, 3>>& angles, std::size_t most) {
  if (angles.size() <= most) return;
  for (std::size_t i = 0; i < most; ++i) angles[i] = angles[i * (angles.size() / most)];
  angles.resize(most);
}

}  // namespace

Decisions decisions_of(const Drawing& drawing, const Guarantee& guarantee, std::size_t most) {
  Decisions decisions{guarantee.lattice, guarantee.cosine, {}, {}, {}};
  std::vector<std::vector<Point>> stars(drawing.num_vertices());
  std::vector<Segment> segments;
  verify::Reach reach;
  const auto add = [&](Point from, Point at, Point to) {
    decisions.angles.push_back({from, at, to});
  };
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      segments.push_back({points[i - 1], points[i]});
      reach.add(points[i] - points[i - 1]);
      if (i > 1) add(points[i - 2], points[i - 1], points[i]);
    }
    stars[drawing.edge(e).u].push_back(points[1]);
    stars[drawing.edge(e).v].push_back(points[points.size() - 2]);
  });
  for (std::size_t v = 0; v < stars.size(); ++v) {
    for (std::size_t i = 1; i < stars[v].size(); ++i) {
      add(stars[v][i - 1], drawing.vertex(static_cast<Vertex>(v)), stars[v][i]);
    }
  }
  decisions.bits = verify::predicate_bits(reach, decisions.lattice, decisions.cosine);
  thin(decisions.angles, most);
  add_pairs(std::move(segments), most, decisions);
  return decisions;
}

}  // namespace ar3d::precision
