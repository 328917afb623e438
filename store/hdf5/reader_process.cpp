// A process of its own for a library that forged files can crash: what it breaks there is only its
// own memory, and all that comes back is bytes of a length that is told before.
#include "ar3d/store/hdf5/reader_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/system_calls.h"

namespace ar3d {
namespace {

constexpr rlim_t kMostCpuSeconds = 20;                            // for an answer
constexpr std::uint64_t kLargestAnswer = std::uint64_t{1} << 31;  // bytes

// What stands before an answer.
struct AnswerHead {
  std::uint64_t size = 0;
  std::uint64_t is_answer = 0;  // else it is the message of an exception
};

void limit_cpu_time() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  rlimit limit{};
  getrlimit(RLIMIT_CPU, &limit);
  const rlim_t now = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
  limit.rlim_cur = std::min(limit.rlim_max, now + kMostCpuSeconds);
  setrlimit(RLIMIT_CPU, &limit);
}

// Until the parent hangs up.
void answer_all(int socket, const ReaderProcess::Answers& answers) {
  const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, 2);  // what a library says when it breaks
  leave_no_core();
  signal(SIGXCPU, SIG_DFL);
  std::uint64_t question = 0;
  while (receive_all(socket, bytes_in(question))) {
    limit_cpu_time();
    AnswerHead head{.size = 0, .is_answer = 1};
    std::string answer;
    try {
      answer = answers(question);
    } catch (const std::exception& error) {
      answer = error.what();
      head.is_answer = 0;
    }
    head.size = answer.size();
    if (!send_all(socket, bytes_in(head)) || !send_all(socket, answer)) {
      return;
    }
  }
}

}  // namespace

ReaderProcess::ReaderProcess(std::string path, const Descriptor& file, const Answers& answers)
    : path_(std::move(path)) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw InputError(fmt::format("cannot read {}: {}", path_, std::strerror(errno)));
  }
  socket_ = Descriptor(ends[0]);
  const Descriptor theirs(ends[1]);
  pid_ = fork();
  if (pid_ < 0) throw InputError(fmt::format("cannot read {}: {}", path_, std::strerror(errno)));
  if (pid_ > 0) return;
  try {
    close_descriptors_but({theirs.get(), file.get()});
    answer_all(theirs.get(), answers);
  } catch (...) {
    _exit(1);
  }
  _exit(0);
}

ReaderProcess::~ReaderProcess() {
  if (pid_ < 0) return;
  kill(pid_, SIGKILL);
  wait_for_end(pid_);
}

const std::string& ReaderProcess::ask(std::uint64_t question) {
  AnswerHead head;
  if (pid_ < 0 || !send_all(socket_.get(), bytes_in(question)) ||
      !receive_all(socket_.get(), bytes_in(head)) || head.size > kLargestAnswer) {
    refuse();
  }
  answer_.resize(head.size);
  if (!receive_all(socket_.get(), answer_)) refuse();
  if (head.is_answer == 0) throw InputError(answer_);
  return answer_;
}

void ReaderProcess::refuse() {
  int status = 0;
  if (pid_ > 0) {
    kill(pid_, SIGKILL);  // does nothing to one that has ended
    status = wait_for_end(pid_);
    pid_ = -1;
  }
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) {
    throw InputError(
        fmt::format("{} is damaged: after {} s of reading a part of it there is no end", path_,
                    kMostCpuSeconds));
  }
  throw InputError(fmt::format(
      "{} is damaged, or another program has made its checksum: reading it has crashed", path_));
}

}  // namespace ar3d
