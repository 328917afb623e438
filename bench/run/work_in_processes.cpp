// Hands rows to worker processes, forked ones, and watches them. A row that crashes, takes too long
// or too much memory costs its process only; time in which the whole study was frozen does not
// count.
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <algorithm>
#include <boost/scope_exit.hpp>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>

#include "ar3d/base/error.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/execute.h"
#include "ar3d/bench/run/row_maker.h"

namespace ar3d {
namespace {

constexpr char kBegun = 'b';
constexpr char kMade = 'm';

// How many processes the kernel has killed for want of memory since it was started.
long long oom_kills() {
  std::ifstream in("/proc/vmstat");
  long long count = 0;
  for (std::string name; in >> name >> count;) {
    if (name == "oom_kill") return count;
  }
  return 0;
}

std::vector<int> descriptors_of_graphs(const StudyPlan& plan) {
  std::vector<int> needed;
  for (const PlannedBlock& block : plan.instances.blocks()) {
    if (const auto& corpus = block.first.choice.corpus) {
      needed.push_back(corpus->descriptor());
    }
  }
  return needed;
}

static_assert(std::is_trivially_copyable_v<RowRequest>);  // it is sent as it stands in memory

// Serves rows until the parent hangs up. Source and plan are the parent's.
void serve(int socket, const RowSource& source, int worker) {
  const StudyPlan& plan = source.session.plan();
  const Pinning pinning(source.core_of(worker));
  RowMaker maker = source.maker(worker, MemoryScope::worker);
  RowRequest request;
  while (receive_all(socket, bytes_in(request))) {
    RunRecord run;
    {
      std::optional<rlimit> before;
      if (const auto& limit = plan.budget.row_memory_bytes) {
        before = limit_address_space((*limit)(plan.instances[request.index].n));
      }
      BOOST_SCOPE_EXIT_ALL(&) {
        if (before) setrlimit(RLIMIT_AS, &*before);
      };
      const PlannedRun& planned = maker.prepare(plan, request.index).runs.at(request.run);
      if (!send_all(socket, row_message(kBegun, maker.begun(planned)))) return;
      run = maker.make_row(planned, request);
    }
    if (!send_all(socket, row_message(kMade, run))) return;
  }
}

using Clock = std::chrono::steady_clock;

constexpr double kPatienceSeconds = 0.1;  // until stop is asked again

// Tells the seconds in which this process was awake. It looks at the clock every kPatienceSeconds;
// a much longer step is one in which it was frozen, and the whole study with it (SIGSTOP, scontrol
// suspend).
std::function<double()> awake_clock() {
  return [last = Clock::now(), awake_s = 0.0]() mutable {
    const Clock::time_point now = Clock::now();
    const std::chrono::duration<double> step = now - std::exchange(last, now);
    return awake_s += std::min(step.count(), kPatienceSeconds + 1);
  };
}

// How a row ended without a worker's word: "killed by signal 11 (Segmentation fault)", …
using WorkerEnd = std::pair<RunStatus, std::string>;

// A slot of a worker, a forked process that makes rows and ends with this object: it has a row in
// hand, or there is nothing left for it.
class WorkerSlot {
 public:
  WorkerSlot(const RowSource& source, const std::function<double()>& awake_s, int number)
      : source_(source), awake_s_(awake_s), number_(number) {}

  bool busy() const { return job_.has_value(); }
  int descriptor() const { return worker_->socket(); }
  // Seconds until the row can be late at the earliest; 0: it is late.
  double left_s() const {
    if (!limit_s_) return kPatienceSeconds;
    const double computing = cpu_s() - cpu_before_s_;
    const double waiting = awake_s_() - began_s_;
    return std::max(0.0, std::min(*limit_s_ - computing, idle_limit_s(*limit_s_) - waiting));
  }

  // Takes the next row and hands it to the worker, a new one if the last one is gone.
  void begin_next() {
    while ((job_ = source_.next(number_))) {
      begun_.reset();
      if (job_->instance == failed_instance_) {
        fail(failure_);
        continue;
      }
      if (worker_ && send()) return begin_time();
      begin_worker();
      if (send()) return begin_time();
      give_up(end_of_worker());
    }
  }

