// The whole exact certificate beside CGAL's intersecting boxes with our exact test of every pair
// that they name: the same question, the same verdict.
#include "limit.h"

#ifdef AR3D_HAVE_CGAL
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/one_thread.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/checks/contacts.h"
#include "turns.h"
#endif

namespace ar3d::limits {
namespace {

#ifdef AR3D_HAVE_CGAL

using verify::SegmentId;

/// Exact, since coordinates of so small a drawing are below 2^53.
std::array<double, 3> as_doubles(Point p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

/// True if no two segments meet where they must not. Every vertex has an edge, so its place is an
/// end of a segment.
bool valid_by_boxes(const Drawing& drawing) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, SegmentId>;
  const verify::Segments segments(drawing);
  std::vector<Box> boxes;
  boxes.reserve(segments.size());
  for (SegmentId s = 0; s < segments.size(); ++s) {
    GrowingBox box;
    box.add(segments.from(s));
    box.add(segments.to(s));
    std::array<double, 3> low = as_doubles(box.low());
    std::array<double, 3> high = as_doubles(box.high());
    boxes.emplace_back(low.data(), high.data(), s);
  }
  verify::Findings findings(100);
  verify::Contacts contacts(segments, findings);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    contacts.examine(std::min(a.info(), b.info()), std::max(a.info(), b.info()));
  });
  contacts.report();
  return findings.empty();
}

void measure_crossings(const Scale& scale, std::vector<Limit>& limits) {
  const OneThread one_thread;
  const Algorithm& diamond = find_algorithm("diamond");
  const Graph graph = generate(find_family("random-4-regular"), scale.n, 1, {{"shuffle", 1}});
  const Drawing drawing = draw(diamond, graph);
  const auto require = [](bool valid) {
    if (!valid) throw std::runtime_error("the verdicts differ: a drawing is not valid");
  };
  Turns turns(
      {timed(Clock::cpu, [&] { require(certify(graph, drawing, diamond.guarantee).valid()); }),
       timed(Clock::cpu, [&] { require(valid_by_boxes(drawing)); })});
  turns.run(scale.repetitions, kSlowSeconds);
  limits[0].measured = turns.median_of(1) / turns.median_of(0);
  limits[0].remark = fmt::format("CGAL {}: {:.3g} s, our whole certificate {:.3g} s, both valid{}",
                                 CGAL_VERSION_STR, turns.median_of(1), turns.median_of(0),
                                 turns.rounds_remark(scale.repetitions));
}

#else

void measure_crossings(const Scale&, std::vector<Limit>&) {
  throw NotMeasured("not built with CGAL (libcgal-dev)");
}

#endif

}  // namespace

std::vector<Group> crossing_groups() {
  return {{"crossings/cgal",
           10'000,
           {{"crossings of `diamond`, 80,000 segments",
             "CGAL `box_self_intersection_d` and the exact test",
             {Goal::Kind::at_least, 700, "× faster"},
             "ours is the whole certificate, two thirds of whose instructions count the meetings"}},
           measure_crossings}};
}

}  // namespace ar3d::limits
