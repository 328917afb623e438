#pragma once

#include <sys/resource.h>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// While an object of this class lives, SIGINT, SIGTERM and, unless nohup has it ignored, SIGHUP
/// ask the program to stop instead of ending it. Another one ends it, or is ignored, too. One object
/// at a time; afterwards the signals do what they did before.
class Interruptible {
 public:
  explicit Interruptible(bool ignores_second = false);
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
  ~Interruptible();

 private:
  std::array<void (*)(int), 3> before_;  // for SIGINT, SIGTERM and SIGHUP
};

/// Returns true once the living Interruptible was asked to stop. Safe in every thread.
bool is_interrupted();

struct ChildOptions {
  std::string output = {};  ///< file that takes its standard output and error
  int core = -1;            ///< the only core it may use; -1: as this process
  /// Once is_interrupted(), the child is asked to end (SIGINT), and after ten seconds made to.
  bool ends_when_interrupted = false;
  std::function<void()> every_second = {};  ///< called about once a second while it runs
  std::optional<double> limit_s = {};       ///< wall time after which it is ended (SIGKILL)
};

/// Runs a program (looked up in PATH, no shell) to its end and gives its exit code, 128 + the
/// signal that ended it, or 127 if it cannot be run. @throws InputError if no process can be made
/// or the output cannot be written.
int run_child(const std::vector<std::string>& words, const ChildOptions& options);

/// Runs git with these words, without a shell. @throws InputError if no process can be made.
/// @return the lines that it printed, on both streams; none unless it ended with code 0.
std::vector<std::string> ask_git(std::vector<std::string> words);

/// Lets this process map at most so many bytes more than now. @return the limit before.
rlimit limit_address_space(double bytes);

/// Runs `step` in a forked process and copies what it wrote into `result`, which holds plain bytes,
/// back here. The process dies with this one. To be called while no other thread runs.
/// @param cpu_s  kept to the next whole second; who waits has ten times that, and 1 s.
/// @param memory_bytes  address space above the caller's; not where the build is sanitised, which
/// needs all of it.
/// @return how it ended, as a row would: ok, timeout, out_of_memory (also if std::bad_alloc left
/// the step), else crashed. `result` counts only if ok.
/// @throws InputError if the system has no process or pipe left.
RunStatus run_within(std::optional<double> cpu_s, double memory_bytes, std::span<char> result,
                     const std::function<void()>& step);

}  // namespace ar3d
