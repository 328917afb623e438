#pragma once

#include <signal.h>
#include <sys/types.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/base/new_file.h"

namespace ar3d {

/// Reads or writes all bytes of a blocking descriptor, after signals, too.
/// @return how many. Where they are fewer than asked for, errno is the
/// reason; 0 if the file or the other side has ended. Nothing written is
/// EIO.
std::size_t write_whole(int descriptor, std::span<const char> bytes);
std::size_t write_whole(int descriptor, std::span<const char> bytes, std::uint64_t offset);
std::size_t read_whole(int descriptor, std::span<char> bytes, std::uint64_t offset);

/// Does the same through a socket. @return false if the other side is gone.
bool send_all(int socket, std::span<const char> bytes);
bool receive_all(int socket, std::span<char> bytes);
/// Does so in the time that is left. A long step counts two seconds: in it this process was stopped,
/// and the other side with it. @return false, too, once none is left or `stop` says so.
bool receive_within(int socket, std::span<char> bytes, double& left_s,
                    const std::function<bool()>& stop = {});

/// Returns false if the file or folder was removed, or another one has its name, since it was opened.
bool has_its_name(int descriptor, const std::string& path);

/// Returns the bytes of a plain value, to be sent or received.
template <class Value>
std::span<char> bytes_in(Value& value) {
  return {reinterpret_cast<char*>(&value), sizeof(value)};
}

/// Returns what this process has mapped.
double address_space_bytes();

/// Holds what a child process has from this one.
struct ChildSetup {
  std::array<int, 3> streams = {-1, -1, -1};  ///< its standard ones; -1: those of this process
  /// Holds other descriptors that stay open in a forked process; nothing: all. A program has none.
  std::optional<std::vector<int>> kept = {};
  int core = -1;                ///< the only core it may use; -1: as this process
  int death_signal = SIGKILL;   ///< it comes when the thread that started the child ends
  bool starts_programs = true;  ///< false: a forked one starts none that could be left behind
};

/// Represents a child process in a process group of its own, without a core file. It ends with this
/// object, and so does all that it has started, in whatever group: what it leaves behind comes to
/// this process, where a variable in the environment of programs tells it from what others have
/// started. To be used by one thread. Every program and process of this one is started here.
class Child {
 public:
  Child() = default;
  Child(Child&& other) noexcept { *this = std::move(other); }
  Child& operator=(Child&& other) noexcept;
  ~Child() { kill(); }

  /// Forks a process that calls body(its end of a socket) with one thread and ends with its result,
  /// 1 if it throws. @throws InputError if the system has no process or descriptor left.
  static Child forked(ChildSetup setup, const std::function<int(int socket)>& body);
  /// Runs a program (looked up in PATH, no shell). Other threads may run meanwhile. @throws
  /// InputError if the system has no process or descriptor left.
  static Child of_program(std::vector<std::string> words, const ChildSetup& setup);

  /// Returns why the program cannot be run (errno), else 0. It then ends with code 127.
  int run_error() const { return run_error_; }
  /// Returns this process's end of a forked one's socket.
  int socket() const { return socket_.get(); }
  bool has_ended();
  /// Waits until it has ended, and ends what it has left in its group. @return its status as
  /// waitpid() gives it, also if it was seen before; 0 if there was none.
  int wait();
  /// Sends a signal to its group.
  void send(int signal) const;
  /// Ends it and its group at once; nothing if it has ended.
  void kill();
  /// Returns CPU time so far, in seconds; NaN once it has ended.
  double cpu_s() const;

 private:
  void take_orphans(std::string mark);
  int finish();

  pid_t pid_ = -1;
  int status_ = 0;
  int run_error_ = 0;
  Descriptor socket_;
  std::string mark_;  // the variable's name; empty: nothing is left behind
};

/// Makes a pipe. @return the end to read from and the end to write to. @throws InputError if there
/// is no descriptor left.
std::pair<Descriptor, Descriptor> new_pipe();

/// Returns how many threads a quota of CPU time keeps busy (cpu.max of a container's control group, or
/// of one around it), rounded up; 2^32 - 1 if there is none.
std::uint32_t quota_threads(const std::string& group = "/proc/self/cgroup",
                            const std::string& root = "/sys/fs/cgroup");
/// Makes quota_threads() the most of OpenMP's threads, unless OMP_NUM_THREADS says how many.
void respect_quota();

}  // namespace ar3d
