#include "ar3d/bench/compare/bisection.h"

namespace ar3d {

std::optional<std::size_t> Bisection::next() const {
  std::optional<std::size_t> nearest;
  const auto distance = [&](std::size_t commit) {  // twice that from the middle
    const std::size_t sum = first_ + last_ - 1;
    return 2 * commit > sum ? 2 * commit - sum : sum - 2 * commit;
  };
  for (std::size_t commit = first_; commit < last_; ++commit) {
    if (is_skipped_[commit]) continue;
    if (!nearest || distance(commit) < distance(*nearest)) nearest = commit;
  }
  return nearest;
}

}  // namespace ar3d
