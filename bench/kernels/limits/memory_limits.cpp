// Memory beyond the graph at level `extents`, where a drawing keeps what its algorithm keeps and
// nothing else; and of the certificate beyond graph and drawing. One thread, measured once:
// resident bytes at their highest.
#include <fmt/format.h>
#include <malloc.h>

#include <functional>

#include "../inputs.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/bench/measure/one_thread.h"
#include "ar3d/bench/measure/row_memory.h"
#include "ar3d/verify/checks/examination.h"
#include "limit.h"

namespace ar3d::limits {
namespace {

using kernels::random_family;
using kernels::shuffled;

constexpr double kGiB = 1024.0 * 1024 * 1024;

/// Bytes that `work` takes at its highest beyond those that are there before.
double bytes_of(const std::function<void()>& work) {
  malloc_trim(0);
  RowMemory memory(MemoryScope::row);
  const std::int64_t before = memory.begin_row();
  if (memory.scope() == MemoryScope::process) {
    throw NotMeasured("the kernel does not reset its mark of the highest memory");
  }
  work();
  const auto beyond = static_cast<double>(memory.peak_bytes() - before);
  if (beyond <= 0) throw NotMeasured("too little memory for the kernel's mark");
  return beyond;
}

void measure_extents(const Scale& scale, std::vector<Limit>& limits) {
  const OneThread one_thread;
  const Algorithm& diamond = find_algorithm("diamond");
  const Graph graph = shuffled(random_family(diamond), scale.n);
  const auto n = static_cast<double>(graph.num_vertices());
  limits[0].measured = bytes_of([&] { (void)draw(diamond, graph); }) / n;
  limits[1].measured = bytes_of([&] {
                         const Drawing drawing = draw(diamond, graph);
                         const ExaminationParts parts{.certificate = false};
                         (void)examine(graph, drawing, diamond.guarantee, parts);
                       }) /
                       n;
}

/// All of it: generating, drawing, metrics and hash.
void measure_whole(const Scale& scale, std::vector<Limit>& limits) {
  const OneThread one_thread;
  const Algorithm& diamond = find_algorithm("diamond");
  const double bytes = bytes_of([&] {
    const Graph graph = shuffled(random_family(diamond), scale.n);
    const Drawing drawing = draw(diamond, graph);
    (void)examine(graph, drawing, diamond.guarantee, {.certificate = false});
  });
  limits[0].measured = bytes / kGiB;
  limits[0].remark = fmt::format("{:.1f} bytes per vertex", bytes / static_cast<double>(scale.n));
}

void measure_certificate(const std::string& name, const Scale& scale, std::vector<Limit>& limits) {
  const OneThread one_thread;
  const Algorithm& algorithm = find_algorithm(name);
  const Graph graph = shuffled(random_family(algorithm), scale.n);
  const Drawing drawing = draw(algorithm, graph);
  std::uint64_t segments = 0;
  const double bytes =
      bytes_of([&] { segments = certify(graph, drawing, algorithm.guarantee).segments; });
  limits[0].measured = bytes / static_cast<double>(segments);
  limits[0].remark =
      fmt::format("{:.0f} bytes per vertex", bytes / static_cast<double>(graph.num_vertices()));
}

}  // namespace

std::vector<Group> memory_groups() {
  const Goal extents{Goal::Kind::at_most, 48, " bytes"};
  std::vector<Group> groups = {
      {"memory/extents",
       10'000'000,
       {{"memory per vertex of drawing `diamond`", "the graph", extents},
        {"memory per vertex of drawing `diamond`, metrics and hash", "the graph", extents}},
       measure_extents},
      {"memory/whole",
       100'000'000,
       {{"memory of generating, drawing, metrics and hash, `diamond`",
         "none",
         {Goal::Kind::at_most, 24, " GiB"}}},
       measure_whole}};
  for (const char* name : {"diamond", "grid", "two-bend", "compact"}) {
    groups.push_back({fmt::format("memory/certify/{}", name),
                      1'000'000,
                      {{fmt::format("memory per segment of certifying `{}`", name),
                        "graph and drawing",
                        {Goal::Kind::at_most, 40, " bytes"},
                        "24 or 32 bytes a segment in columns, and more while these are counted"}},
                      [name](const Scale& scale, std::vector<Limit>& limits) {
                        measure_certificate(name, scale, limits);
                      }});
  }
  return groups;
}

}  // namespace ar3d::limits
