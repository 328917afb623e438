#include "ar3d/bench/measure/row_memory.h"

#include <fcntl.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace ar3d {
namespace {

constexpr std::int64_t kMuchFreed = std::int64_t{32} << 20;

// Of the process, whichever thread asks; RUSAGE_SELF would sum up the times of all threads, too.
std::int64_t largest_resident() {
  rusage usage{};
  getrusage(RUSAGE_THREAD, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

// VmHWM of /proc/self/status; 0 if it cannot be read.
std::int64_t high_water_mark() {
  const int file = open("/proc/self/status", O_RDONLY | O_CLOEXEC);
  if (file < 0) return 0;
  char text[8192];
  const ssize_t length = read(file, text, sizeof text - 1);
  close(file);
  if (length <= 0) return 0;
  text[length] = '\0';
  const char* line = std::strstr(text, "VmHWM:");
  return line == nullptr ? 0 : std::strtoll(line + 6, nullptr, 10) * 1024;
}

}  // namespace

const char* to_string(MemoryScope scope) {
  switch (scope) {
    case MemoryScope::row:
      return "row";
    case MemoryScope::worker:
      return "worker";
    case MemoryScope::process:
      break;
  }
  return "process";
}

RowMemory::RowMemory(MemoryScope scope) : scope_(scope) {
  if (scope_ == MemoryScope::process) return;
  clear_refs_ = open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
  restart();
  if (scope_ == MemoryScope::process) return;
  // A process that was started by a larger one keeps that one's peak in getrusage for ever.
  const std::int64_t told = largest_resident();
  first_base_ = high_water_mark();
  if (told > first_base_) floor_ = told;
}

RowMemory::~RowMemory() {
  if (clear_refs_ >= 0) close(clear_refs_);
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
  if (pwrite(clear_refs_, "5", 1, 0) != 1) scope_ = MemoryScope::process;
}

std::int64_t RowMemory::peak_bytes() const {
  const std::int64_t told = largest_resident();
  if (scope_ == MemoryScope::process || told > floor_) return told;
  return high_water_mark();
}

}  // namespace ar3d
