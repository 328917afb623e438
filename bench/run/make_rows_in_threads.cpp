#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

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

// Not a parallel region of OpenMP: inside one, the regions of the generators would each make a
// team.
void make_rows_in_threads(RowSource& source, const WorkerPool& pool) {
  std::mutex mutex;
  std::exception_ptr failure;
  std::atomic<bool> failed = false;
  const auto work_guarded = [&](int worker) {
    try {
      work(source, pool, worker, failed);
    } catch (...) {  // nothing may leave a thread
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
      failed = true;
    }
  };
  std::vector<std::thread> others;
  try {
    for (int worker = 1; worker < pool.workers; ++worker) others.emplace_back(work_guarded, worker);
  } catch (const std::system_error& error) {
    failed = true;
    for (std::thread& thread : others) thread.join();
    throw cannot_start_threads(pool.workers, error);
  }
  work_guarded(0);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace ar3d
