// Certifying, measuring and hashing beside drawing: one thread, CPU time, random graphs with
// vertices shuffled. And certifying on two threads beside one: wall time.
// The whole exact certificate beside CGAL's intersecting boxes with our exact test of every pair
// that they name: the same question, the same verdict.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "../inputs.h"
#include "../turns.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/checks/contacts.h"
#include "ar3d/verify/checks/examination.h"
#include "limit.h"

#ifdef AR3D_HAVE_CGAL
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>
#endif

namespace ar3d::kernels {
namespace {

void require(bool valid) {
  if (!valid) throw std::runtime_error("a drawing is not valid");
}

/// Certifying / drawing; the same, per segment; metrics and hash / drawing.
void measure_examination(const std::string& name, const RunSize& scale,
                         std::vector<Limit>& limits) {
  const OneThread one_thread;
  const Algorithm& algorithm = find_algorithm(name);
  const Graph graph = shuffled(random_family(algorithm), scale.n);
  const Drawing drawing = draw(algorithm, graph);
  std::uint64_t segments = 0;
  Turns turns({timed(Clock::cpu, [&] { (void)draw(algorithm, graph); }),
               timed(Clock::cpu,
                     [&] {
                       const Certificate certificate = certify(graph, drawing, algorithm.guarantee);
                       require(certificate.valid());
                       segments = certificate.segments;
                     }),
               timed(Clock::cpu, [&] {
                 const ExaminationParts parts{.certificate = false, .metrics = true, .hash = true};
                 (void)examine(graph, drawing, algorithm.guarantee, parts);
               })});
  turns.run(scale.repetitions, kSlowSeconds);
  const double drawing_s = turns.median_of(0);
  const double certify_s = turns.median_of(1);
  const double measure_s = turns.median_of(2);
  limits[0].measured = certify_s / drawing_s;
  limits[0].remark = fmt::format("{:.3g} s, drawing {:.3g} s{}", certify_s, drawing_s,
                                 turns.rounds_remark(scale.repetitions));
  limits[1].measured = measure_s / drawing_s;
  limits[1].remark = fmt::format("{:.3g} s without the certificate", measure_s);
  if (limits.size() < 3) return;
  limits[2].measured = 1e6 * certify_s / static_cast<double>(segments);
  limits[2].remark = fmt::format("{} segments", segments);
}

LimitGroup examination_group(const std::string& name, std::uint64_t n) {
  LimitGroup group{fmt::format("certify/{}/{}", name, n), n, {}, {}};
  group.limits = {{fmt::format("certify `{}`", name), "its drawing", at_most(3),
                   "the drawing is fast, and every segment is computed, stored and compared"},
                  {fmt::format("metrics and hash of `{}`", name), "its drawing", at_most(1),
                   "the drawing is fast, and every length takes an inner product and a root"}};
  if (name == "diamond") {
    group.limits.push_back({"certify `diamond`, per segment", "none", at_most(0.25, " µs")});
  }
  group.measure = [name](const RunSize& scale, std::vector<Limit>& limits) {
    measure_examination(name, scale, limits);
  };
  return group;
}

void measure_threads(const RunSize& scale, std::vector<Limit>& limits) {
  const OneThread restore_afterwards;
  const Algorithm& diamond = find_algorithm("diamond");
  const Graph graph = shuffled(random_family(diamond), scale.n);
  const Drawing drawing = draw(diamond, graph);
  const auto on_threads = [&](int threads) {
    return [&, threads] {
      omp_set_num_threads(threads);
      require(certify(graph, drawing, diamond.guarantee).valid());
    };
  };
  Turns turns({timed(Clock::wall, on_threads(1)), timed(Clock::wall, on_threads(2)),
               side_by_side([&] { require(certify(graph, drawing, diamond.guarantee).valid()); })});
  turns.run(scale.repetitions);
  limits[0].measured = turns.median_of(0) / turns.median_of(1);
  limits[0].remark = fmt::format("{:.3g} s and {:.3g} s", turns.median_of(0), turns.median_of(1));
  limits[0].why_missed =
      fmt::format("two certificates side by side, which share only the machine, gain {:.2f}×",
                  turns.median_of(0) / turns.median_of(2));
}

}  // namespace

std::vector<LimitGroup> certifying_groups() {
  std::vector<LimitGroup> groups;
  for (const std::uint64_t n : {1'000'000, 10'000'000}) {
    for (const char* name : {"diamond", "grid", "two-bend", "compact", "compact-120"}) {
      groups.push_back(examination_group(name, n));
    }
  }
  groups.push_back({"certify/threads",
                    1'000'000,
                    {{"certify `diamond`, 2 threads", "1 thread", at_least(1.8, "× faster")}},
                    measure_threads});
  return groups;
}

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

void measure_crossings(const RunSize& scale, std::vector<Limit>& limits) {
  const OneThread one_thread;
  const Algorithm& diamond = find_algorithm("diamond");
  const Graph graph = generate(find_family("random-4-regular"), scale.n, 1, {{"shuffle", 1}});
  const Drawing drawing = draw(diamond, graph);
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

void measure_crossings(const RunSize&, std::vector<Limit>&) {
  throw NotMeasured("not built with CGAL (libcgal-dev)");
}

#endif

}  // namespace

std::vector<LimitGroup> crossing_groups() {
  return {{"crossings/cgal",
           10'000,
           {{"crossings of `diamond`, 80,000 segments",
             "CGAL `box_self_intersection_d` and the exact test", at_least(700, "× faster"),
             "ours is the whole certificate, two thirds of whose instructions count the meetings"}},
           measure_crossings}};
}

}  // namespace ar3d::kernels
