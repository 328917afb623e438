// A session: its state, which rows are there and when to stop, the line that tells how far the study
// is, its phases in order, each with its threads or worker processes, and the steps that several
// ranks do together: what one of them fails at, all have failed at.
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
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/journal/journal_writer.h"

namespace ar3d {
namespace {

std::string duration(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

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

// Tells people how far a study is: one line, rewritten in place on a terminal, a new line a minute
// elsewhere. Not thread-safe.
class StudySession::Progress {
 public:
  Progress(const StudyPlan& plan, const SessionPolicy& policy, const RowSink& sink)
      : out_(policy.progress),
        terminal_(out_ != nullptr && isatty(fileno(out_)) == 1),
        name_(policy.name) {
    if (out_ != nullptr) count_rows(plan, sink);
  }

  // A row of any phase. @param work  0 of an optional one.
  void row_done(double work, bool ok) {
    ++rows_;
    work_ += work;
    if (!ok) ++not_ok_;
    if (time_.seconds() - last_s_ >= (terminal_ ? 0.2 : 60)) print();
  }

  // Ends the line on a terminal.
  void finish() {
    if (out_ == nullptr) return;
    print();
    if (terminal_) std::fputc('\n', out_);
    out_ = nullptr;
  }

 private:
  void count_rows(const StudyPlan& plan, const RowSink& sink) {
    if (sink.there == nullptr) {  // a million instances need not be made for it
      for (const PlannedBlock& block : plan.instances.blocks()) {
        const std::size_t more = block.count * required_runs(block.first);
        planned_rows_ += more;
        optional_rows_ += block.count * block.first.runs.size() - more;
        planned_work_ += static_cast<double>(more) * work_of_row(block.first.requested_n);
      }
      return;
    }
    for (const PlannedInstance& instance : plan.instances) {
      for (const PlannedRun& run : instance.runs) {
        if (sink.there->find(parse_row_key(run.row_key))) continue;
        ++(run.optional ? optional_rows_ : planned_rows_);
        if (!run.optional) planned_work_ += work_of_row(instance.requested_n);
      }
    }
  }

  void print() {
    last_s_ = time_.seconds();
    const std::string text = line(last_s_);
    std::fprintf(out_, terminal_ ? "\r%s\033[K" : "%s\n", text.c_str());
    std::fflush(out_);
  }

  std::string line(double elapsed_s) const {
    std::string text = fmt::format("study {}: {} of {}", name_, rows_, planned_rows_);
    if (optional_rows_ > 0) text += fmt::format(" to {}", planned_rows_ + optional_rows_);
    text += " rows";
    if (not_ok_ > 0) text += fmt::format(" ({} not ok)", not_ok_);
    text += ", " + duration(elapsed_s);
    if (rows_ < planned_rows_ && work_ > 0) {
      text += fmt::format(", about {} left", duration(elapsed_s * (planned_work_ - work_) / work_));
    }
    return text;
  }

  std::FILE* out_;
  bool terminal_;
  std::string name_;
  std::size_t planned_rows_ = 0;   // that the study is not complete without
  std::size_t optional_rows_ = 0;  // that may turn out not to be needed
  double planned_work_ = 0;        // of the former
  std::size_t rows_ = 0;
  std::size_t not_ok_ = 0;
  double work_ = 0;
  const Stopwatch time_;
  double last_s_ = 0;  // when it was last printed
};

int workers_for(int asked, int ranks) {
  if (asked > 0) return asked;
  return ranks > 1 ? 1 : static_cast<int>(available_threads());
}

StudySession::StudySession(const StudyPlan& plan, const SessionPolicy& policy, const RowSink& sink)
    : plan_(plan),
      policy_(policy),
      sink_(sink),
      progress_(std::make_unique<Progress>(plan, policy, sink)),
      keeps_failures_(has_run(plan, [](RunPhase phase) { return phase != RunPhase::metrics; })) {}

StudySession::~StudySession() { progress_->finish(); }

bool StudySession::wants(const PlannedRun& run) const {
  return sink_.there == nullptr || !sink_.there->find(parse_row_key(run.row_key));
}

RunRecord StudySession::known(const PlannedRun& run) const {
  return sink_.there->run(sink_.there->find(parse_row_key(run.row_key)).value());
}

void StudySession::add(const PlannedRun& run, const RunRecord& row) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (sink_failed_) return;
  if (keeps_failures_ && row.phase == RunPhase::metrics && !is_drawn(row)) {
    failed_.emplace(row.row_key, row);
  }
  try {
    sink_.add(run.row, row);
  } catch (...) {  // noted before the lock is given up, so that no other row goes there after it
    sink_failure_ = std::current_exception();
    sink_failed_ = true;
    return;
  }
  if (policy_.progress != nullptr) {
    progress_->row_done(run.optional ? 0 : work_of_row(static_cast<std::uint64_t>(row.requested_n)),
                        is_good(row.status));
  }
}

bool StudySession::stopped() const {
  return sink_failed_ || is_interrupted() ||
         (plan_.budget.study_s && time_.seconds() >= *plan_.budget.study_s);
}

std::optional<RunRecord> StudySession::failure(const PlannedInstance& instance,
                                               const PlannedRun& timed) {
  for (const PlannedRun& run : instance.runs) {
    if (run.phase != RunPhase::metrics || !is_same_drawing(run, timed)) continue;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      const auto at = failed_.find(run.row_key);
      if (at != failed_.end()) return at->second;
    }
    if (wants(run)) continue;
    RunRecord before = known(run);
    if (!is_drawn(before)) return before;
  }
  return std::nullopt;
}

void StudySession::end() {
  progress_->finish();
  if (sink_failure_) std::rethrow_exception(sink_failure_);
}

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
  constexpr char kFull = 'j', kRefused = 'i';  // before what is said of it
  std::string failure;
  try {
    step();
  } catch (const JournalFull& error) {
    failure = kFull + std::string(error.what());
  } catch (const InputError& error) {
    failure = kRefused + std::string(error.what());
  }
  failure = ranks.agree(failure);
  if (failure.empty()) return;
  ranks.have_failed = true;
  if (failure.front() == kFull) throw JournalFull(failure.substr(1));
  throw InputError(failure.substr(1));
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
