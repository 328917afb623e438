#pragma once

#include <string>
#include <vector>

#include "ar3d/store/columns/study_identity.h"

namespace ar3d {

/// Returns the value of the first "key : value" line of a file of /proc; "absent" if there is none.
std::string proc_value(const std::string& path, const std::string& key);

/// Returns the git commit of the program's sources, "unknown" outside of a git checkout.
std::string source_hash();
/// Returns true if tracked files differed from that commit when the program was built.
bool source_is_dirty();

/// Returns the SHA-256 of what differed; empty if nothing did.
std::string dirty_hash();

/// Returns why times of this build are worth little: "debug" (no -DNDEBUG), "sanitised", or "" for
/// a good build.
const char* build_kind();

/// Returns "ar3d 1.0.0 (commit 0123456789ab, GNU 12.2.0, Release)"; it also says "modified" if the
/// sources differed from the commit, and the build_kind().
std::string build_summary();

/// Returns machine, operating system, compiler, libraries, settings that influence speed; "absent"
/// for what the system does not tell.
std::vector<EnvironmentEntry> capture_environment(int threads);

/// Returns the first three fields of /proc/loadavg.
std::string load_average();

}  // namespace ar3d
