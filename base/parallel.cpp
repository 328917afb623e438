// Loops on OpenMP's threads, and what OpenMP leaves to its user: exceptions, threads that the system
// does not give (the runtimes end the process), and children of fork(), which have no pool.
#include "ar3d/base/parallel.h"

#include <fmt/format.h>
#include <omp.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

std::atomic<bool> has_pool = false, has_lost_its_pool = false;

// Threads that wait sleep. libgomp reads the variable before main(), and this is earlier where it is
// linked into the program (tools/cmake/dependencies.cmake).
[[gnu::constructor(101)]] void prepare() {
  setenv("OMP_WAIT_POLICY", "passive", 0);
  setenv("GOMP_SPINCOUNT", "20000", 0);  // not at once: waking takes as long as a small search
  pthread_atfork(nullptr, nullptr, [] { has_lost_its_pool = has_pool.load(); });
}

struct FirstException {
  std::atomic<bool> is_thrown = false;
  std::exception_ptr first;

  template <class Work>
  void catching(const Work& work) {
    try {
      work();
    } catch (...) {  // nothing may leave a region
      if (!is_thrown.exchange(true)) first = std::current_exception();
    }
  }
  void rethrow() const {
    if (first) std::rethrow_exception(first);
  }
};

std::uint32_t most_threads() {
  if (has_lost_its_pool || omp_get_active_level() >= omp_get_max_active_levels()) return 1;
  return static_cast<std::uint32_t>(omp_get_thread_limit());
}

// How many of `count` threads the system starts, all living at the same time; none is left.
std::uint32_t started(std::uint32_t count) {
  std::vector<pid_t> ids(count);
  {
    std::mutex all_started;
    std::vector<std::jthread> tried;
    const std::lock_guard hold(all_started);
    try {
      for (pid_t& id : ids) {
        tried.emplace_back([&] {
          id = gettid();
          void* const volatile own = std::malloc(1);  // so that its arena is there, too
          std::free(own);
          const std::lock_guard wait(all_started);
        });
      }
    } catch (const std::system_error&) {
      count = static_cast<std::uint32_t>(tried.size());
    }
  }
  for (const pid_t id : ids) {
    while (id != 0 && tgkill(getpid(), id, 0) == 0) sched_yield();  // it still counts (ulimit -u)
  }
  return count;
}

// Threads of a region that begins now: `count`, or fewer if the system refuses some, half of what it
// gives, since they need room for their work. A runtime would end the process instead, so those that
// the calling thread's pool lacks are tried before. @throws InputError if `all` are needed.
std::uint32_t team_of(std::uint32_t count, bool all) {
  thread_local std::uint32_t in_pool = 1;
  std::uint32_t team = std::min(count, most_threads());
  if (team > 1 && omp_get_level() > 0) in_pool = 1;  // threads of inner regions end with them
  while (team > in_pool) {
    const std::uint32_t missing = team - in_pool, given = started(missing);
    if (given == missing) break;
    team = in_pool + given / 2;
  }
  if (all && team < count) {
    throw InputError(fmt::format("cannot start {} threads: the system allows fewer", count));
  }
  if (team < 2) return 1;
  omp_set_dynamic(0);
  has_pool = true;
  return in_pool = team;
}

}  // namespace

std::uint32_t available_threads() {
  return std::min(most_threads(), static_cast<std::uint32_t>(omp_get_max_threads()));
}

void in_threads(std::uint32_t count, const std::function<void(std::uint32_t)>& work) {
  const std::uint32_t team = team_of(count, true);
  if (team == 1) return work(0);
  FirstException failure;
#pragma omp parallel num_threads(team)
  failure.catching([&] { work(static_cast<std::uint32_t>(omp_get_thread_num())); });
  failure.rethrow();
}

void for_each_in_threads(std::uint32_t threads, std::size_t size,
                         const std::function<void(std::uint32_t, std::size_t)>& work,
                         std::size_t chunk) {
  const std::size_t chunks = (size + chunk - 1) / chunk;
  const std::uint32_t team =
      team_of(static_cast<std::uint32_t>(std::min<std::size_t>(threads, chunks)), false);
  if (team == 1) {  // exceptions need not wait
    for (std::size_t i = 0; i < size; ++i) work(0, i);
    return;
  }
  FirstException failure;
#pragma omp parallel for num_threads(team) schedule(dynamic, chunk)
  for (std::size_t i = 0; i < size; ++i) {
    if (failure.is_thrown) continue;
    failure.catching([&] { work(static_cast<std::uint32_t>(omp_get_thread_num()), i); });
  }
  failure.rethrow();
}

}  // namespace ar3d
