#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace ar3d::optimum {

/// A formula in conjunctive normal form. A literal is a variable's number from 1 on, or its
/// negative.
class Formula {
 public:
  int new_variable() { return ++variables_; }
  void add(std::initializer_list<int> clause) { add(std::span(clause.begin(), clause.size())); }
  /// @throws std::length_error beyond kMostLiterals.
  void add(std::span<const int> clause);

  int num_variables() const { return variables_; }
  std::uint64_t num_clauses() const { return clauses_; }
  /// All clauses, each with a 0 behind it.
  const std::vector<int>& literals() const { return literals_; }
  /// The text of the formula in DIMACS format.
  std::string dimacs() const;

 private:
  static constexpr std::size_t kMostLiterals = 50'000'000;  // 200 MB; a solver takes 1 GB
  int variables_ = 0;
  std::uint64_t clauses_ = 0;
  std::vector<int> literals_;
};

/// The value of each variable, from 1 on; entry 0 is not used.
using Model = std::vector<bool>;

}  // namespace ar3d::optimum
