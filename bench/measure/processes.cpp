// Signals and child processes. A first signal asks the program to stop and later ones end it; no
// process that a row or a step started outlives it.
#include "ar3d/bench/measure/processes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <new>
#include <sstream>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/instruments.h"

namespace ar3d {
namespace {

std::atomic<bool> g_is_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free);  // so that a signal handler may set it

void note(int) { g_is_interrupted = true; }

void note_first(int signal) {
  g_is_interrupted = true;
  std::signal(signal, SIG_DFL);
}

/// Looks every 20 ms whether the child has ended or is to.
void watch(Child& child, const ChildOptions& options) {
  const Stopwatch time;
  double next_call_s = 1, patience_s = 0;  // until the latter it may end by itself
  while (!child.has_ended()) {
    const double now_s = time.seconds();
    if (options.limit_s && now_s > *options.limit_s) child.kill();
    if (options.ends_when_interrupted && is_interrupted()) {
      if (patience_s == 0) {
        patience_s = now_s + 10;
        child.send(SIGINT);
      } else if (now_s > patience_s) {
        child.kill();
      }
    }
    if (options.every_second && now_s >= next_call_s) {
      options.every_second();
      next_call_s = now_s + 1;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

// Runs a program whose output goes to an open file.
int run_child(const std::vector<std::string>& words, const ChildOptions& options, int output) {
  const Descriptor nothing(open("/dev/null", O_RDONLY | O_CLOEXEC));
  Child child = Child::of_program(
      words,
      {.streams = {nothing.get(), output, output}, .core = options.core, .death_signal = SIGTERM});
  if (options.ends_when_interrupted || options.every_second || options.limit_s) {
    watch(child, options);
  }
  const int status = child.wait();
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

constexpr int kOutOfMemory = 3;
constexpr double kNoLimit = 1e15;  // more seconds than any machine has

void set_limits(const std::optional<double>& cpu_s, double memory_bytes) {
  if (cpu_s && *cpu_s < kNoLimit) {
    const auto soft = static_cast<rlim_t>(std::ceil(*cpu_s));
    const rlimit both{soft, soft + 1};  // the soft one has a signal of its own
    setrlimit(RLIMIT_CPU, &both);
  }
  if (std::string_view(build_kind()) != "sanitised") limit_address_space(memory_bytes);
}

}  // namespace

Interruptible::Interruptible(bool ignores_second) {
  g_is_interrupted = false;
  const auto handler = ignores_second ? note : note_first;
  before_ = {std::signal(SIGINT, handler), std::signal(SIGTERM, handler),
             std::signal(SIGHUP, SIG_IGN)};
  if (before_[2] != SIG_IGN) std::signal(SIGHUP, handler);
}

Interruptible::~Interruptible() {
  std::signal(SIGINT, before_[0]);
  std::signal(SIGTERM, before_[1]);
  std::signal(SIGHUP, before_[2]);
  g_is_interrupted = false;
}

bool is_interrupted() { return g_is_interrupted; }

int run_child(const std::vector<std::string>& words, const ChildOptions& options) {
  const Descriptor log(
      open(options.output.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (log.get() < 0) refuse_writing(options.output, errno);
  return run_child(words, options, log.get());
}

std::vector<std::string> ask_git(std::vector<std::string> words) {
  const Descriptor memory(memfd_create("git", MFD_CLOEXEC));  // no file that anybody could name
  if (memory.get() < 0) throw InputError(fmt::format("cannot ask git: {}", std::strerror(errno)));
  words.insert(words.begin(), "git");
  std::vector<std::string> lines;
  if (run_child(words, {}, memory.get()) != 0) return lines;
  const off_t size = lseek(memory.get(), 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::max<off_t>(size, 0)), '\0');
  read_whole(memory.get(), text, 0);
  std::istringstream file(text);
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

rlimit limit_address_space(double bytes) {
  rlimit before{RLIM_INFINITY, RLIM_INFINITY};
  getrlimit(RLIMIT_AS, &before);
  rlimit limit = before;
  const double sum = address_space_bytes() + bytes;
  if (sum < 9e18) limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(sum));
  setrlimit(RLIMIT_AS, &limit);
  return before;
}

RunStatus run_within(std::optional<double> cpu_s, double memory_bytes, std::span<char> result,
                     const std::function<void()>& step) {
  Child child = Child::forked({}, [&](int socket) {
    try {
      set_limits(cpu_s, memory_bytes);
      step();
    } catch (const std::bad_alloc&) {
      return kOutOfMemory;
    }
    return send_all(socket, result) ? 0 : 1;
  });
  // One that computes nothing, since it waits for ever, ends after this time, as rows do.
  double left_s = 10 * std::ceil(cpu_s.value_or(kNoLimit)) + 1;
  const bool came = receive_within(child.socket(), result, left_s, is_interrupted);
  const bool late = !came && left_s <= 0;
  if (late || is_interrupted()) child.send(SIGKILL);
  const int status = child.wait();
  if (late) return RunStatus::timeout;
  if (came && WIFEXITED(status) && WEXITSTATUS(status) == 0) return RunStatus::ok;
  if (is_interrupted()) return RunStatus::crashed;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return RunStatus::timeout;
  const bool memory = WIFEXITED(status) ? WEXITSTATUS(status) == kOutOfMemory
                                        : WTERMSIG(status) == SIGKILL;  // the system wanted it
  return memory ? RunStatus::out_of_memory : RunStatus::crashed;
}

}  // namespace ar3d
