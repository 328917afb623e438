#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ar3d {

/// A sum of powers of n with a unit, as budgets are written: "2 s + 20 us * n", "64 MiB + 2 kB *
/// n^1.5".
class SizeFunction {
 public:
  /// Terms "NUMBER UNIT", "NUMBER UNIT * n" or "NUMBER UNIT * n^NUMBER", joined by "+".
  /// Units of time (result in seconds): ns, us, ms, s, min, h.
  /// @throws InputError naming the text and what is wrong with it.
  static SizeFunction time(const std::string& text);
  /// Units of memory (result in bytes): B, kB, MB, GB, KiB, MiB, GiB.  @throws InputError
  static SizeFunction memory(const std::string& text);

  double operator()(std::uint64_t n) const;
  /// True if no term depends on n.
  bool is_constant() const;

 private:
  struct Term {
    double coefficient = 0;
    double exponent = 0;
  };
  std::vector<Term> terms_;
  friend class SizeFunctionReader;
};

}  // namespace ar3d
