#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ar3d {

struct ChildOptions {
  std::string folder = {};  ///< working directory; empty: this process's
  std::string output = {};  ///< file that takes its standard output and error
  int core = -1;            ///< the only core it may use; -1: as this process
  /// Once is_interrupted(), the child is asked to end (SIGINT), and after ten seconds made to.
  /// False: an interrupt from the keyboard ends the child and not this process.
  bool ends_when_interrupted = false;
  std::function<void()> every_second = {};  ///< called about once a second while it runs
};

/// Runs a program (looked up in PATH, no shell) to its end and gives its exit code, 128 + the
/// signal that ended it, or 127 if it cannot be run. @throws InputError if no process can be made.
int run_child(const std::vector<std::string>& words, const ChildOptions& options);

}  // namespace ar3d
