#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace ar3d {

/// Reports bad input or bad usage. The message is one line that names the value and, for files,
/// file and line. Programs print it and exit with code 2.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Represents an edge that no simple graph on the given vertices has. Readers of files turn its
/// number into a line.
class EdgeError : public InputError {
 public:
  EdgeError(std::uint64_t edge, std::uint64_t u, std::uint64_t v, const std::string& message)
      : InputError(message), edge_(edge), u_(u), v_(v) {}
  std::uint64_t edge() const { return edge_; }  ///< number of the edge in input order
  std::uint64_t u() const { return u_; }        ///< its ends
  std::uint64_t v() const { return v_; }

 private:
  std::uint64_t edge_;
  std::uint64_t u_;
  std::uint64_t v_;
};

/// Represents a broken internal invariant: a bug in ar3d. Programs exit with code 1.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Is true in builds with AR3D_CHECKS (the `check` preset): invariants that cost more than their
/// stage are tested.
#ifdef AR3D_CHECKS
inline constexpr bool kHeavyChecks = true;
#else
inline constexpr bool kHeavyChecks = false;
#endif

/// Throws InternalError naming the place when an internal invariant does not hold.
/// (The built-ins stand for std::source_location, which clang 14 lacks.)
inline void expect(bool holds, const char* invariant, const char* file = __builtin_FILE(),
                   int line = __builtin_LINE()) {
  if (!holds) {
    throw InternalError(std::string("internal error: ") + invariant + " (" + file + ":" +
                        std::to_string(line) + ")");
  }
}

/// Works as expect, for conditions whose evaluation is expensive: `check` is a callable that is
/// called only in builds with AR3D_CHECKS.
template <class Check>
void expect_heavy([[maybe_unused]] Check&& check, [[maybe_unused]] const char* invariant,
                  [[maybe_unused]] const char* file = __builtin_FILE(),
                  [[maybe_unused]] int line = __builtin_LINE()) {
  if constexpr (kHeavyChecks) expect(check(), invariant, file, line);
}

}  // namespace ar3d
