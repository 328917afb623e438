#pragma once

#include <string>
#include <vector>

#include "ar3d/records/run_storage.h"

namespace ar3d {

/// One thing about the machine, the build or its load that two results do not share.
struct EnvironmentChange {
  std::string name;  ///< "cpu", "flags", …
  std::string base;  ///< its value there, "absent" if none
  std::string now;
};

/// The name of the change that says that the machine was busy.
inline constexpr const char* kLoadOfOtherWork = "load of other work";

/// What makes times of the two incomparable: every recorded setting that differs (processor, cores,
/// kernel, compiler, flags, libraries, threads, variables), and a machine busy with other work when
/// either began (one-minute load above half of its cores). Values of several sessions count
/// together. Empty: alike.
std::vector<EnvironmentChange> environment_changes(const Results& base, const Results& now);

}  // namespace ar3d
