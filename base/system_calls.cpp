// System calls until they are done, and all processes that this one starts: forked ones go on here,
// programs are executed. Each leads a group, so that one signal reaches what it has started; what
// left the group is found by a mark in its environment. None outlives its parent.
#include "ar3d/base/system_calls.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <omp.h>
#include <poll.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

/// Calls step(done) for what is left of so many bytes.
template <class Step>
std::size_t in_pieces(std::size_t size, const Step& step) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t more = step(done);
    if (more < 0 && errno == EINTR) continue;
    if (more == 0) errno = 0;
    if (more <= 0) break;
    done += static_cast<std::size_t>(more);
  }
  return done;
}

ssize_t or_failed(ssize_t written) {
  if (written == 0) errno = EIO;
  return written == 0 ? -1 : written;
}

// Orphans come to this process as long as it has children that may leave some. @param more  or
// fewer of these children.
void adopt_orphans_of(int more) {
  static std::mutex mutex;
  static pid_t process = 0;
  static int children = 0, was_subreaper = 0;
  const std::lock_guard lock(mutex);
  if (std::exchange(process, getpid()) != getpid()) children = 0;  // those of a forked one's parent
  if (children == 0) prctl(PR_GET_CHILD_SUBREAPER, &was_subreaper);
  children += more;
  prctl(PR_SET_CHILD_SUBREAPER, children > 0 ? 1 : was_subreaper);
}

std::string new_mark() {
  static std::atomic<unsigned> number = 0;
  return fmt::format("AR3D_CHILD_OF_{}_{}", getpid(), number++);
}

bool has_in_environment(pid_t process, const std::string& name) {
  std::ifstream in(fmt::format("/proc/{}/environ", process), std::ios::binary);
  for (std::string entry; std::getline(in, entry, '\0');) {
    if (entry.starts_with(name + "=")) return true;
  }
  return false;
}

// Children of this process that have the name in their environment.
std::vector<pid_t> children_with(const std::string& name) {
  std::vector<pid_t> found;
  std::error_code error;
  for (std::filesystem::directory_iterator at("/proc/self/task", error), end; !error && at != end;
       at.increment(error)) {
    std::ifstream in(at->path() / "children");
    for (pid_t process = 0; in >> process;) {
      if (has_in_environment(process, name)) found.push_back(process);
    }
  }
  return found;
}

// And their children, which come here as they end.
void end_orphans(const std::string& mark) {
  for (auto orphans = children_with(mark); !orphans.empty(); orphans = children_with(mark)) {
    for (const pid_t orphan : orphans) {
      ::kill(orphan, SIGKILL);
      while (waitpid(orphan, nullptr, 0) < 0 && errno == EINTR) {
      }
    }
  }
}

constexpr int kCannotRun = 127;

// From here to the end of become_child(): perhaps beside other threads, so system calls only.
void reset_signals() {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGXFSZ, SIGXCPU}) signal(number, SIG_DFL);
  struct sigaction hangup {};
  sigaction(SIGHUP, nullptr, &hangup);
  if (hangup.sa_handler != SIG_IGN) signal(SIGHUP, SIG_DFL);  // nohup holds for children, too
}

bool stays_on(int core) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(core), &set);
  return sched_setaffinity(0, sizeof(set), &set) == 0;
}

bool takes_streams(const std::array<int, 3>& streams) {
  for (int number = 0; number < 3; ++number) {
    const int given = streams[static_cast<std::size_t>(number)];
    if (given >= 0 && dup2(given, number) < 0) return false;
  }
  return true;
}

// @param kept  sorted.
void close_all_but(const std::vector<int>& kept) {
  unsigned from = 3;
  for (const int descriptor : kept) {
    const auto number = static_cast<unsigned>(descriptor);
    if (number > from) close_range(from, number - 1, 0);
    from = std::max(from, number + 1);
  }
  close_range(from, ~0U, 0);
}

