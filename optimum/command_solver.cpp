// Any program that reads DIMACS and answers as solvers do in competitions.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>

#include <boost/scope_exit.hpp>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <thread>

#include "ar3d/base/error.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/optimum/solver.h"

namespace ar3d::optimum {
namespace {

[[noreturn]] void fail(const std::string& program, const std::string& what) {
  throw InputError(fmt::format("solver '{}' {}", program, what));
}

SolverResult read_answer(const std::string& program, const std::string& path, int variables,
                         int status) {
  SolverResult result;
  std::ifstream lines(path);
  std::vector<int> literals;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("s SATISFIABLE")) result.answer = Answer::satisfiable;
    if (line.starts_with("s UNSATISFIABLE")) result.answer = Answer::unsatisfiable;
    if (!line.starts_with("v")) continue;
    char* at = line.data() + 1;
    for (char* end = at;; at = end) {
      const long literal = std::strtol(at, &end, 10);
      if (end == at) break;
      if (literal > variables || -literal > variables)
        fail(program, "names a variable that is none");
      literals.push_back(static_cast<int>(literal));
    }
  }
  if (result.answer == Answer::undecided) {
    fail(program, fmt::format("ended without an answer (code {})",
                              WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status)));
  }
  if (result.answer != Answer::satisfiable) return result;
  result.model.assign(static_cast<std::size_t>(variables) + 1, false);
  for (const int literal : literals) {
    if (literal > 0) result.model[static_cast<std::size_t>(literal)] = true;
  }
  return result;
}

SolverResult solve(const SolverTask& task, std::vector<std::string> words) {
  const std::string folder = new_temporary_folder("ar3d-solver");
  BOOST_SCOPE_EXIT_ALL(&) { remove_folder(folder); };
  const std::string formula = folder + "/formula.cnf";
  const std::string answer = folder + "/answer";
  write_file_atomically(formula, task.formula.dimacs());
  const std::string program = words[0];
  words.push_back(formula);
  if (!task.proof.empty()) words.push_back(task.proof);
  const Descriptor out(open(answer.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600));
  if (out.get() < 0) refuse_writing(answer, errno);
  Child child = Child::of_program(words, {.streams = {-1, out.get(), -1}});
  if (child.run_error() != 0) {
    throw InputError(fmt::format("solver '{}': {}", program, std::strerror(child.run_error())));
  }
  double cpu_s = 0;
  while (!child.has_ended()) {
    const double so_far = child.cpu_s();  // not a number once it has ended
    if (so_far > cpu_s) cpu_s = so_far;
    if (cpu_s > task.cpu_s || (task.should_stop && task.should_stop())) {
      return {.answer = Answer::undecided, .model = {}, .cpu_s = cpu_s};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const int status = child.wait();
  SolverResult result = read_answer(program, answer, task.formula.num_variables(), status);
  result.cpu_s = cpu_s;
  return result;
}

}  // namespace

Solver command_solver(std::vector<std::string> words) {
  expect(!words.empty(), "a command has a word");
  return [words = std::move(words)](const SolverTask& task) { return solve(task, words); };
}

}  // namespace ar3d::optimum
