// The phases of a study in order, each with its threads or worker processes, and the steps that
// several ranks do together: what one of them fails at, all have failed at.
#include <fmt/format.h>
#include <malloc.h>

#include <atomic>
#include <string_view>

#include "ar3d/base/error.h"
#include "ar3d/base/parallel.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/environment.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/execute.h"
#include "ar3d/store/journal/journal_writer.h"

namespace ar3d {
namespace {

bool is_timed(RunPhase phase) { return phase != RunPhase::metrics; }
bool is_timing(RunPhase phase) { return phase == RunPhase::timing; }

void require_ranks(const StudyPlan& plan, int ranks) {
  for (const PlannedBlock& block : plan.instances.blocks()) {
    for (const PlannedRun& run : block.first.runs) {
      if (!is_over_ranks(run.phase) || run.workers <= ranks) continue;
      throw InputError(fmt::format("batches are to be shared by {} ranks of mpirun but there {} {}",
                                   run.workers, ranks == 1 ? "is" : "are", ranks));
    }
  }
}

}  // namespace

void execute(const RowSource& source) {
  const StudySession& session = source.session;
  if (session.policy().isolate || session.plan().budget.limits_rows()) {
    return work_in_processes(source);
  }
  // The main thread's memory would go back to the system between rows, whose pages then come anew.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
  mallopt(M_TRIM_THRESHOLD, 64 << 20);
  const MemoryScope scope = source.workers == 1 ? MemoryScope::row : MemoryScope::process;
  std::atomic<bool> failed = false;
  in_threads(static_cast<std::uint32_t>(source.workers), [&](std::uint32_t number) {
    try {
      const auto worker = static_cast<int>(number);
      const OneThread one_thread;
      const Pinning pinning(source.core_of(worker));
      RowMaker maker = source.maker(worker, scope);
      while (!failed && !session.stopped()) {
        const std::optional<RowJob> job = source.next(worker);
        if (!job) return;
        maker.prepare(session.plan(), job->request.index);
        source.done(*job, maker.make_row(job->run(), job->request));
      }
    } catch (...) {
      failed = true;
      throw;
    }
  });
}

void together(Ranks& ranks, const std::function<void()>& step) {
  if (ranks.size() == 1) {
    step();
    return ranks.barrier();
  }
  StepResult result = StepResult::done;
  std::string why;
  try {
    step();
  } catch (const JournalFull& error) {
    result = StepResult::journal_full;
    why = error.what();
  } catch (const InputError& error) {
    result = StepResult::failed;
    why = error.what();
  }
  result = ranks.agree(result, why);
  if (result == StepResult::done) return;
  ranks.have_failed = true;
  if (result == StepResult::journal_full) throw JournalFull(why);
  throw InputError(why);
}

void require_possible(const StudyPlan& plan, const SessionPolicy& policy) {
  const std::string_view mark = build_kind();
  if (mark == "sanitised" && plan.budget.row_memory_bytes) {
    throw InputError("budget.row_memory_bytes cannot be kept in a sanitised build");
  }
  if (!policy.timed_phases) return;
  if (!mark.empty() && !policy.force_timing && has_run(plan, is_timed)) {
    throw InputError(fmt::format("a {} build is not timed unless it is forced to", mark));
  }
  if (has_run(plan, is_timing) && plan.timing.concurrency > allowed_cores().size()) {
    throw InputError(fmt::format("timing.concurrency = {} but there are {} cores",
                                 plan.timing.concurrency, allowed_cores().size()));
  }
  require_ranks(plan, policy.ranks != nullptr ? policy.ranks->size() : 1);
}

void run_session(const StudyPlan& plan, const SessionPolicy& policy, const RowSink& sink) {
  require_possible(plan, policy);
  StudySession session(plan, policy, sink);
  if (policy.metrics_phase) make_metrics(session);
  if (policy.timed_phases && !session.stopped() && has_run(plan, is_timing)) make_timing(session);
  if (policy.timed_phases && !session.stopped()) make_batches(session);
  session.end();
}

}  // namespace ar3d
