// Hands rows to worker processes and watches them. A row that crashes, takes too long or too much
// memory costs its process only; time in which the whole study was frozen does not count.
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>

#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/session.h"
#include "ar3d/bench/run/worker_process.h"

namespace ar3d {
namespace {

using Clock = std::chrono::steady_clock;
using News = WorkerProcess::News;

constexpr double kPatienceSeconds = 0.1;  // until stop is asked again

// Seconds in which this process was awake. It looks at the clock every kPatienceSeconds; a much
// longer step is one in which it was frozen, and the whole study with it (SIGSTOP, scontrol
// suspend).
class AwakeClock {
 public:
  double now_s() {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> step = now - last_;
    last_ = now;
    return awake_s_ += std::min(step.count(), kPatienceSeconds + 1);
  }

 private:
  Clock::time_point last_ = Clock::now();
  double awake_s_ = 0;
};

// A place for a worker: it has a row in hand, or there is nothing left for it.
class WorkerPlace {
 public:
  WorkerPlace(RowSource& source, const WorkerPool& pool, AwakeClock& clock, int number)
      : source_(source),
        pool_(pool),
        clock_(clock),
        number_(number),
        core_(pool.cores.empty() ? -1 : pool.cores.at(static_cast<std::size_t>(number))) {}

  bool busy() const { return job_.has_value(); }
  bool has_worker() const { return worker_ != nullptr; }
  int descriptor() const { return worker_->descriptor(); }
  // Seconds until the row can be late at the earliest; 0: it is late.
  double left_s() const {
    if (!limit_s_) return kPatienceSeconds;
    const double computing = worker_->cpu_s() - cpu_before_s_;
    const double waiting = clock_.now_s() - began_s_;
    return std::max(0.0, std::min(*limit_s_ - computing, idle_limit_s(*limit_s_) - waiting));
  }

  // Takes the next row and hands it to the worker, a new one if the last one is gone.
  void begin_next() {
    while ((job_ = source_.next(number_))) {
      begun_.reset();
      if (job_->instance == hopeless_) {
        fail(why_hopeless_);
        continue;
      }
      if (worker_ && worker_->send(*job_)) return begin_time();
      worker_.reset();
      worker_ = std::make_unique<WorkerProcess>(source_.session().plan(), pool_, core_);
      if (worker_->send(*job_)) return begin_time();
      give_up(worker_->end());
    }
  }

  // Reads what the worker has told; true if the row is done, one way or the other.
  bool look() {
    for (;;) {
      switch (worker_->read_news()) {
        case News::none:
          return false;
        case News::begun:
          begun_ = worker_->row();
          begin_time();
          break;
        case News::made:
          source_.done(*job_, worker_->row());
          return true;
        case News::garbage:
          give_up({RunStatus::crashed, "its process wrote into the socket that rows come through"});
          return true;
        case News::is_gone:
          give_up(worker_->end());
          return true;
      }
    }
  }

  void time_out() {
    give_up({RunStatus::timeout,
             fmt::format("no {} within {:.6g} s", begun_ ? "row" : "graph", *limit_s_)});
  }

 private:
  // A row has its limit in CPU time, which neither other jobs nor a pause of the study use up. One
  // that computes nothing, since it waits for ever, ends after this time awake.
  static double idle_limit_s(double limit_s) { return 10 * limit_s + 1; }

  void begin_time() {
    limit_s_.reset();
    const Budget& budget = source_.session().plan().budget;
    if (!budget.row_time_s) return;
    limit_s_ = (*budget.row_time_s)(job_->instance->n);
    cpu_before_s_ = worker_->cpu_s();
    began_s_ = clock_.now_s();
  }

  // The row ends here, and its worker with it. Where not even the graph came, the other rows of the
  // instance are not tried.
  void give_up(const WorkerEnd& end) {
    worker_.reset();
    if (!begun_) {
      hopeless_ = job_->instance;
      why_hopeless_ = end;
    }
    fail(end);
  }

  void fail(const WorkerEnd& end) {
    RunRecord run = begun_ ? *begun_ : planned_row(*job_->instance, *job_->run);
    run.status = end.status;
    run.message = end.message;
    source_.done(*job_, std::move(run));
  }

  RowSource& source_;
  const WorkerPool& pool_;
  AwakeClock& clock_;
  int number_;
  int core_;
  std::unique_ptr<WorkerProcess> worker_;
  std::optional<RowJob> job_;
  std::optional<RunRecord> begun_;  // what is known of the row in hand, once its graph is there
  std::optional<double> limit_s_;   // of the row or graph in hand
  double cpu_before_s_ = 0;
  double began_s_ = 0;
  std::shared_ptr<const PlannedInstance> hopeless_;
  WorkerEnd why_hopeless_;
};

// Waits until a worker has news, a row may be late or it is time to ask for a stop.
void wait_for_news(const std::vector<WorkerPlace>& places) {
  std::vector<pollfd> sockets;
  double left_s = kPatienceSeconds;
  for (const WorkerPlace& place : places) {
    if (!place.busy()) continue;
    sockets.push_back({place.descriptor(), POLLIN, 0});
    left_s = std::min(left_s, place.left_s());
  }
  poll(sockets.data(), sockets.size(), static_cast<int>(std::ceil(1000 * left_s)));
}

}  // namespace

void work_in_processes(RowSource& source, const WorkerPool& pool) {
  const auto stopped = [&] { return source.session().stopped(); };
  const Orphanage orphanage;
  AwakeClock clock;
  std::vector<WorkerPlace> places;
  places.reserve(static_cast<std::size_t>(pool.workers));
  for (int i = 0; i < pool.workers && !stopped(); ++i) {
    places.emplace_back(source, pool, clock, i).begin_next();
  }
  while (std::any_of(places.begin(), places.end(),
                     [](const WorkerPlace& place) { return place.busy(); })) {
    wait_for_news(places);
    if (stopped()) return;  // the places' destructors end what is in flight
    for (WorkerPlace& place : places) {
      if (!place.busy()) continue;
      bool done = place.look();
      if (!done && place.left_s() <= 0) {
        place.time_out();
        done = true;
      }
      if (done && !place.has_worker()) orphanage.end_orphans();
      if (done && !stopped()) place.begin_next();
    }
  }
}

}  // namespace ar3d
