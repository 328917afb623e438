#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

namespace ar3d {

/// Returns how many commits there are up to this one, itself included: the place of a commit in a
/// history, larger than that of each of its ancestors. @param commit  40 digits.
/// @return -1 if git in the working directory does not know the commit.
std::int64_t commits_up_to(const std::string& commit);

/// Returns the last line of a log that is not empty.
std::string last_line(const std::filesystem::path& log);

/// Returns the folder of the git checkout of ar3d that holds the working directory; empty: none.
std::string checkout_here();
/// Returns the same. @throws InputError if there is none.
std::string find_checkout();

/// Puts another commit of the repository that holds the working directory into a folder, as a clone
/// of its own, and builds it there.
/// @param ref  as build_reference. @param command  for `sh -c`, run in the folder of the clone that
/// is like the working directory.
/// @return that folder; nothing if it was interrupted.
/// @throws InputError naming the ref if there is no such commit; with the last line that was printed
/// if it does not build.
std::optional<std::string> build_own(const std::string& ref, const std::string& command,
                                     const std::string& folder);

/// Returns the program of another commit, Release, as CHECKOUT/build/compare/COMMIT/ar3d. What is
/// there is taken as it is; else it is built in a git worktree beside it, which is removed
/// afterwards, however the build ends.
/// @param ref  whatever git takes for a commit: a tag, a branch, HEAD~3.
/// @param progress  where to tell how far it is; null: nowhere.
/// @return nothing if it was interrupted (is_interrupted).
/// @throws InputError naming the ref if there is no such commit, or the log if it does not build.
std::optional<std::string> build_reference(const std::string& checkout, const std::string& ref,
                                           std::FILE* progress);

}  // namespace ar3d
