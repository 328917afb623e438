// CaDiCaL behind the interface: the only source that includes it.
#include <fmt/format.h>

#include <ctime>

#include "ar3d/base/error.h"
#include "ar3d/optimum/solver.h"

#ifdef AR3D_CADICAL
#include <cadical.hpp>
#endif

namespace ar3d::optimum {

const char* to_string(Answer answer) {
  if (answer == Answer::undecided) return "undecided";
  return answer == Answer::satisfiable ? "satisfiable" : "unsatisfiable";
}

#ifdef AR3D_CADICAL

namespace {

class Stopper final : public CaDiCaL::Terminator {
 public:
  explicit Stopper(const SolverTask& task) : task_(task) {}
  bool terminate() override {
    return cpu_s() > task_.cpu_s || (task_.should_stop && task_.should_stop());
  }
  double cpu_s() const { return thread_cpu_s() - begin_; }

 private:
  static double thread_cpu_s() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }

  const SolverTask& task_;
  double begin_ = thread_cpu_s();
};

SolverResult solve(const SolverTask& task) {
  CaDiCaL::Solver solver;
  solver.set("quiet", 1);
  solver.set("binary", 0);
  if (!task.proof.empty() && !solver.trace_proof(task.proof.c_str())) {
    throw InputError(fmt::format("{}: cannot be written", task.proof));
  }
  Stopper stopper(task);
  for (const int literal : task.formula.literals()) solver.add(literal);
  solver.connect_terminator(&stopper);
  const int code = solver.solve();
  if (!task.proof.empty()) solver.close_proof_trace();
  SolverResult result{.answer = Answer::undecided, .model = {}, .cpu_s = stopper.cpu_s()};
  if (code == 20) result.answer = Answer::unsatisfiable;
  if (code != 10) return result;
  result.answer = Answer::satisfiable;
  result.model.push_back(false);
  for (int v = 1; v <= task.formula.num_variables(); ++v) {
    result.model.push_back(solver.val(v) > 0);
  }
  return result;
}

}  // namespace

Solver cadical_solver() { return solve; }

#else

Solver cadical_solver() { return nullptr; }

#endif

}  // namespace ar3d::optimum
