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

void work(RowSource& source, const Crew& crew, int slot, const std::atomic<bool>& failed) {
  const OneThread one_thread;
  const int core = crew.cores.empty() ? -1 : crew.cores.at(static_cast<std::size_t>(slot));
  const Pinning pinning(core);
  RowMaker maker({.concurrency = crew.size + crew.neighbours,
                  .core = core,
                  .memory = crew.size == 1 ? MemoryScope::row : MemoryScope::process});
  std::shared_ptr<const PlannedInstance> prepared;
  while (!failed && !(crew.stop && crew.stop())) {
    const std::optional<RowJob> job = source.next(slot);
    if (!job) return;
    if (job->instance != prepared) maker.prepare(*job->instance);
    prepared = job->instance;
    source.done(*job, maker.make(*job->run, job->request));
  }
}

}  // namespace

// Not a parallel region of OpenMP: inside one, the regions of the generators would each make a
// team.
void make_rows_in_threads(RowSource& source, const Crew& crew) {
  std::mutex mutex;
  std::exception_ptr failure;
  std::atomic<bool> failed = false;
  const auto work_guarded = [&](int slot) {
    try {
      work(source, crew, slot, failed);
    } catch (...) {  // nothing may leave a thread
      const std::lock_guard<std::mutex> lock(mutex);
      if (!failure) failure = std::current_exception();
      failed = true;
    }
  };
  std::vector<std::thread> others;
  try {
    for (int slot = 1; slot < crew.size; ++slot) others.emplace_back(work_guarded, slot);
  } catch (const std::system_error& error) {
    failed = true;
    for (std::thread& thread : others) thread.join();
    throw cannot_start_threads(crew.size, error);
  }
  work_guarded(0);
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace ar3d
