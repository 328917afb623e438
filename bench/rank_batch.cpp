#include "ar3d/bench/rank_batch.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <sstream>

#include "ar3d/bench/stopwatch.h"
#include "ar3d/model/error.h"
#include "ar3d/results/columns.h"

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

// What a rank tells: its time, then the records of its rows.
std::string told(double wall_s, const std::vector<Run>& rows) {
  std::string text(sizeof(wall_s) + rows.size() * run_record_size(), '\0');
  std::memcpy(text.data(), &wall_s, sizeof(wall_s));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    store_record(rows[i], text.data() + sizeof(wall_s) + i * run_record_size());
  }
  return text;
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

RankBatches::RankBatches(const StudyPlan& plan, const TimingRules& rules, int rank)
    : plan_(plan),
      rules_(rules),
      rank_(rank),
      maker_({.concurrency = 1, .core = -1, .memory = MemoryScope::process}) {}

MadeBatch RankBatches::make(Ranks& ranks, int count, std::size_t place,
                            const std::vector<std::size_t>& rows) {
  const Job job{count, place, rows};
  const std::vector<std::string> all =
      ranks.at_once(count, job.text(), [&](const std::string& text) { return make_ready(text); });
  MadeBatch made;
  made.rows.resize(rows.size());
  for (int rank = 0; rank < count; ++rank) {
    const std::string& text = all[static_cast<std::size_t>(rank)];
    const std::vector<std::size_t> share = share_of(rank, count, rows.size());
    double wall_s = 0;
    expect(text.size() == sizeof(wall_s) + share.size() * run_record_size(),
           "a rank tells its time and its rows");
    std::memcpy(&wall_s, text.data(), sizeof(wall_s));
    made.wall_s = std::max(made.wall_s, wall_s);
    for (std::size_t i = 0; i < share.size(); ++i) {
      made.rows[share[i]] = load_record(text.data() + sizeof(wall_s) + i * run_record_size());
    }
  }
  return made;
}

Work RankBatches::make_ready(const std::string& text) {
  Job job = Job::parsed(text);
  if (!instance_ || place_ != job.place) {
    place_ = job.place;
    instance_ = plan_.instances[place_];
    maker_.prepare(*instance_);
  }
  if (maker_.graph() == nullptr) {
    throw InternalError(fmt::format("internal error: rank {} cannot generate a graph that others "
                                    "can",
                                    rank_));
  }
  const AlgorithmChoice& choice = instance_->runs[job.rows.front()].choice;
  for (std::uint32_t i = 0; i < rules_.warm_up; ++i) {
    ar3d::draw(*choice.algorithm, *maker_.graph(), choice.options);
  }
  return [this, job = std::move(job)] { return draw(job); };
}

std::string RankBatches::draw(const Job& job) {
  std::vector<Run> rows;
  std::vector<std::optional<Drawing>> drawings;
  const std::vector<std::size_t> share = share_of(rank_, job.count, job.rows.size());
  for (const std::size_t i : share) rows.push_back(maker_.begun(instance_->runs[job.rows[i]]));
  drawings.resize(rows.size());
  const Stopwatch time;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].warm_ups = rules_.warm_up;
    attempt(rows[i], [&] {
      const AlgorithmChoice& choice = instance_->runs[job.rows[share[i]]].choice;
      drawings[i] = timed_drawing(*maker_.graph(), choice, counters_, rows[i]);
      rows[i].status = RunStatus::ok;
    });
  }
  const double wall_s = time.wall_s();
  for (std::size_t i = 0; i < rows.size(); ++i) {  // outside the clock
    if (drawings[i]) rows[i].drawing_hash = drawing_hash(*drawings[i]);
  }
  return told(wall_s, rows);
}

}  // namespace ar3d
