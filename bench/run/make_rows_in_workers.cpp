#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "ar3d/bench/run/row_source.h"
#include "ar3d/bench/run/worker_process.h"

namespace ar3d {
namespace {

using Clock = std::chrono::steady_clock;
using News = WorkerProcess::News;

constexpr auto kPatience = std::chrono::milliseconds(100);  // until stop is asked again

// A place for a worker: it has a row in hand, or there is nothing left for it.
class Slot {
 public:
  Slot(RowSource& source, const Crew& crew, int number)
      : source_(source),
        crew_(crew),
        number_(number),
        core_(crew.cores.empty() ? -1 : crew.cores.at(static_cast<std::size_t>(number))) {}

  bool busy() const { return job_.has_value(); }
  int descriptor() const { return worker_->descriptor(); }
  Clock::time_point deadline() const { return deadline_; }

  // Takes the next row and hands it to the worker, a new one if the last one is gone.
  void begin_next() {
    while ((job_ = source_.next(number_))) {
      begun_.reset();
      if (job_->instance == hopeless_) {
        fail(why_hopeless_);
        continue;
      }
      set_deadline();
      if (worker_ && worker_->send(*job_)) return;
      worker_.reset();
      worker_ = std::make_unique<WorkerProcess>(source_.instances(), crew_, core_);
      if (worker_->send(*job_)) return;
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
          set_deadline();
          break;
        case News::made:
          source_.done(*job_, worker_->row());
          return true;
        case News::is_gone:
          give_up(worker_->end());
          return true;
      }
    }
  }

  void time_out() {
    const double limit = (*crew_.budget.row_time_s)(job_->instance->n);
    give_up({RunStatus::timeout,
             fmt::format("no {} within {:.6g} s", begun_ ? "row" : "graph", limit)});
  }

 private:
  void set_deadline() {
    deadline_ = Clock::time_point::max();
    if (!crew_.budget.row_time_s) return;
    const double limit = (*crew_.budget.row_time_s)(job_->instance->n);
    if (limit < 1e9) {
      deadline_ = Clock::now() +
                  std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit));
    }
  }

  // The row ends here, and its worker with it. Where not even the graph came, the other rows of the
  // instance are not tried.
  void give_up(const WorkerProcess::End& end) {
    worker_.reset();
    if (!begun_) {
      hopeless_ = job_->instance;
      why_hopeless_ = end;
    }
    fail(end);
  }

  void fail(const WorkerProcess::End& end) {
    RunRecord run = begun_ ? *begun_ : planned_row(*job_->instance, *job_->run);
    run.status = end.status;
    run.message = end.message;
    source_.done(*job_, std::move(run));
  }

  RowSource& source_;
  const Crew& crew_;
  int number_;
  int core_;
  std::unique_ptr<WorkerProcess> worker_;
  std::optional<RowJob> job_;
  std::optional<RunRecord> begun_;  // what is known of the row in hand, once its graph is there
  Clock::time_point deadline_{};
  std::shared_ptr<const PlannedInstance> hopeless_;
  WorkerProcess::End why_hopeless_;
};

// Waits until a worker has news, a deadline passes or it is time to ask for a stop.
void wait_for_news(const std::vector<Slot>& slots) {
  std::vector<pollfd> sockets;
  Clock::time_point until = Clock::now() + kPatience;
  for (const Slot& slot : slots) {
    if (!slot.busy()) continue;
    sockets.push_back({slot.descriptor(), POLLIN, 0});
    until = std::min(until, slot.deadline());
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now()).count();
  poll(sockets.data(), sockets.size(), static_cast<int>(std::max<long long>(0, left)));
}

}  // namespace

void make_rows_in_workers(RowSource& source, const Crew& crew) {
  const auto stopped = [&] { return crew.stop && crew.stop(); };
  std::vector<Slot> slots;
  slots.reserve(static_cast<std::size_t>(crew.size));
  for (int i = 0; i < crew.size && !stopped(); ++i) {
    slots.emplace_back(source, crew, i).begin_next();
  }
  while (std::any_of(slots.begin(), slots.end(), [](const Slot& slot) { return slot.busy(); })) {
    wait_for_news(slots);
    if (stopped()) return;  // the slots' destructors end what is in flight
    for (Slot& slot : slots) {
      if (!slot.busy()) continue;
      bool done = slot.look();
      if (!done && Clock::now() >= slot.deadline()) {
        slot.time_out();
        done = true;
      }
      if (done && !stopped()) slot.begin_next();
    }
  }
}

}  // namespace ar3d
