// A process of its own for a library that forged files can crash: what it breaks there is only its
// own memory, and all that comes back is bytes whose length is sent first.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <exception>

#include "ar3d/base/error.h"
#include "ar3d/store/hdf5/results_file.h"

namespace ar3d {
namespace {

constexpr rlim_t kMostCpuSeconds = 20;                            // for an answer
constexpr std::uint64_t kLargestAnswer = std::uint64_t{1} << 31;  // bytes

// What stands before an answer: its bytes; 1, or 0 if it is the message of an exception.
using AnswerHead = std::array<std::uint64_t, 2>;

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
  std::uint64_t question = 0;
  while (receive_all(socket, bytes_in(question))) {
    limit_cpu_time();
    AnswerHead head = {0, 1};
    std::string answer;
    try {
      answer = answers(question);
    } catch (const std::exception& error) {
      answer = error.what();
      head[1] = 0;
    }
    head[0] = answer.size();
    if (!send_all(socket, bytes_in(head)) || !send_all(socket, answer)) {
      return;
    }
  }
}

}  // namespace

ReaderProcess::ReaderProcess(std::string path, const Descriptor& file, const Answers& answers,
                             double limit_s)
    : path_(std::move(path)), limit_s_(limit_s) {
  const Descriptor nothing(open("/dev/null", O_WRONLY | O_CLOEXEC));
  // Standard error takes what a library says when it breaks.
  child_ = Child::forked(
      {.streams = {-1, -1, nothing.get()}, .kept = {{file.get()}}, .starts_programs = false},
      [&](int socket) {
        answer_all(socket, answers);
        return 0;
      });
}

const std::string& ReaderProcess::ask(std::uint64_t question) {
  constexpr std::size_t kPiece = std::size_t{1} << 20;  // memory comes with the bytes that fill it
  double left_s = limit_s_;
  AnswerHead head{};
  if (child_.has_ended() || !send_all(child_.socket(), bytes_in(question)) ||
      !receive_within(child_.socket(), bytes_in(head), left_s) || head[0] > kLargestAnswer) {
    refuse(left_s);
  }
  answer_.clear();
  while (answer_.size() < head[0]) {
    const std::size_t done = answer_.size();
    answer_.resize(std::min<std::size_t>(head[0], done + kPiece));
    const auto piece = std::span(answer_).subspan(done);
    if (!receive_within(child_.socket(), piece, left_s)) refuse(left_s);
  }
  if (head[1] == 0) {  // a broken child may say anything
    const bool is_named = answer_.find(path_) != std::string::npos;
    throw InputError(is_named ? answer_ : fmt::format("{}: reading it says {}", path_, answer_));
  }
  return answer_;
}

void ReaderProcess::refuse(double left_s) {
  child_.send(SIGKILL);  // does nothing to one that has ended
  const int status = child_.wait();
  const bool is_late = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
  if (left_s <= 0 || is_late) {
    throw InputError(
        fmt::format("{} is damaged: after {} s of reading a part of it there is no end", path_,
                    is_late ? static_cast<double>(kMostCpuSeconds) : limit_s_));
  }
  throw InputError(fmt::format(
      "{} is damaged, or another program has made its checksum: reading it has crashed", path_));
}

}  // namespace ar3d
