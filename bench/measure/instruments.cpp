// Clocks, hardware counters and the peak of memory, as Linux tells them. Each says that a value is
// missing where the kernel refuses it.
#include "ar3d/bench/measure/instruments.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/perf_event.h>
#include <malloc.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "ar3d/base/random.h"

namespace ar3d {
namespace {

constexpr std::array<std::pair<const char*, std::uint64_t>, 3> kEvents = {
    {{"instructions", PERF_COUNT_HW_INSTRUCTIONS},
     {"cycles", PERF_COUNT_HW_CPU_CYCLES},
     {"cache misses", PERF_COUNT_HW_CACHE_MISSES}}};

Descriptor open_counter(std::uint64_t event) {
  perf_event_attr attributes{};
  attributes.size = sizeof attributes;
  attributes.type = PERF_TYPE_HARDWARE;
  attributes.config = event;
  attributes.disabled = 1;
  attributes.exclude_kernel = 1;
  attributes.exclude_hv = 1;
  attributes.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
  return Descriptor(
      static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, PERF_FLAG_FD_CLOEXEC)));
}

// -1 if there is no such counter or it did not run all the time.
std::int64_t value_of(const Descriptor& counter) {
  struct {
    std::uint64_t value;
    std::uint64_t enabled;
    std::uint64_t running;
  } count{};
  const bool is_read = read(counter.get(), &count, sizeof count) == sizeof count;
  if (!is_read || count.running == 0 || count.running != count.enabled) return -1;
  return static_cast<std::int64_t>(count.value);
}

constexpr std::int64_t kMuchFreed = std::int64_t{32} << 20;

// Of the process, whichever thread asks; RUSAGE_SELF would sum up the times of all threads, too.
std::int64_t largest_resident() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

// VmHWM of /proc/self/status; 0 if it cannot be read.
std::int64_t high_water_mark() {
  const Descriptor file(open("/proc/self/status", O_RDONLY | O_CLOEXEC));
  char text[8192];
  const ssize_t length = read(file.get(), text, sizeof text - 1);
  if (length <= 0) return 0;
  text[length] = '\0';
  const char* line = std::strstr(text, "VmHWM:");
  return line == nullptr ? 0 : std::strtoll(line + 6, nullptr, 10) * 1024;
}

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
  const Stopwatch time(kCpuTime);
  work();
  return time.seconds();
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

HardwareCounters::HardwareCounters() {
  for (std::size_t i = 0; i < counters_.size(); ++i) {
    counters_[i] = open_counter(kEvents[i].second);
    if (counters_[i].get() < 0 && availability_ == "available") {
      availability_ = fmt::format("absent: {}: {}", kEvents[i].first, std::strerror(errno));
    }
  }
}

void HardwareCounters::start() {
  for (const Descriptor& counter : counters_) {
    if (counter.get() < 0) continue;
    ioctl(counter.get(), PERF_EVENT_IOC_RESET, 0);
    ioctl(counter.get(), PERF_EVENT_IOC_ENABLE, 0);
  }
}

std::array<std::int64_t, 3> HardwareCounters::stop() {
  for (const Descriptor& counter : counters_) {
    if (counter.get() >= 0) ioctl(counter.get(), PERF_EVENT_IOC_DISABLE, 0);
  }
  return {value_of(counters_[0]), value_of(counters_[1]), value_of(counters_[2])};
}

const char* to_string(MemoryScope scope) {
  constexpr std::array<const char*, 3> kNames = {"process", "row", "worker"};
  return kNames.at(static_cast<std::size_t>(scope));
}

RowMemory::RowMemory(MemoryScope scope) : scope_(scope) {
  if (scope_ == MemoryScope::process) return;
  clear_refs_ = Descriptor(open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC));
  restart();
  if (scope_ == MemoryScope::process) return;
  // A process that was started by a larger one keeps that one's peak in getrusage for ever.
  const std::int64_t largest = largest_resident();
  first_base_ = high_water_mark();
  if (largest > first_base_) floor_ = largest;
}

std::int64_t RowMemory::begin_row() {
  if (scope_ == MemoryScope::process) return -1;
  restart();
  const std::int64_t base = peak_bytes();
  if (base - first_base_ <= kMuchFreed) return base;
  malloc_trim(0);
  restart();
  return peak_bytes();
}

void RowMemory::restart() {
  if (scope_ == MemoryScope::process) return;
  if (pwrite(clear_refs_.get(), "5", 1, 0) != 1) scope_ = MemoryScope::process;
}

std::int64_t RowMemory::peak_bytes() const {
  const std::int64_t largest = largest_resident();
  if (scope_ == MemoryScope::process || largest > floor_) return largest;
  return high_water_mark();
}

Yardsticks::Yardsticks() : cached_(random_heads(kCached)), memory_(random_heads(kMemory)) {
  queue_.reserve(kMemory);
}

// Breadth first, as all drawings begin.
void Yardsticks::search(const Heads& heads) {
  seen_.assign(heads.size() / kEdges, false);
  queue_.assign(1, 0);
  seen_[0] = true;
  for (std::size_t index = 0; index < queue_.size(); ++index) {
    const std::size_t first = std::size_t{kEdges} * queue_[index];
    for (std::size_t i = first; i < first + kEdges; ++i) {
      if (seen_[heads[i]]) continue;
      seen_[heads[i]] = true;
      queue_.push_back(heads[i]);
    }
  }
}

const std::array<double, 3>& Yardsticks::now_s() {
  const double now = clock_.seconds();
  if (now >= next_short_s_) {
    search(cached_);  // into the cache
    last_s_[0] = cpu_time_of([&] {
      for (int i = 0; i < kCachedSearches; ++i) search(cached_);
    });
    last_s_[2] = cpu_time_of(count_steps);
    next_short_s_ = now + kShortPauses * (clock_.seconds() - now);
  }
  if (now >= next_memory_s_) {
    last_s_[1] = cpu_time_of([&] { search(memory_); });
    next_memory_s_ = now + kMemoryPauses * last_s_[1];
  }
  return last_s_;
}

}  // namespace ar3d
