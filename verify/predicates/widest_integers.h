#pragma once

namespace ar3d::verify {

/// While one lives, predicates are decided in the widest integers that they have, as if the range
/// check proved nothing: for benchmarks that say what it saves, and tests that compare verdicts.
/// Counts for all threads.
class WidestIntegers {
 public:
  WidestIntegers();
  ~WidestIntegers();
  WidestIntegers(const WidestIntegers&) = delete;
  WidestIntegers& operator=(const WidestIntegers&) = delete;

  /// Does one live?
  static bool wanted();
};

}  // namespace ar3d::verify
