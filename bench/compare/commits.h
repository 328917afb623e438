#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace ar3d {

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

/// The search for the first bad one of commits 0 … count - 1, oldest first, of which the last is
/// bad and what is before the first is good. Tries ceil(log2(count)) commits, if all can be tried.
class Bisection {
 public:
  /// @pre count >= 1
  explicit Bisection(std::size_t count) : is_skipped_(count, false), last_(count - 1) {}

  /// The commit nearest to the middle of those in question that was not skipped; none: finished.
  std::optional<std::size_t> next() const;
  void note_good(std::size_t commit) { first_ = commit + 1; }
  void note_bad(std::size_t commit) { last_ = commit; }
  /// It cannot be tried.
  void skip(std::size_t commit) { is_skipped_[commit] = true; }

  /// The first bad commit is one of first … last.
  std::size_t first() const { return first_; }
  std::size_t last() const { return last_; }

 private:
  std::vector<bool> is_skipped_;
  std::size_t first_ = 0;
  std::size_t last_;
};

/// The folder of the git checkout of ar3d that holds the working directory.
/// @throws InputError if there is none.
std::string find_checkout();

/// The program of another commit, Release, as CHECKOUT/build/compare/COMMIT/ar3d. What is there is
/// taken as it is; else it is built in a git worktree beside it, which is removed afterwards,
/// however the build ends.
/// @param ref  whatever git takes for a commit: a tag, a branch, HEAD~3.
/// @param progress  where to tell how far it is; null: nowhere.
/// @return nothing if it was interrupted (is_interrupted).
/// @throws InputError naming the ref if there is no such commit, or the log if it does not build.
std::optional<std::string> build_reference(const std::string& checkout, const std::string& ref,
                                           std::FILE* progress);

}  // namespace ar3d
