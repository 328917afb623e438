// The program ar3d_limits: every stage, its yardstick and its peers, as benchmarks in random turns
// (limits/table.py makes ratios of them). Here, what the memory gives one thread, the floor under
// every stage: machine/read, copy (bytes per second), chain (reads that wait for the one before)
// and chains (32 such chains at the same time). Their counter `load` is the machine's while it ran.
#include <array>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "ar3d/base/long_vector.h"
#include "limits.h"

namespace ar3d::kernels {
namespace {

using benchmark::State;
using Numbers = UnwrittenVector<std::uint64_t>;

/// Numbers in a cache line, of which one is used, so that no two steps share a line.
constexpr std::uint32_t kLine = 16;
using Lines = UnwrittenVector<std::uint32_t>;

/// Returns one cycle through all lines, in random order (Sattolo).
Lines random_cycle(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937_64 random(1);
  for (std::size_t i = count - 1; i > 0; --i) std::swap(order[i], order[random() % i]);
  Lines lines(kLine * count, 0);
  for (std::size_t i = 0; i < count; ++i) lines[kLine * i] = kLine * order[i];
  return lines;
}

std::size_t bytes_in(const State& state) { return std::size_t{size_of(state)} << 20; }

void count_bytes(State& state, std::size_t times) {
  state.counters["bytes"] = static_cast<double>(times * bytes_in(state));
  std::array<double, 1> load{};
  if (getloadavg(load.data(), 1) == 1) state.counters["load"] = load[0];
}

void read(State& state) {
  const Numbers from(bytes_in(state) / sizeof(std::uint64_t), 1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(std::accumulate(from.begin(), from.end(), std::uint64_t{0}));
  }
  count_bytes(state, 1);
}

void copy(State& state) {
  const Numbers from(bytes_in(state) / sizeof(std::uint64_t), 1);
  Numbers to(from.size(), 0);
  for (auto _ : state) {
    std::copy(from.begin(), from.end(), to.begin());
    benchmark::ClobberMemory();
  }
  count_bytes(state, 2);
}

template <std::size_t Chains>
void walk(State& state) {
  constexpr std::size_t kSteps = 1 << 17;
  const Lines lines = random_cycle(bytes_in(state) / (kLine * sizeof(std::uint32_t)));
  for (auto _ : state) {
    std::array<std::uint32_t, Chains> at{};
    for (std::size_t i = 0; i < Chains; ++i) {
      at[i] = static_cast<std::uint32_t>(i * (lines.size() / Chains));
    }
    for (std::size_t step = 0; step < kSteps; ++step) {
      for (std::uint32_t& next : at) next = lines[next];
    }
    benchmark::DoNotOptimize(at);
  }
  count_bytes(state, 0);
  state.counters["reads"] = static_cast<double>(kSteps * Chains);
}

constexpr std::array<const char*, 3> kDefaults = {
    "--benchmark_filter=-/(n:1000|n:10000000+|mib:1|rows:20)/",
    "--benchmark_enable_random_interleaving=true", "--benchmark_repetitions=5"};

}  // namespace

void register_machine() {
  const auto add = [](const char* name, void (*kernel)(State&)) {
    const auto once = [](benchmark::internal::Benchmark* each) { each->Iterations(1); };
    add_limit(name, {1, 256}, kernel, once, "mib");
  };
  add("machine/read", read);
  add("machine/copy", copy);
  add("machine/chain", walk<1>);
  add("machine/chains", walk<32>);
}

void register_catalogues() {
  register_machine();
  register_stages();
  register_threads();
  register_peers();
}

std::span<const char* const> default_arguments() { return kDefaults; }

}  // namespace ar3d::kernels
