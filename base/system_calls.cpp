// System calls until they are done, and what the parents of processes share.
#include "ar3d/base/system_calls.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <fstream>
#include <limits>

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

void close_descriptors_but(std::vector<int> kept) {
  std::sort(kept.begin(), kept.end());
  unsigned from = 3;
  for (const int descriptor : kept) {
    const auto number = static_cast<unsigned>(descriptor);
    if (number > from) close_range(from, number - 1, 0);
    from = std::max(from, number + 1);
  }
  close_range(from, ~0U, 0);
}

void leave_no_core() {
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
}

int wait_for_end(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void end_group(pid_t child) {
  kill(-child, SIGKILL);
  kill(child, SIGKILL);  // should it not have got as far as its own group
  wait_for_end(child);
}

double address_space_bytes() {
  std::ifstream in("/proc/self/statm");
  double pages = 0;
  in >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double cpu_seconds_of(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace ar3d
