#pragma once

#include <cstdio>
#include <string>

namespace ar3d {

/// The folder of the git checkout of ar3d that holds the working directory.
/// @throws InputError if there is none.
std::string find_checkout();

/// Builds the program of another commit, Release, in a git worktree of its own below
/// CHECKOUT/build/compare/, and gives its path. What is built already is taken as it is.
/// @param ref  whatever git takes for a commit: a tag, a branch, HEAD~3.
/// @param progress  where to tell what takes long; null: nowhere.
/// @throws InputError naming the ref if there is no such commit, or the log if it does not build.
std::string build_reference(const std::string& checkout, const std::string& ref,
                            std::FILE* progress);

}  // namespace ar3d
