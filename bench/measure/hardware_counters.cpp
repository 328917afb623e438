#include "ar3d/bench/measure/hardware_counters.h"

#include <fmt/format.h>
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace ar3d {
namespace {

struct Event {
  const char* name;
  std::uint64_t number;
};

constexpr std::array<Event, 3> kEvents = {{{"instructions", PERF_COUNT_HW_INSTRUCTIONS},
                                           {"cycles", PERF_COUNT_HW_CPU_CYCLES},
                                           {"cache misses", PERF_COUNT_HW_CACHE_MISSES}}};

int open_counter(std::uint64_t event) {
  perf_event_attr attributes{};
  attributes.size = sizeof attributes;
  attributes.type = PERF_TYPE_HARDWARE;
  attributes.config = event;
  attributes.disabled = 1;
  attributes.exclude_kernel = 1;
  attributes.exclude_hv = 1;
  attributes.read_format = PERF_FORMAT_TOTAL_TIME_ENABLED | PERF_FORMAT_TOTAL_TIME_RUNNING;
  return static_cast<int>(
      syscall(SYS_perf_event_open, &attributes, 0, -1, -1, PERF_FLAG_FD_CLOEXEC));
}

// -1 if there is no such counter or it did not run all the time.
std::int64_t value_of(int descriptor) {
  if (descriptor < 0) return -1;
  struct {
    std::uint64_t value;
    std::uint64_t enabled;
    std::uint64_t running;
  } count{};
  if (read(descriptor, &count, sizeof count) != sizeof count) return -1;
  if (count.running == 0 || count.running != count.enabled) return -1;
  return static_cast<std::int64_t>(count.value);
}

}  // namespace

HardwareCounters::HardwareCounters() {
  for (std::size_t i = 0; i < kCounters; ++i) {
    descriptors_[i] = open_counter(kEvents[i].number);
    if (descriptors_[i] < 0 && availability_ == "available") {
      availability_ = fmt::format("absent: {}: {}", kEvents[i].name, std::strerror(errno));
    }
  }
}

HardwareCounters::~HardwareCounters() {
  for (const int descriptor : descriptors_) {
    if (descriptor >= 0) close(descriptor);
  }
}

void HardwareCounters::start() {
  for (const int descriptor : descriptors_) {
    if (descriptor < 0) continue;
    ioctl(descriptor, PERF_EVENT_IOC_RESET, 0);
    ioctl(descriptor, PERF_EVENT_IOC_ENABLE, 0);
  }
}

CountedEvents HardwareCounters::stop() {
  for (const int descriptor : descriptors_) {
    if (descriptor >= 0) ioctl(descriptor, PERF_EVENT_IOC_DISABLE, 0);
  }
  return {value_of(descriptors_[0]), value_of(descriptors_[1]), value_of(descriptors_[2])};
}

}  // namespace ar3d
