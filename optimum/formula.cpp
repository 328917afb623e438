// Clauses one behind the other, as solvers read them.
#include "ar3d/optimum/formula.h"

#include <fmt/format.h>

#include <iterator>
#include <stdexcept>

namespace ar3d::optimum {

void Formula::add(std::span<const int> clause) {
  if (literals_.size() + clause.size() >= kMostLiterals) {
    throw std::length_error(fmt::format("its formula has more than {} literals", kMostLiterals));
  }
  literals_.insert(literals_.end(), clause.begin(), clause.end());
  literals_.push_back(0);
  ++clauses_;
}

std::string Formula::dimacs() const {
  std::string text;
  fmt::format_to(std::back_inserter(text), "p cnf {} {}\n", variables_, clauses_);
  for (const int literal : literals_) {
    text += fmt::format_int(literal).c_str();
    text += literal == 0 ? '\n' : ' ';
  }
  return text;
}

}  // namespace ar3d::optimum
