// Certifying, measuring and hashing beside drawing: one thread, CPU time, random graphs with
// vertices shuffled. And certifying on two threads beside one: wall time.
#include <fmt/format.h>
#include <omp.h>

#include <stdexcept>

#include "../inputs.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/one_thread.h"
#include "ar3d/verify/checks/examination.h"
#include "limit.h"
#include "turns.h"

namespace ar3d::limits {
namespace {

using kernels::random_family;
using kernels::shuffled;

void require(bool valid) {
  if (!valid) throw std::runtime_error("a drawing is not valid");
}

/// Certifying / drawing; the same, per segment; metrics and hash / drawing.
void measure_examination(const std::string& name, const Scale& scale, std::vector<Limit>& limits) {
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

Group examination_group(const std::string& name, std::uint64_t n) {
  Group group{fmt::format("certify/{}/{}", name, n), n, {}, {}};
  group.limits = {{fmt::format("certify `{}`", name),
                   "its drawing",
                   {Goal::Kind::at_most, 3},
                   "the drawing is fast, and every segment is computed, stored and compared"},
                  {fmt::format("metrics and hash of `{}`", name),
                   "its drawing",
                   {Goal::Kind::at_most, 1},
                   "the drawing is fast, and every length takes an inner product and a root"}};
  if (name == "diamond") {
    group.limits.push_back(
        {"certify `diamond`, per segment", "none", {Goal::Kind::at_most, 0.25, " µs"}});
  }
  group.measure = [name](const Scale& scale, std::vector<Limit>& limits) {
    measure_examination(name, scale, limits);
  };
  return group;
}

void measure_threads(const Scale& scale, std::vector<Limit>& limits) {
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

std::vector<Group> certifying_groups() {
  std::vector<Group> groups;
  for (const std::uint64_t n : {1'000'000, 10'000'000}) {
    for (const char* name : {"diamond", "grid", "two-bend", "compact", "compact-120"}) {
      groups.push_back(examination_group(name, n));
    }
  }
  groups.push_back(
      {"certify/threads",
       1'000'000,
       {{"certify `diamond`, 2 threads", "1 thread", {Goal::Kind::at_least, 1.8, "× faster"}}},
       measure_threads});
  return groups;
}

}  // namespace ar3d::limits
