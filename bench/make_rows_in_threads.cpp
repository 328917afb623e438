#include <omp.h>

#include <atomic>
#include <exception>
#include <mutex>

#include "ar3d/bench/pinning.h"
#include "ar3d/bench/row_source.h"

namespace ar3d {
namespace {

void work(RowSource& source, const Crew& crew, int slot, const std::atomic<bool>& failed) {
  const int core = crew.cores.empty() ? -1 : crew.cores.at(static_cast<std::size_t>(slot));
  const Pinning pinning(core);
  RowMaker maker({.concurrency = crew.size + crew.neighbours,
                  .core = core,
                  .memory = crew.size == 1 ? MemoryScope::row : MemoryScope::process});
  const PlannedInstance* prepared = nullptr;
  while (!failed && !(crew.stop && crew.stop())) {
    const std::optional<RowJob> job = source.next(slot);
    if (!job) return;
    if (job->instance != prepared) maker.prepare(*job->instance);
    prepared = job->instance;
    source.done(*job, maker.make(*job->run, job->request));
  }
}

}  // namespace

void make_rows_in_threads(RowSource& source, const Crew& crew) {
  std::mutex mutex;
  std::exception_ptr failure;
  std::atomic<bool> failed = false;
#pragma omp parallel num_threads(crew.size)
  {
    try {
      work(source, crew, omp_get_thread_num(), failed);
    } catch (...) {  // nothing may leave an OpenMP region
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
      failed = true;
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace ar3d