void become_child(pid_t parent, const ChildSetup& setup) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, setup.death_signal);
  if (getppid() != parent) _exit(kCannotRun);  // it died before it could be asked to take us along
  reset_signals();
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (!takes_streams(setup.streams)) _exit(kCannotRun);
  if (setup.core >= 0 && !stays_on(setup.core)) _exit(kCannotRun);
}

pid_t fork_or_refuse(const std::string& what) {
  const pid_t child = fork();
  if (child < 0) {
    throw InputError(fmt::format("cannot start {}: {}", what, std::strerror(errno)));
  }
  if (child > 0) setpgid(child, child);  // the parent or the child, whichever comes first
  return child;
}

}  // namespace

std::size_t write_whole(int descriptor, std::span<const char> bytes) {
  return in_pieces(bytes.size(), [&](std::size_t done) {
    return or_failed(write(descriptor, bytes.data() + done, bytes.size() - done));
  });
}

std::size_t write_whole(int descriptor, std::span<const char> bytes, std::uint64_t offset) {
  return in_pieces(bytes.size(), [&](std::size_t done) {
    return or_failed(pwrite(descriptor, bytes.data() + done, bytes.size() - done,
                            static_cast<off_t>(offset + done)));
  });
}

std::size_t read_whole(int descriptor, std::span<char> bytes, std::uint64_t offset) {
  return in_pieces(bytes.size(), [&](std::size_t done) {
    return pread(descriptor, bytes.data() + done, bytes.size() - done,
                 static_cast<off_t>(offset + done));
  });
}

bool send_all(int socket, std::span<const char> bytes) {
  return in_pieces(bytes.size(), [&](std::size_t done) {
           return send(socket, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
         }) == bytes.size();
}

bool receive_all(int socket, std::span<char> bytes) {
  return in_pieces(bytes.size(), [&](std::size_t done) {
           return recv(socket, bytes.data() + done, bytes.size() - done, 0);
         }) == bytes.size();
}

bool receive_within(int socket, std::span<char> bytes, double& left_s,
                    const std::function<bool()>& stop) {
  using Clock = std::chrono::steady_clock;
  while (!bytes.empty()) {
    if (left_s <= 0 || (stop && stop())) return false;
    const auto before = Clock::now();
    pollfd event{socket, POLLIN, 0};
    poll(&event, 1, static_cast<int>(1000 * std::min(left_s, 1.0)) + 1);
    left_s -= std::min(std::chrono::duration<double>(Clock::now() - before).count(), 2.0);
    const ssize_t got = recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    if (got <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

bool has_its_name(int descriptor, const std::string& path) {
  struct stat opened {};
  struct stat named {};
  return fstat(descriptor, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

double address_space_bytes() {
  std::ifstream in("/proc/self/statm");
  double pages = 0;
  in >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Child& Child::operator=(Child&& other) noexcept {
  kill();
  pid_ = std::exchange(other.pid_, -1);
  status_ = other.status_;
  run_error_ = other.run_error_;
  socket_ = std::move(other.socket_);
  mark_ = std::exchange(other.mark_, "");
  return *this;
}

std::pair<Descriptor, Descriptor> new_pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) == 0) return {Descriptor(ends[0]), Descriptor(ends[1])};
  throw InputError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
}

Child Child::forked(ChildSetup setup, const std::function<int(int)>& body) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    throw InputError(fmt::format("cannot make a socket: {}", std::strerror(errno)));
  }
  Descriptor ours(ends[0]);
  const Descriptor theirs(ends[1]);
  if (setup.kept) setup.kept->push_back(theirs.get());
  if (setup.kept) std::sort(setup.kept->begin(), setup.kept->end());
  const pid_t parent = getpid();
  Child child;
  if (setup.starts_programs) child.take_orphans(new_mark());
  child.pid_ = fork_or_refuse("a process");
  if (child.pid_ > 0) {
    child.socket_ = std::move(ours);
    return child;
  }
  ours = Descriptor();
  become_child(parent, setup);
  if (setup.starts_programs) setenv(child.mark_.c_str(), "1", 1);
  if (setup.kept) close_all_but(*setup.kept);
  int code = 1;
  try {
    omp_set_num_threads(1);  // a forked process has none of its parent's other threads
    code = body(theirs.get());
  } catch (...) {  // nothing may come back to the parent's stack
  }
  _exit(code);
}

Child Child::of_program(std::vector<std::string> words, const ChildSetup& setup) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  Child child;
  child.take_orphans(new_mark());
  std::string entry = child.mark_ + "=1";
  std::vector<char*> environment = {entry.data()};
  for (char** at = environ; at != nullptr && *at != nullptr; ++at) environment.push_back(*at);
  environment.push_back(nullptr);
  auto [failure, theirs] = new_pipe();
  const pid_t parent = getpid();
  child.pid_ = fork_or_refuse(words[0]);
  if (child.pid_ == 0) {
    become_child(parent, setup);
    close_range(3, ~0U, CLOSE_RANGE_CLOEXEC);  // journals and graphs are none of its business
    execvpe(arguments[0], arguments.data(), environment.data());
    const int error = errno;
    write_whole(theirs.get(), {reinterpret_cast<const char*>(&error), sizeof error});
    _exit(kCannotRun);
  }
  theirs = Descriptor();
  while (read(failure.get(), &child.run_error_, sizeof child.run_error_) < 0 && errno == EINTR) {
  }
  return child;
}

void Child::take_orphans(std::string mark) {
  mark_ = std::move(mark);
  adopt_orphans_of(+1);
}

bool Child::has_ended() {
  siginfo_t info{};
  if (pid_ > 0 &&
      (waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
       info.si_pid != 0)) {
    finish();
  }
  return pid_ < 0;
}

int Child::wait() {
  siginfo_t info{};
  while (pid_ > 0 && waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOWAIT) != 0 &&
         errno == EINTR) {
  }
  return finish();
}

