// Memory beyond the graph at level `extents`, where a drawing keeps what its algorithm keeps and
// nothing else; and of the certificate beyond graph and drawing. One thread, measured once:
// resident bytes at their highest.
// What the memory gives one thread: the floor under every stage.

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "../inputs.h"
#include "../turns.h"
#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/long_vector.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/verify/checks/examination.h"
#include "limit.h"

namespace ar3d::kernels {
namespace {

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

void measure_extents(const RunSize& scale, std::vector<Limit>& limits) {
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
void measure_whole(const RunSize& scale, std::vector<Limit>& limits) {
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

void measure_certificate(const std::string& name, const RunSize& scale,
                         std::vector<Limit>& limits) {
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

std::vector<LimitGroup> memory_groups() {
  const Goal extents = at_most(48, " bytes");
  std::vector<LimitGroup> groups = {
      {"memory/extents",
       10'000'000,
       {{"memory per vertex of drawing `diamond`", "the graph", extents},
        {"memory per vertex of drawing `diamond`, metrics and hash", "the graph", extents}},
       measure_extents},
      {"memory/whole",
       100'000'000,
       {{"memory of generating, drawing, metrics and hash, `diamond`", "none",
         at_most(24, " GiB")}},
       measure_whole}};
  for (const char* name : {"diamond", "grid", "two-bend", "compact"}) {
    groups.push_back({fmt::format("memory/certify/{}", name),
                      1'000'000,
                      {{fmt::format("memory per segment of certifying `{}`", name),
                        "graph and drawing", at_most(40, " bytes"),
                        "24 or 32 bytes a segment in columns, and more while these are counted"}},
                      [name](const RunSize& scale, std::vector<Limit>& limits) {
                        measure_certificate(name, scale, limits);
                      }});
  }
  return groups;
}

namespace {

using Numbers = UnwrittenVector<std::uint64_t>;

/// A record of a whole cache line, so that no two steps share one.
struct CacheLine {
  std::uint32_t next = 0;
  std::uint32_t unused[15] = {};
};
using Lines = UnwrittenVector<CacheLine>;

/// One cycle through all lines, in random order (Sattolo).
Lines random_cycle(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937_64 random(1);
  for (std::size_t i = count - 1; i > 0; --i) std::swap(order[i], order[random() % i]);
  Lines lines(count, CacheLine{});
  for (std::size_t i = 0; i < count; ++i) lines[i].next = order[i];
  return lines;
}

/// `steps` steps of each of `Chains` walks; where they ended, so that nothing is left out.
template <std::size_t Chains>
std::uint32_t walk(const Lines& lines, std::size_t steps) {
  std::array<std::uint32_t, Chains> at{};
  for (std::size_t i = 0; i < Chains; ++i) {
    at[i] = static_cast<std::uint32_t>(i * (lines.size() / Chains));
  }
  for (std::size_t step = 0; step < steps; ++step) {
    for (std::uint32_t& place : at) place = lines[place].next;
  }
  return std::accumulate(at.begin(), at.end(), 0u);
}

volatile std::uint64_t sink = 0;  // what is computed has to be

}  // namespace

MemorySpeed measure_memory(std::size_t bytes, int rounds) {
  constexpr std::size_t kSteps = 1 << 17;
  constexpr std::size_t kChains = 32;
  Numbers from(bytes / sizeof(std::uint64_t), 1);
  Numbers to(from.size(), 0);
  const Lines lines = random_cycle(bytes / sizeof(CacheLine));
  Turns turns({timed(Clock::cpu,
                     [&] { sink = std::accumulate(from.begin(), from.end(), std::uint64_t{0}); }),
               timed(Clock::cpu, [&] { std::copy(from.begin(), from.end(), to.begin()); }),
               timed(Clock::cpu, [&] { sink = walk<1>(lines, kSteps); }),
               timed(Clock::cpu, [&] { sink = walk<kChains>(lines, kSteps); })});
  turns.run(rounds);
  const auto size = static_cast<double>(bytes);
  return {1e-9 * size / turns.median_of(0), 2e-9 * size / turns.median_of(1),
          1e9 * turns.median_of(2) / kSteps, 1e9 * turns.median_of(3) / (kSteps * kChains)};
}

}  // namespace ar3d::kernels
