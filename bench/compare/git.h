#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ar3d {

/// What git printed, on both streams, and how it ended.
struct GitAnswer {
  int exit_code = 0;
  std::vector<std::string> lines;
};

/// Runs git with these words, without a shell. @throws InputError if no process can be made.
GitAnswer ask_git(std::vector<std::string> words);

/// The 40 digits of a commit. @param ref  whatever git takes for one: a tag, a branch, HEAD~3.
/// @throws InputError naming the ref if there is no such commit.
std::string commit_of(const std::string& checkout, const std::string& ref);

/// How many commits there are up to this one, itself included: the place of a commit in a history,
/// larger than that of each of its ancestors. @param commit  40 digits.
/// @return -1 if git in the working directory does not know the commit.
std::int64_t commits_up_to(const std::string& commit);

struct Commit {
  std::string hash;     ///< 40 digits
  std::string subject;  ///< the first line of its message
};

/// The commits behind `good` up to `bad` along first parents, oldest first; `bad` is the last.
/// @param good, bad  40 digits. @throws InputError if good is no ancestor of bad, or they are one.
std::vector<Commit> commits_between(const std::string& checkout, const std::string& good,
                                    const std::string& bad);

}  // namespace ar3d
