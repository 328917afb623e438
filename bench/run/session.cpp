// State that all phases of a session share: which rows are there, when to stop, and the line that
// tells how far the study is.
#include <fmt/format.h>

#include "ar3d/base/parallel.h"
#include "ar3d/bench/measure/processes.h"
#include "ar3d/bench/run/execute.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

std::string duration(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
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
    const Clock::time_point now = Clock::now();
    if (now - last_ >= std::chrono::milliseconds(terminal_ ? 200 : 60000)) print(now);
  }

  // Ends the line on a terminal.
  void finish() {
    if (out_ == nullptr) return;
    print(Clock::now());
    if (terminal_) std::fputc('\n', out_);
    out_ = nullptr;
  }

 private:
  using Clock = std::chrono::steady_clock;

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

  void print(Clock::time_point now) {
    last_ = now;
    const std::string text = line(std::chrono::duration<double>(now - start_).count());
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
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
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
  std::vector<char> record(run_record_size());
  sink_.there->read(sink_.there->find(parse_row_key(run.row_key)).value(), record.data());
  return load_record(record.data());
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
                        row.status == RunStatus::ok || row.status == RunStatus::measured);
  }
}

bool StudySession::is_budget_spent() const {
  return plan_.budget.study_s && time_.wall_s() >= *plan_.budget.study_s;
}

bool StudySession::stopped() const { return sink_failed_ || is_interrupted() || is_budget_spent(); }

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

}  // namespace ar3d