  // Reads what the worker wrote, without waiting; true if the row is done, one way or the other.
  bool look() {
    for (;;) {
      while (received_.size() < row_message_size()) {
        char bytes[4096];
        const ssize_t got = recv(worker_->socket(), bytes, sizeof bytes, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && errno == EAGAIN) return false;
        if (got <= 0) {
          give_up(end_of_worker());
          return true;
        }
        received_.append(bytes, static_cast<std::size_t>(got));
      }
      RunRecord row;
      const std::string_view first(received_.data(), row_message_size());
      const char tag = read_row_message(first, row).value_or('\0');
      if (tag != kBegun && tag != kMade) {
        give_up({RunStatus::crashed, "its process wrote into the socket that rows come through"});
        return true;
      }
      received_.erase(0, row_message_size());
      if (tag == kMade) {
        source_.done(*job_, std::move(row));
        return true;
      }
      begun_ = std::move(row);  // the graph is there, the row itself begins
      begin_time();
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

  // @throws InputError if the system has no process or descriptor left.
  void begin_worker() {
    row_message_size();  // so that the columns are made once, by the parent
    worker_.reset();
    received_.clear();
    oom_kills_before_ = oom_kills();
    const std::vector<int> kept = descriptors_of_graphs(source_.session.plan());
    worker_ = Child::forked({.kept = kept}, [&](int socket) {
      serve(socket, source_, number_);
      return 0;
    });
    fcntl(worker_->socket(), F_SETFL, O_NONBLOCK);
  }

  // False if the process is gone. Less than a socket's buffer: it never waits.
  bool send() { return send_all(worker_->socket(), bytes_in(job_->request)); }

  // CPU time so far; the largest double once it has ended.
  double cpu_s() const {
    const double seconds = worker_->cpu_s();
    return std::isnan(seconds) ? std::numeric_limits<double>::max() : seconds;
  }

  // How the worker ended, once it has closed its socket.
  WorkerEnd end_of_worker() {
    const int status = worker_->wait();
    if (WIFEXITED(status)) {
      return {RunStatus::crashed, fmt::format("exited with code {}", WEXITSTATUS(status))};
    }
    const int signal = WTERMSIG(status);
    if (signal == SIGKILL && oom_kills() > oom_kills_before_) {
      return {RunStatus::out_of_memory, "killed by the system for want of memory"};
    }
    return {RunStatus::crashed, fmt::format("killed by signal {} ({})", signal, strsignal(signal))};
  }

  void begin_time() {
    limit_s_.reset();
    const Budget& budget = source_.session.plan().budget;
    if (!budget.row_time_s) return;
    limit_s_ = (*budget.row_time_s)(job_->instance->n);
    cpu_before_s_ = cpu_s();
    began_s_ = awake_s_();
  }

  // The row ends here, and its worker with it. Where not even the graph came, the other rows of the
  // instance are not tried.
  void give_up(const WorkerEnd& end) {
    worker_.reset();
    if (!begun_) {
      failed_instance_ = job_->instance;
      failure_ = end;
    }
    fail(end);
  }

  void fail(const WorkerEnd& end) {
    RunRecord run = begun_ ? *begun_ : planned_row(*job_->instance, job_->run());
    std::tie(run.status, run.message) = end;
    source_.done(*job_, std::move(run));
  }

  const RowSource& source_;
  const std::function<double()>& awake_s_;
  int number_;
  std::optional<Child> worker_;
  long long oom_kills_before_ = 0;  // before the worker began
  std::string received_;            // from it
  std::optional<RowJob> job_;
  std::optional<RunRecord> begun_;  // what is known of the row in hand, once its graph is there
  std::optional<double> limit_s_;   // of the row or graph in hand
  double cpu_before_s_ = 0;
  double began_s_ = 0;
  std::shared_ptr<const PlannedInstance> failed_instance_;
  WorkerEnd failure_;
};

// Waits until a worker has news, a row may be late or it is time to ask for a stop.
void wait_for_news(const std::vector<WorkerSlot>& slots) {
  std::vector<pollfd> sockets;
  double left_s = kPatienceSeconds;
  for (const WorkerSlot& slot : slots) {
    if (!slot.busy()) continue;
    sockets.push_back({slot.descriptor(), POLLIN, 0});
    left_s = std::min(left_s, slot.left_s());
  }
  poll(sockets.data(), sockets.size(), static_cast<int>(std::ceil(1000 * left_s)));
}

}  // namespace

void work_in_processes(const RowSource& source) {
  const auto stopped = [&] { return source.session.stopped(); };
  const std::function<double()> awake_s = awake_clock();
  std::vector<WorkerSlot> slots;
  slots.reserve(static_cast<std::size_t>(source.workers));
  for (int i = 0; i < source.workers && !stopped(); ++i) {
    slots.emplace_back(source, awake_s, i).begin_next();
  }
  while (
      std::any_of(slots.begin(), slots.end(), [](const WorkerSlot& slot) { return slot.busy(); })) {
    wait_for_news(slots);
    if (stopped()) return;  // the slots' destructors end what is in flight
    for (WorkerSlot& slot : slots) {
      if (!slot.busy()) continue;
      bool done = slot.look();
      if (!done && slot.left_s() <= 0) {
        slot.time_out();
        done = true;
      }
      if (done && !stopped()) slot.begin_next();
    }
  }
}

}  // namespace ar3d
