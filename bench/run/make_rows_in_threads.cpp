#include <atomic>
#include <system_error>

#include "ar3d/base/parallel.h"
#include "ar3d/bench/measure/one_thread.h"
#include "ar3d/bench/measure/pinning.h"
#include "ar3d/bench/run/row_source.h"

namespace ar3d {
namespace {

void work(RowSource& source, const WorkerPool& pool, int worker, const std::atomic<bool>& failed) {
  const OneThread one_thread;
  const int core = pool.cores.empty() ? -1 : pool.cores.at(static_cast<std::size_t>(worker));
  const Pinning pinning(core);
  RowMaker maker({.concurrency = pool.workers + pool.elsewhere,
                  .core = core,
                  .memory = pool.workers == 1 ? MemoryScope::row : MemoryScope::process,
                  .certify_memory_bytes = source.making().plan().budget.certify_memory_bytes});
  std::shared_ptr<const PlannedInstance> prepared;
  while (!failed && !source.making().stopped()) {
    const std::optional<RowJob> job = source.next(worker);
    if (!job) return;
    if (job->instance != prepared) maker.prepare(*job->instance);
    prepared = job->instance;
    source.done(*job, maker.make(*job->run, job->request));
  }
}

}  // namespace

void make_rows_in_threads(RowSource& source, const WorkerPool& pool) {
  std::atomic<bool> failed = false;
  const auto until_one_fails = [&](std::uint32_t worker) {
    try {
      work(source, pool, static_cast<int>(worker), failed);
    } catch (...) {
      failed = true;
      throw;
    }
  };
  in_threads(static_cast<std::uint32_t>(pool.workers), until_one_fails,
             [&](std::uint32_t, const std::system_error& error) {
               failed = true;
               throw cannot_start_threads(pool.workers, error);
             });
}

}  // namespace ar3d
