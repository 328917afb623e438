#include "ar3d/bench/measure/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/bench/measure/interruption.h"

namespace ar3d {
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

}  // namespace ar3d
