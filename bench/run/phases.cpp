// The two orders in which rows are made. The metrics phase finishes one instance after the other;
// the timing phase goes round over all drawings, so that a disturbance meets all of them alike. The
// settings of a graph take turns there, in an order that changes from round to round.
#include <fmt/format.h>

#include <deque>
#include <set>

#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/run/execute.h"

namespace ar3d {
double halves_difference(std::span<const double> values) {
  if (values.size() < 2) return std::numeric_limits<double>::infinity();
  const auto median = [](std::span<const double> half) {
    std::vector<double> sorted(half.begin(), half.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    return *middle;
  };
  return std::abs(median(values.first(values.size() / 2)) -
                  median(values.subspan(values.size() / 2)));
}

namespace {

// One drawing's repetitions.
struct TimedDrawing {
  std::size_t index = 0;
  std::shared_ptr<const PlannedInstance> instance;
  std::deque<const PlannedRun*> left;  // rows not made yet, by repetition
  std::vector<double> times;           // log_corrected_time()
  double precision = 0.01;             // where the study asks for none
  std::optional<RunRecord> certified;

  bool has_optional() const { return !left.empty() && left.front()->optional; }
  bool is_stable() const { return halves_difference(times) <= precision; }
};

class TimingRounds {
 public:
  static constexpr double kEnough = 0.95;  // of the drawings

  explicit TimingRounds(StudySession& session) : session_(session), rules_(session.plan().timing) {
    for (const PlannedBlock& block : session.plan().instances.blocks()) {
      if (!has_run(block.first, [](RunPhase phase) { return phase == RunPhase::timing; })) continue;
      for (std::size_t i = 0; i < block.count; ++i) add_drawings(block.first_index + i);
    }
    begin_round();
  }

  std::optional<RowJob> next() {
    const std::lock_guard<std::mutex> lock(mutex_);
    while (!round_.empty() || begin_round()) {
      const std::size_t index = round_.front();
      round_.pop_front();
      TimedDrawing& drawing = drawings_[index];
      if (drawing.left.empty()) continue;  // it has failed meanwhile
      if (const auto failed = session_.failure(*drawing.instance, *drawing.left.front())) {
        fail_all(drawing, *failed);
        continue;
      }
      const PlannedRun* run = drawing.left.front();
      drawing.left.pop_front();
      return RowJob{drawing.instance,
                    {.index = drawing.index,
                     .run = static_cast<std::size_t>(run - drawing.instance->runs.data()),
                     .certify = !drawing.certified,
                     .warm_ups = rules_.warm_up,
                     .write = rules_.write,
                     .restart = rules_.restart},
                    index};
    }
    return std::nullopt;
  }

  void done(const RowJob& job, RunRecord row) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t i = 0; i < row.yardsticks_s.size(); ++i) {
      const double one_s = row.yardsticks_s[i];
      if (one_s > 0 && known_yardsticks_[i].insert(one_s).second) yardsticks_s_ += one_s;
    }
    TimedDrawing& drawing = drawings_[job.number];
    if (drawing.certified) {
      take_over_certificate(*drawing.certified, row);
    } else if (is_drawn(row)) {
      drawing.certified = row;
    }
    session_.add(job.run(), row);
    if (!is_drawn(row)) {
      fail_all(drawing, row);
      return;
    }
    drawing.times.push_back(log_corrected_time(row));
  }

  /// What is to be known of the phase when it is over.
  std::vector<EnvironmentEntry> ending() const {
    std::size_t rounds = 0, stable = 0;
    bool has_more = false;
    for (const TimedDrawing& drawing : drawings_) {
      rounds = std::max(rounds, drawing.times.size());
      stable += drawing.is_stable();
      has_more = has_more || !drawing.left.empty();
    }
    const char* why = session_.stopped() ? "then stopped"
                      : has_more         ? "enough for the precision"
                                         : "as many as the study makes";
    const double all_s = time_.seconds() * rules_.concurrency;
    std::vector<EnvironmentEntry> entries = {
        {kTimingRounds, fmt::format("{} rounds, {}: {} of {} drawings are stable", rounds, why,
                                    stable, drawings_.size())},
        {kTimingYardsticks, fmt::format("{:.3g} s, {:.1f} % of the time", yardsticks_s_,
                                        100 * yardsticks_s_ / all_s)}};
    if (rules_.concurrency == 1) {
      entries.push_back({kTimingOrder, "settings of a graph in turns, in random order"});
    }
    return entries;
  }

 private:
  // The drawings of an instance: runs of one algorithm and options follow each other in the plan.
  void add_drawings(std::size_t index) {
    const auto instance = std::make_shared<const PlannedInstance>(session_.plan().instances[index]);
    const PlannedRun* previous = nullptr;
    for (const PlannedRun& run : instance->runs) {
      if (run.phase != RunPhase::timing) continue;
      const bool same = previous != nullptr && is_same_drawing(run, *previous);
      if (!same) {
        drawings_.emplace_back().instance = instance;
        drawings_.back().index = index;
        if (run.precision > 0) drawings_.back().precision = run.precision;
      }
      previous = &run;
      if (session_.wants(run)) {
        drawings_.back().left.push_back(&run);
      } else if (const RunRecord known = session_.known(run); is_drawn(known)) {
        drawings_.back().times.push_back(log_corrected_time(known));
      }
    }
  }

  // All drawings that have a row left, the optional ones only while too few are stable. Rows of the
  // round before that other workers have in hand do not count yet. False: there is none.
  bool begin_round() {
    std::size_t optional = 0, stable = 0;
    for (const TimedDrawing& drawing : drawings_) {
      optional += drawing.has_optional();
      stable += drawing.has_optional() && drawing.is_stable();
    }
    const bool is_enough = static_cast<double>(stable) >= kEnough * static_cast<double>(optional);
    std::vector<std::size_t> round;
    for (std::size_t i = 0; i < drawings_.size(); ++i) {
      const bool has_more = !drawings_[i].left.empty();
      if (has_more && !(is_enough && drawings_[i].has_optional())) round.push_back(i);
    }
    shuffle_settings(round);
    round_.assign(round.begin(), round.end());
    return !round_.empty();
  }

  // Drawings of one graph stand together.
  void shuffle_settings(std::vector<std::size_t>& round) {
    for (auto begin = round.begin(), end = begin; begin != round.end(); begin = end) {
      const std::size_t index = drawings_[*begin].index;
      end = std::find_if(begin, round.end(), [&](auto i) { return drawings_[i].index != index; });
      order_.shuffle(std::span(begin, end));
    }
  }

  // Every row that the study needs of a drawing that failed is a row that says so.
  void fail_all(TimedDrawing& drawing, const RunRecord& failed) {
    for (const PlannedRun* run : drawing.left) {
      if (run->optional) continue;
      session_.add(*run, failed_row(*drawing.instance, *run, failed));
    }
    drawing.left.clear();
  }

  StudySession& session_;
  const TimingRules& rules_;
  const Stopwatch time_;
  std::array<std::set<double>, 3> known_yardsticks_;
  double yardsticks_s_ = 0;  // that they took
  std::mutex mutex_;
  std::vector<TimedDrawing> drawings_;
  std::deque<std::size_t> round_;  // indices in drawings_ of those that wait for their turn
  RandomStream order_{1};
};

}  // namespace

