#include "ar3d/bench/measure/processes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <new>
#include <string_view>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/system_calls.h"
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

// The process whose child a process is; 0: it is gone.
pid_t parent_of(pid_t process) {
  std::ifstream in(fmt::format("/proc/{}/stat", process));
  std::string line;
  std::getline(in, line);
  const std::size_t name_end = line.rfind(')');  // the name may hold anything
  char state = 0;
  pid_t parent = 0;
  if (name_end == std::string::npos) return 0;
  return std::sscanf(line.c_str() + name_end + 1, " %c %d", &state, &parent) == 2 ? parent : 0;
}

std::vector<pid_t> children() {
  std::vector<pid_t> found;
  std::error_code error;
  for (std::filesystem::directory_iterator at("/proc", error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    pid_t process = 0;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), process);
    if (read.ptr != name.data() + name.size() || parent_of(process) != getpid()) continue;
    found.push_back(process);
  }
  return found;
}

}  // namespace

Orphanage::Orphanage() : before_(children()) {
  prctl(PR_GET_CHILD_SUBREAPER, &was_subreaper_);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
}

Orphanage::~Orphanage() {
  end_others({});
  prctl(PR_SET_CHILD_SUBREAPER, was_subreaper_);
}

void Orphanage::end_others(const std::vector<pid_t>& own) const {
  const auto has = [](const std::vector<pid_t>& all, pid_t process) {
    return std::find(all.begin(), all.end(), process) != all.end();
  };
  for (bool any = true; any;) {  // the children of one that ends come here, too
    any = false;
    for (const pid_t process : children()) {
      if (has(before_, process) || has(own, process)) continue;
      if (kill(process, SIGKILL) != 0) continue;
      any = true;
      wait_for_end(process);
    }
  }
}

namespace {

constexpr int kCannotRun = 127;

/// Never returns. Only calls that are allowed between fork and exec.
[[noreturn]] void become(char* const* words, const ChildOptions& options) {
  std::signal(SIGINT, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // it goes with this process, however that ends
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

GitAnswer ask_git(std::vector<std::string> words) {
  const Descriptor memory(memfd_create("git", MFD_CLOEXEC));  // no file that anybody could name
  if (memory.get() < 0) throw InputError(fmt::format("cannot ask git: {}", std::strerror(errno)));
  const std::string output = fmt::format("/proc/self/fd/{}", memory.get());
  words.insert(words.begin(), "git");
  GitAnswer answer;
  answer.exit_code = run_child(words, {.output = output});
  std::ifstream file(output);
  for (std::string line; std::getline(file, line);) answer.lines.push_back(line);
  return answer;
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

void set_limits(const StepLimits& limits) {
  if (limits.cpu_s && *limits.cpu_s < kNoLimit) limit(RLIMIT_CPU, std::ceil(*limits.cpu_s));
  const bool sanitised = std::string_view(build_kind()) == "sanitised";
  if (limits.memory_bytes && *limits.memory_bytes < kNoLimit && !sanitised) {
    limit(RLIMIT_AS, address_space_bytes() + *limits.memory_bytes);
  }
  leave_no_core();
}

// One that computes nothing, since it waits for ever, ends after this time, as rows do.
double idle_limit_s(double cpu_s) { return 10 * cpu_s + 1; }

bool read_all(int file, std::span<char> bytes, std::optional<double> cpu_s) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  while (!bytes.empty()) {
    if (cpu_s && *cpu_s < kNoLimit) {
      const std::chrono::duration<double> waited = Clock::now() - begin;
      const double left_s = idle_limit_s(std::ceil(*cpu_s)) - waited.count();
      if (left_s <= 0) return false;
      pollfd event{file, POLLIN, 0};
      if (poll(&event, 1, static_cast<int>(1000 * std::min(left_s, 1.0)) + 1) <= 0) continue;
    }
    const ssize_t got = read(file, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

// Whether nobody is left who writes into a pipe that has no bytes.
bool is_at_end(int file) {
  pollfd event{file, POLLIN, 0};
  char byte = 0;
  return poll(&event, 1, 0) > 0 && read(file, &byte, 1) == 0;
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
  _exit(write_whole(pipe, result) == result.size() ? 0 : kFailed);
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
  const bool came = child > 0 && read_all(ends[0], result, limits.cpu_s);
  const bool ended = came || (child > 0 && is_at_end(ends[0]));
  close(ends[0]);
  if (child > 0 && !ended) kill(child, SIGKILL);
  if (child < 0) {
    throw InputError(fmt::format("cannot start a process: {}", std::strerror(reason)));
  }
  const int status = wait_for_end(child);
  if (child > 0 && !ended) return StepEnd::out_of_time;
  if (came && WIFEXITED(status) && WEXITSTATUS(status) == 0) return StepEnd::done;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return StepEnd::out_of_time;
  const bool memory = WIFEXITED(status) ? WEXITSTATUS(status) == kOutOfMemory
                                        : WTERMSIG(status) == SIGKILL;  // the system wanted it
  return memory ? StepEnd::out_of_memory : StepEnd::failed;
}

}  // namespace ar3d
