#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ar3d {

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

}  // namespace ar3d