void make_metrics(StudySession& session) {
  const std::vector<std::uint32_t> order = largest_first(session.plan());
  std::mutex mutex;
  std::size_t begun = 0;
  std::map<int, std::deque<RowJob>> jobs_of;  // of the instance that each worker has in hand
  const auto next = [&](int worker) -> std::optional<RowJob> {
    const std::lock_guard<std::mutex> lock(mutex);
    std::deque<RowJob>& jobs = jobs_of[worker];
    while (jobs.empty()) {
      if (begun == order.size()) return std::nullopt;
      const std::size_t index = order[begun++];
      const auto instance =
          std::make_shared<const PlannedInstance>(session.plan().instances[index]);
      for (std::size_t i = 0; i < instance->runs.size(); ++i) {
        const PlannedRun& run = instance->runs[i];
        if (run.phase == RunPhase::metrics && session.wants(run)) {
          jobs.push_back({instance, {.index = index, .run = i}});
        }
      }
      std::ranges::stable_sort(jobs, {}, [](const RowJob& job) { return job.run().repetition; });
    }
    RowJob job = std::move(jobs.front());
    jobs.pop_front();
    return job;
  };
  const SessionPolicy& policy = session.policy();
  execute({.session = session,
           .workers = policy.workers,
           .elsewhere = policy.workers_elsewhere,
           .next = next,
           .done = [&](const RowJob& job, const RunRecord& row) { session.add(job.run(), row); }});
}

void make_timing(StudySession& session) {
  const std::uint32_t workers = session.plan().timing.concurrency;
  const std::vector<int> allowed = allowed_cores();
  TimingRounds rounds(session);
  execute({.session = session,
           .workers = static_cast<int>(workers),
           .cores = {allowed.rbegin(), allowed.rbegin() + workers},  // the system's are the first
           .next = [&](int) { return rounds.next(); },
           .done = [&](const RowJob& job, RunRecord row) { rounds.done(job, std::move(row)); }});
  for (const EnvironmentEntry& entry : rounds.ending()) session.note(entry);
}

}  // namespace ar3d
