#include "ar3d/store/hdf5/apart.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <exception>
#include <utility>

#include "ar3d/base/descriptor.h"
#include "ar3d/base/error.h"

namespace ar3d {
namespace {

void set_limit(__rlimit_resource resource, rlim_t value) {
  const rlimit limit{value, value};
  setrlimit(resource, &limit);
}

// In the child: nothing of it shall be seen but the message.
[[noreturn]] void become_child(const std::function<void()>& step, unsigned cpu_seconds,
                               int messages) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGABRT, SIGFPE}) {
    signal(number, SIG_DFL);
  }
  set_limit(RLIMIT_CORE, 0);
  set_limit(RLIMIT_CPU, cpu_seconds);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  dup2(nowhere, STDERR_FILENO);
  std::string problem;
  try {
    step();
    _exit(0);
  } catch (const std::exception& error) {
    problem = error.what();
  } catch (...) {
    problem = "unknown error";
  }
  const ssize_t written =
      write(messages, problem.data(), std::min<std::size_t>(problem.size(), 4000));
  _exit(written < 0 ? 2 : 1);
}

std::string read_all(int file) {
  std::string text;
  std::array<char, 4096> block{};
  for (;;) {
    const ssize_t got = read(file, block.data(), block.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(got));
  }
}

std::string ending_of(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) {
    return fmt::format("the process that read it was ended by: {}", strsignal(WTERMSIG(status)));
  }
  if (WEXITSTATUS(status) == 0) return "";
  return "the process that read it failed";
}

}  // namespace

std::string do_apart(const std::function<void()>& step, unsigned cpu_seconds) {
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw InputError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  }
  const Descriptor messages(ends[0]);
  Descriptor child_end(ends[1]);
  const pid_t child = fork();
  if (child < 0) throw InputError(fmt::format("cannot make a process: {}", std::strerror(errno)));
  if (child == 0) become_child(step, cpu_seconds, child_end.get());
  { const Descriptor closed = std::move(child_end); }
  const std::string problem = read_all(messages.get());
  const std::string ending = ending_of(child);
  return problem.empty() ? ending : problem;
}

}  // namespace ar3d
