// Small fixed work that is timed between rows: it tells how fast the machine is at the moment, so
// that times of two days can be compared.
#include "ar3d/bench/measure/yardsticks.h"

#include "ar3d/base/random.h"

namespace ar3d {
namespace {

constexpr std::uint32_t kEdges = 3;  // that leave a vertex
constexpr std::uint32_t kCached = 1U << 10, kMemory = 1U << 17;
// As short as a small drawing: what lasts longer never fits between two disturbances, so the
// smallest of many would tell of another state of the machine than those of the drawings.
constexpr int kCachedSearches = 8, kSteps = 15000;
// As long between two measurements as one takes: together 3 % of the time.
constexpr double kShortPauses = 50, kMemoryPauses = 100;

std::vector<std::uint32_t> random_heads(std::uint32_t vertices) {
  RandomStream random(1, vertices);
  std::vector<std::uint32_t> heads(std::size_t{kEdges} * vertices);
  for (std::uint32_t& head : heads) head = random.below(vertices);
  return heads;
}

template <class Work>
double cpu_time_of(const Work& work) {
  const CpuStopwatch time;
  work();
  return time.cpu_s();
}

// Every step waits for the one before.
void count_steps() {
  std::uint64_t number = 1;
  for (int i = 0; i < kSteps; ++i) {
    number = number * 6364136223846793005U + 1442695040888963407U;
    number ^= number >> 29U;
  }
  asm volatile("" : : "r"(number));
}

}  // namespace

Yardsticks::Yardsticks() : cached_(random_heads(kCached)), memory_(random_heads(kMemory)) {
  queue_.reserve(kMemory);
}

// Breadth first, as all drawings begin.
void Yardsticks::search(const Heads& heads) {
  seen_.assign(heads.size() / kEdges, false);
  queue_.assign(1, 0);
  seen_[0] = true;
  for (std::size_t place = 0; place < queue_.size(); ++place) {
    const std::size_t first = std::size_t{kEdges} * queue_[place];
    for (std::size_t i = first; i < first + kEdges; ++i) {
      if (seen_[heads[i]]) continue;
      seen_[heads[i]] = true;
      queue_.push_back(heads[i]);
    }
  }
}

const std::array<double, 3>& Yardsticks::now_s() {
  const double now = clock_.cpu_s();
  if (now >= next_short_s_) {
    search(cached_);  // into the cache
    last_s_[0] = cpu_time_of([&] {
      for (int i = 0; i < kCachedSearches; ++i) search(cached_);
    });
    last_s_[2] = cpu_time_of(count_steps);
    next_short_s_ = now + kShortPauses * (clock_.cpu_s() - now);
  }
  if (now >= next_memory_s_) {
    last_s_[1] = cpu_time_of([&] { search(memory_); });
    next_memory_s_ = now + kMemoryPauses * last_s_[1];
  }
  return last_s_;
}

}  // namespace ar3d
