#pragma once

#include <map>
#include <string>
#include <vector>

#include "ar3d/store/run_storage.h"

namespace ar3d {

/// Describes one thing about the machine, the build or its load that two results do not share.
struct EnvironmentChange {
  std::string name;  ///< "cpu", "flags", …
  std::string base;  ///< its value there, "absent" if none
  std::string now;
  /// Returns false for a machine that was equally busy with other work on both sides.
  bool differs() const { return base != now; }
};

/// Holds the name of the change that says that the machine was busy.
inline constexpr const char* kLoadOfOtherWork = "load of other work";

/// Returns all lasting settings of a machine and a build, by name (processor, cores, kernel,
/// compiler, flags, libraries, threads, variables); values of several sessions, "a | b". Results
/// with equal settings are of one environment.
std::map<std::string, std::string> lasting_settings(
    const std::vector<EnvironmentEntry>& environment);

/// Returns the one-minute load at a session's beginning that is more than half of the cores, or at
/// its end, if it is as much more than the rows that it made at a time; empty if none is.
std::string load_of_other_work(const std::vector<EnvironmentEntry>& environment,
                               double rows_at_a_time);

/// Returns what makes times of the two incomparable: every recorded setting that differs
/// (processor, cores, kernel, compiler, flags, libraries, threads, variables), and a machine busy
/// with other work when either began (one-minute load above half of its cores). Values of several
/// sessions count together. Empty: alike.
std::vector<EnvironmentChange> environment_changes(const Results& base, const Results& now);

}  // namespace ar3d
