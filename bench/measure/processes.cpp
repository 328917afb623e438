#include "ar3d/bench/measure/processes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/environment.h"

namespace ar3d {
namespace {

std::atomic<bool> g_is_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // so that a signal handler may set it

void note(int) { g_is_interrupted = true; }

void note_first(int signal) {
  g_is_interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

Interruptible::Interruptible(SecondSignal second) {
  g_is_interrupted = false;
  const auto handler = second == SecondSignal::is_ignored ? note : note_first;
  before_int_ = std::signal(SIGINT, handler);
  before_term_ = std::signal(SIGTERM, handler);
}

Interruptible::~Interruptible() {
  std::signal(SIGINT, before_int_);
  std::signal(SIGTERM, before_term_);
  g_is_interrupted = false;
}

bool is_interrupted() { return g_is_interrupted; }

namespace {

constexpr int kCannotRun = 127;

/// Never returns. Only calls that are allowed between fork and exec.
[[noreturn]] void become(char* const* words, const ChildOptions& options) {
  std::signal(SIGINT, SIG_DFL);
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0) _exit(kCannotRun);
  const int log = open(options.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (log < 0 || nothing < 0) _exit(kCannotRun);
  if (dup2(nothing, 0) < 0 || dup2(log, 1) < 0 || dup2(log, 2) < 0) _exit(kCannotRun);
  if (options.core >= 0) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<std::size_t>(options.core), &set);
    if (sched_setaffinity(0, sizeof(set), &set) != 0) _exit(kCannotRun);
  }
  execvp(words[0], words);
  _exit(kCannotRun);
}

/// Looks every 20 ms whether the child has ended or is to. @return as waitpid.
pid_t watch(pid_t child, int& status, const ChildOptions& options) {
  using Clock = std::chrono::steady_clock;
  auto next_call = Clock::now() + std::chrono::seconds(1);
  Clock::time_point patience{};  // until then it may end by itself
  while (true) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended != 0 && !(ended < 0 && errno == EINTR)) return ended;
    const auto now = Clock::now();
    if (options.ends_when_interrupted && is_interrupted()) {
      if (patience == Clock::time_point{}) {
        patience = now + std::chrono::seconds(10);
        kill(child, SIGINT);
      } else if (now > patience) {
        kill(child, SIGKILL);
      }
    }
    if (options.every_second && now >= next_call) {
      options.every_second();
      next_call = now + std::chrono::seconds(1);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

int run_child(const std::vector<std::string>& words, const ChildOptions& options) {
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  const bool is_watched = options.ends_when_interrupted || options.every_second;
  const auto interrupt = options.ends_when_interrupted ? SIG_DFL : std::signal(SIGINT, SIG_IGN);
  const pid_t child = fork();
  if (child == 0) become(pointers.data(), options);
  int status = 0;
  pid_t ended = child;
  if (child > 0 && is_watched) {
    ended = watch(child, status, options);
  } else if (child > 0) {
    do ended = waitpid(child, &status, 0);
    while (ended < 0 && errno == EINTR);
  }
  const int reason = errno;
  if (!options.ends_when_interrupted) std::signal(SIGINT, interrupt);
  if (ended < 0)
    throw InputError(fmt::format("cannot run {}: {}", words[0], std::strerror(reason)));
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

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
