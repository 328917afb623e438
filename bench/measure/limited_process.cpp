#include "ar3d/bench/measure/limited_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/one_thread.h"

namespace ar3d {
namespace {

constexpr int kOutOfMemory = 3;
constexpr int kFailed = 4;
constexpr double kNoLimit = 1e15;  // more seconds or bytes than any machine has

void limit(__rlimit_resource resource, double value) {
  const auto soft = static_cast<rlim_t>(value);
  const rlimit both{soft, soft + 1};  // of CPU time the soft one has a signal of its own
  setrlimit(resource, &both);
}

double address_space_bytes() {
  std::ifstream in("/proc/self/statm");
  double pages = 0;
  in >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void set_limits(const StepLimits& limits) {
  if (limits.cpu_s && *limits.cpu_s < kNoLimit) limit(RLIMIT_CPU, std::ceil(*limits.cpu_s));
  const bool sanitised = std::string_view(build_kind()) == "sanitised";
  if (limits.memory_bytes && *limits.memory_bytes < kNoLimit && !sanitised) {
    limit(RLIMIT_AS, address_space_bytes() + *limits.memory_bytes);
  }
  limit(RLIMIT_CORE, 0);
}

bool write_all(int file, std::span<const char> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return true;
}

bool read_all(int file, std::span<char> bytes) {
  while (!bytes.empty()) {
    const ssize_t got = read(file, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

[[noreturn]] void be_the_process(pid_t parent, int pipe, const StepLimits& limits,
                                 std::span<const char> result, const std::function<void()>& step) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kFailed);
  signal(SIGINT, SIG_DFL);
  signal(SIGTERM, SIG_DFL);
  try {
    set_limits(limits);
    omp_set_num_threads(1);  // a forked process has none of its parent's other threads
    step();
  } catch (const std::bad_alloc&) {
    _exit(kOutOfMemory);
  } catch (...) {
    _exit(kFailed);
  }
  _exit(write_all(pipe, result) ? 0 : kFailed);
}

}  // namespace

StepEnd run_within(const StepLimits& limits, std::span<char> result,
                   const std::function<void()>& step) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw InputError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  }
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) be_the_process(parent, ends[1], limits, result, step);
  const int reason = errno;
  close(ends[1]);
  const bool came = child > 0 && read_all(ends[0], result);
  close(ends[0]);
  if (child < 0) {
    throw InputError(fmt::format("cannot start a process: {}", std::strerror(reason)));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (came && WIFEXITED(status) && WEXITSTATUS(status) == 0) return StepEnd::done;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return StepEnd::out_of_time;
  const bool memory = WIFEXITED(status) ? WEXITSTATUS(status) == kOutOfMemory
                                        : WTERMSIG(status) == SIGKILL;  // the system wanted it
  return memory ? StepEnd::out_of_memory : StepEnd::failed;
}

}  // namespace ar3d
