// Rows that belong together: repetitions of one drawing, and graphs of one study. Hashes of all
// rows are sorted, so that only rows that may be wrong are read again.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <tuple>

#include "ar3d/analysis/check.h"
#include "ar3d/base/printable.h"

namespace ar3d {

namespace {

/// Everything that must be equal in two drawings of the same graph with the same options, at every
/// level and by every certificate.
auto drawing_columns(const RunRecord& run) {
  return std::tie(run.graph_hash, run.drawing_hash, run.n, run.m, run.extents, run.bends,
                  run.instance_bound, run.counters);
}

std::string graph_identity(const RunRecord& run) {
  return fmt::format("{}\n{}\n{}\n{}", run.family, run.parameters, run.n, run.instance_index);
}

}  // namespace

std::string repetition_key(const RunRecord& run) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", run.algorithm, run.options, run.family,
                     run.parameters, run.requested_n, run.instance_index, run.seed);
}

// What is kept of a row.
struct RowsTogether::Fingerprint {
  std::size_t key = 0;          // hash of repetition_key
  std::size_t row = 0;          // so that rows of one key are neighbours, in file order
  std::size_t measurement = 0;  // of phase, number of workers and repetition
  std::size_t drawing = 0;      // of what repetitions have in common; 0: the row is not ok
  auto operator<=>(const Fingerprint&) const = default;
};

RowsTogether::~RowsTogether() = default;

RowsTogether::RowsTogether(const Rows& rows, const std::string& one_study)
    : rows_(rows), one_study_(one_study) {
  prints_.reserve(rows.size());
}

void RowsTogether::add(const RunRecord& run) {
  const std::hash<std::string> hash;
  const std::size_t row = prints_.size();
  Fingerprint& print = prints_.emplace_back(Fingerprint{hash(repetition_key(run)), row});
  print.measurement = hash(fmt::format("{} {} {} {} {}", run.level, asked_certificate(run),
                                       static_cast<int>(run.phase), run.workers, run.repetition));
  if (run.status == RunStatus::ok) {
    print.drawing =
        hash(fmt::format("{}\n{}\n{} {}\n{}\n{}\n{}\n{}", run.graph_hash, run.drawing_hash, run.n,
                         run.m, fmt::join(run.extents, " "), fmt::join(run.bends, " "),
                         fmt::join(run.instance_bound, " "), run.counters)) |
        1;
  }
  if (one_study_.empty()) return;
  if (!run.row_key.empty()) keys_.emplace_back(parse_row_key(run.row_key), row);
  if (run.n < 0) return;
  const std::size_t graph = hash(graph_identity(run));  // neighbours are mostly one
  const bool is_known = !graphs_.empty() && std::get<0>(graphs_.back()) == graph &&
                        std::get<1>(graphs_.back()) == run.seed;
  if (!is_known) graphs_.emplace_back(graph, run.seed, row);
}

void RowsTogether::require_one_study() {
  if (one_study_.empty()) return;
  std::sort(keys_.begin(), keys_.end());
  if (!keys_.empty() && keys_.front().first == RowKey()) {
    throw InputError(
        fmt::format("{}: the key of row {} is zero", one_study_, keys_.front().second));
  }
  for (std::size_t i = 1; i < keys_.size(); ++i) {
    if (keys_[i - 1].first != keys_[i].first) continue;
    throw InputError(fmt::format("{}: rows {} and {} have one key, {}", one_study_,
                                 keys_[i - 1].second, keys_[i].second, to_string(keys_[i].first)));
  }
  const std::int64_t planned = rows_.identity().planned_rows;
  if (planned >= 0 && rows_.size() > static_cast<std::size_t>(planned)) {
    throw InputError(fmt::format("{}: {} rows, but its study plans {}: there is no row {}",
                                 one_study_, rows_.size(), planned, planned));
  }
  std::sort(graphs_.begin(), graphs_.end());
  for (std::size_t i = 1; i < graphs_.size(); ++i) {
    const auto& [identity, seed, row] = graphs_[i - 1];
    const auto& [next_identity, next_seed, next_row] = graphs_[i];
    if (identity != next_identity || seed == next_seed) continue;
    const auto [first, second] = std::minmax(row, next_row);
    const RunRecord run = rows_.run(first);  // a copy: the next call reads over it
    if (graph_identity(run) != graph_identity(rows_.run(second))) continue;
    throw InputError(fmt::format(
        "{}: rows {} and {} are of different studies: {}, n = {}, instance {} has two seeds",
        one_study_, first, second, one_line(run.family), run.n, run.instance_index));
  }
  keys_ = decltype(keys_)(), graphs_ = decltype(graphs_)();  // their memory
}

// True if they may hold a measurement twice or different drawings.
bool RowsTogether::is_suspicious(const Repetitions& rows) {
  std::set<std::size_t> measurements, drawings;
  for (const Fingerprint& print : rows) {
    if (!measurements.insert(print.measurement).second) return true;
    if (print.drawing != 0) drawings.insert(print.drawing);
  }
  return drawings.size() > 1;
}

std::vector<bool> RowsTogether::find_in_repetitions(const FindingSink& found) {
  std::vector<bool> is_last(prints_.size());
  std::vector<Repetitions> suspicious;
  std::sort(prints_.begin(), prints_.end());
  for (auto begin = prints_.cbegin(), end = begin; begin != prints_.cend(); begin = end) {
    end = std::find_if(begin, prints_.cend(),
                       [&](const Fingerprint& print) { return print.key != begin->key; });
    is_last[(end - 1)->row] = true;
    if (end - begin > 1 && is_suspicious({begin, end})) suspicious.emplace_back(begin, end);
  }
  // In the order of the file, where reading is cheap.
  std::sort(suspicious.begin(), suspicious.end(), [](const Repetitions& a, const Repetitions& b) {
    return a.front().row < b.front().row;
  });
  for (const Repetitions& rows : suspicious) compare(rows, found);
  return is_last;
}

void RowsTogether::compare(const Repetitions& rows, const FindingSink& found) const {
  std::map<std::string, RunRecord> first;  // that is ok; of several drawings if hashes are equal
  std::set<std::tuple<std::string, std::string, std::string, RunPhase, std::int64_t, std::int64_t>>
      measured;
  for (const Fingerprint& print : rows) {
    const RunRecord& run = rows_.run(print.row);
    const std::string drawing = repetition_key(run);
    if (!measured
             .insert({drawing, run.level, asked_certificate(run), run.phase, run.workers,
                      run.repetition})
             .second) {
      found({FindingKind::duplicate, print.row, "the same measurement stands twice"}, &run);
    }
    if (run.status != RunStatus::ok) continue;
    const RunRecord& other = first.try_emplace(drawing, run).first->second;
    if (drawing_columns(run) != drawing_columns(other)) {
      found({FindingKind::not_repeatable, print.row,
             "another drawing than the first repetition's of the same graph"},
            &run);
    }
  }
}

}  // namespace ar3d
