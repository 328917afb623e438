// What the memory gives one thread: the floor under every stage.
#include "machine.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "ar3d/base/long_vector.h"
#include "turns.h"

namespace ar3d::limits {
namespace {

using Numbers = UnwrittenVector<std::uint64_t>;

/// A record of a whole cache line, so that no two steps share one.
struct Line {
  std::uint32_t next = 0;
  std::uint32_t unused[15] = {};
};
using Lines = UnwrittenVector<Line>;

/// One cycle through all lines, in random order (Sattolo).
Lines random_cycle(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937_64 random(1);
  for (std::size_t i = count - 1; i > 0; --i) std::swap(order[i], order[random() % i]);
  Lines lines(count, Line{});
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
  const Lines lines = random_cycle(bytes / sizeof(Line));
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

}  // namespace ar3d::limits
