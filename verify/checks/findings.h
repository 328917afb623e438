#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "ar3d/verify/certificate.h"

namespace ar3d::verify {

/// Collects violations up to a limit. Checks stop early once done().
class Findings {
 public:
  explicit Findings(std::size_t limit) : limit_(limit) {}

  /// Keeps the violation, or remembers that the list was cut.
  void add(Violation violation) {
    if (list_.size() < limit_) {
      list_.push_back(std::move(violation));
    } else {
      cut_ = true;
    }
  }
  /// True once something was found that no longer fits: nothing further can change the verdict.
  bool done() const { return cut_; }
  /// How many more violations fit.
  std::size_t room() const { return limit_ - list_.size(); }
  bool empty() const { return list_.empty() && !cut_; }

  std::vector<Violation> take() { return std::move(list_); }

 private:
  std::size_t limit_;
  bool cut_ = false;
  std::vector<Violation> list_;
};

}  // namespace ar3d::verify