// The group goes first: while its leader is a zombie, no other process can have its number.
int Child::finish() {
  if (pid_ > 0) {
    ::kill(-pid_, SIGKILL);
    while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
    }
    while (waitpid(-pid_, nullptr, 0) > 0 || errno == EINTR) {  // orphans of the group, now here
    }
    pid_ = -1;
    if (!mark_.empty()) end_orphans(mark_);
  }
  if (!mark_.empty()) adopt_orphans_of(-1);
  mark_.clear();
  return status_;
}

void Child::send(int signal) const {
  if (pid_ > 0) ::kill(-pid_, signal);
}

void Child::kill() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);  // should it not have got as far as its own group
  finish();
}

double Child::cpu_s() const {
  clockid_t clock{};
  timespec time{};
  if (pid_ < 0 || clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

std::uint32_t quota_threads(const std::string& group, const std::string& root) {
  std::ifstream groups(group);
  std::string path;  // of the own group in the hierarchy of version 2: "0::/path"
  for (std::string line; std::getline(groups, line);) {
    if (line.starts_with("0::/")) path = line.substr(3);
  }
  double least = UINT32_MAX;
  for (;; path.resize(path.rfind('/'))) {
    std::ifstream file(root + path + "/cpu.max");
    double quota = 0, period = 0;  // "max" is no number
    if (file >> quota >> period && period > 0) least = std::min(least, quota / period);
    if (path.empty()) return static_cast<std::uint32_t>(std::max(1.0, std::ceil(least)));
  }
}

void respect_quota() {
  if (std::getenv("OMP_NUM_THREADS") != nullptr) return;
  const auto most = static_cast<std::uint32_t>(omp_get_max_threads());
  omp_set_num_threads(static_cast<int>(std::min(most, quota_threads())));
}

}  // namespace ar3d
