#include "ar3d/bench/run/rank_batch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <sstream>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

// Of `count` ranks, the rows of one: places among all rows of the batch.
std::vector<std::size_t> share_of(int rank, int count, std::size_t rows) {
  std::vector<std::size_t> share;
  for (auto i = static_cast<std::size_t>(rank); i < rows; i += static_cast<std::size_t>(count)) {
    share.push_back(i);
  }
  return share;
}

}  // namespace

struct RankBatches::Job {
  int count = 1;  // ranks
  std::size_t place = 0;
  std::vector<std::size_t> rows;

  std::string text() const { return fmt::format("{} {} {}", count, place, fmt::join(rows, " ")); }
  static Job parsed(const std::string& text) {
    std::istringstream words(text);
    Job job;
    words >> job.count >> job.place;
    for (std::size_t row = 0; words >> row;) job.rows.push_back(row);
    return job;
  }
};

// A rank's rows of a batch.
struct RankBatches::Share {
  std::vector<const AlgorithmChoice*> choices;
  std::vector<RunRecord> rows;
  std::vector<std::optional<Drawing>> drawings;

  // The records of the rows. The drawings are hashed now, outside the clock.
  std::string told() {
    std::string text(rows.size() * run_record_size(), '\0');
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (drawings[i]) rows[i].drawing_hash = drawing_hash(*drawings[i]);
      store_record(rows[i], text.data() + i * run_record_size());
    }
    return text;
  }
};

RankBatches::RankBatches(const StudyPlan& plan, const TimingRules& rules, int rank,
                         std::function<bool()> stop)
    : plan_(plan),
      rules_(rules),
      rank_(rank),
      stop_(std::move(stop)),
      maker_({.concurrency = 1, .core = -1, .memory = MemoryScope::process}) {}

MadeBatch RankBatches::make(Ranks& ranks, int count, std::size_t place,
                            const std::vector<std::size_t>& rows) {
  const Job job{count, place, rows};
  const DoneAtOnce done =
      ranks.at_once(count, job.text(), [&](const std::string& text) { return make_ready(text); });
  MadeBatch made{done.wall_s, std::vector<RunRecord>(rows.size())};
  for (int rank = 0; rank < count; ++rank) {
    const std::string& text = done.told[static_cast<std::size_t>(rank)];
    const std::vector<std::size_t> share = share_of(rank, count, rows.size());
    expect(text.size() == share.size() * run_record_size(), "a rank tells its rows");
    for (std::size_t i = 0; i < share.size(); ++i) {
      made.rows[share[i]] = load_record(text.data() + i * run_record_size());
    }
  }
  return made;
}

Work RankBatches::make_ready(const std::string& text) {
  const Job job = Job::parsed(text);
  if (!instance_ || place_ != job.place) {
    place_ = job.place;
    instance_ = plan_.instances[place_];
    maker_.prepare(*instance_);
  }
  if (maker_.graph() == nullptr) {
    throw InternalError(
        fmt::format("internal error: rank {} cannot generate rank 0's graph", rank_));
  }
  const AlgorithmChoice& choice = instance_->runs[job.rows.front()].choice;
  for (std::uint32_t i = 0; i < rules_.warm_up; ++i) {
    ar3d::draw(*choice.algorithm, *maker_.graph(), choice.options);
  }
  const auto share = std::make_shared<Share>();
  for (const std::size_t i : share_of(rank_, job.count, job.rows.size())) {
    const PlannedRun& run = instance_->runs[job.rows[i]];
    share->choices.push_back(&run.choice);
    share->rows.push_back(maker_.begun(run));
    share->rows.back().warm_ups = rules_.warm_up;
  }
  share->drawings.resize(share->rows.size());
  return {[this, share] { draw(*share); }, [share] { return share->told(); }};
}

void RankBatches::draw(Share& share) {
  for (std::size_t i = 0; i < share.rows.size() && !stop_(); ++i) {
    RunRecord& row = share.rows[i];
    attempt(row, [&] {
      share.drawings[i] = timed_drawing(*maker_.graph(), *share.choices[i], counters_, row);
      row.status = RunStatus::ok;
    });
  }
}

}  // namespace ar3d
