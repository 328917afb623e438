#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "ar3d/optimum/formula.h"

namespace ar3d::optimum {

enum class Answer : std::uint8_t { satisfiable, unsatisfiable, undecided };
/// "satisfiable", "unsatisfiable", "undecided".
const char* to_string(Answer answer);

struct SolverTask {
  const Formula& formula;
  std::string proof = {};               ///< file for the proof that there is no model; empty: none
  std::function<bool()> should_stop{};  ///< asked now and then
  double cpu_s = std::numeric_limits<double>::infinity();  ///< most CPU time
};

struct SolverResult {
  Answer answer = Answer::undecided;
  Model model = {};  ///< if satisfiable
  double cpu_s = 0;  ///< CPU time taken
};

/// Decides a formula. @throws InputError if the proof cannot be written or the program does not
/// answer.
using Solver = std::function<SolverResult(const SolverTask& task)>;

/// Returns CaDiCaL (Biere and others, https://github.com/arminbiere/cadical), which writes proofs
/// as DRAT text. Empty if it was not there when this was built.
Solver cadical_solver();

/// Returns a program that is called with a DIMACS file and, for a proof, the file for it. It prints
/// `s SATISFIABLE` and its model behind `v`, or `s UNSATISFIABLE`, as in SAT competitions.
/// @param words  the program, looked up in PATH, and its first arguments; not empty.
Solver command_solver(std::vector<std::string> words);

}  // namespace ar3d::optimum
