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

/// True if rows of one key may hold a measurement twice or different drawings.
bool is_suspicious(std::span<const Fingerprint> prints) {
  std::set<std::size_t> measurements, drawings;
  for (const Fingerprint& print : prints) {
    if (!measurements.insert(print.measurement).second) return true;
    if (print.drawing != 0) drawings.insert(print.drawing);
  }
  return drawings.size() > 1;
}

/// The rows of one key, as neighbours among sorted fingerprints.
using KeyRows = std::span<const Fingerprint>;

std::vector<KeyRows> suspicious_keys(const std::vector<Fingerprint>& sorted) {
  std::vector<KeyRows> keys;
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = std::find_if(
        begin, sorted.end(), [&](const Fingerprint& print) { return print.key != begin->key; });
    if (end - begin > 1 && is_suspicious({begin, end})) keys.emplace_back(begin, end);
    begin = end;
  }
  return keys;
}

std::string graph_identity(const RunRecord& run) {
  return fmt::format("{}\n{}\n{}\n{}", run.family, run.parameters, run.n, run.instance_index);
}

// @throws InputError if one is zero or there twice.
void require_keys(RowKeys keys, const std::string& path) {
  std::sort(keys.begin(), keys.end());
  if (!keys.empty() && keys.front().first == RowKey()) {
    throw InputError(fmt::format("{}: the key of row {} is zero", path, keys.front().second));
  }
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i - 1].first != keys[i].first) continue;
    throw InputError(fmt::format("{}: rows {} and {} have one key, {}", path, keys[i - 1].second,
                                 keys[i].second, to_string(keys[i].first)));
  }
}

}  // namespace

std::string repetition_key(const RunRecord& run) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}", run.algorithm, run.options, run.family,
                     run.parameters, run.requested_n, run.instance_index, run.seed);
}

Fingerprint fingerprint_of(const RunRecord& run, std::size_t row) {
  const std::hash<std::string> hash;
  Fingerprint print{hash(repetition_key(run)), row, 0, 0};
  print.measurement = hash(fmt::format("{} {} {} {} {}", run.level, asked_certificate(run),
                                       static_cast<int>(run.phase), run.workers, run.repetition));
  if (run.status == RunStatus::ok) {
    print.drawing =
        hash(fmt::format("{}\n{}\n{} {}\n{}\n{}\n{}\n{}", run.graph_hash, run.drawing_hash, run.n,
                         run.m, fmt::join(run.extents, " "), fmt::join(run.bends, " "),
                         fmt::join(run.instance_bound, " "), run.counters)) |
        1;
  }
  return print;
}

void find_in_repetitions(const Rows& rows, const std::vector<Fingerprint>& sorted,
                         const FindingSink& found) {
  std::vector<KeyRows> suspicious = suspicious_keys(sorted);
  // In the order of the file, where reading is cheap.
  std::sort(suspicious.begin(), suspicious.end(),
            [](const KeyRows& a, const KeyRows& b) { return a.front().row < b.front().row; });
  for (const KeyRows& key : suspicious) {
    std::map<std::string, RunRecord> first;  // that is ok; of several drawings if hashes are equal
    std::set<
        std::tuple<std::string, std::string, std::string, RunPhase, std::int64_t, std::int64_t>>
        measured;
    for (const Fingerprint& print : key) {
      const RunRecord& run = rows.run(print.row);
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
}

void note_of_study(const RunRecord& run, std::size_t row, RowKeys& keys, GraphSeeds& graphs) {
  if (!run.row_key.empty()) keys.emplace_back(parse_row_key(run.row_key), row);
  if (run.n < 0) return;
  const std::tuple graph(std::hash<std::string>()(graph_identity(run)), run.seed, row);
  const auto is_it = [&](const auto& former) {
    return std::get<0>(former) == std::get<0>(graph) && std::get<1>(former) == run.seed;
  };
  if (graphs.empty() || !is_it(graphs.back()))
    graphs.push_back(graph);  // neighbours are mostly one
}

void require_one_study(const Rows& rows, RowKeys keys, GraphSeeds graphs, const std::string& path) {
  require_keys(std::move(keys), path);
  if (rows.identity().planned_rows >= 0 &&
      rows.size() > static_cast<std::size_t>(rows.identity().planned_rows)) {
    throw InputError(fmt::format("{}: {} rows, but its study plans {}: there is no row {}", path,
                                 rows.size(), rows.identity().planned_rows,
                                 rows.identity().planned_rows));
  }
  std::sort(graphs.begin(), graphs.end());
  for (std::size_t i = 1; i < graphs.size(); ++i) {
    const auto& [identity, seed, row] = graphs[i - 1];
    const auto& [next_identity, next_seed, next_row] = graphs[i];
    if (identity != next_identity || seed == next_seed) continue;
    const auto [first, second] = std::minmax(row, next_row);
    RunRecord run;
    run = rows.run(first);  // a copy: the next call reads over it
    if (graph_identity(run) != graph_identity(rows.run(second))) continue;
    throw InputError(fmt::format(
        "{}: rows {} and {} are of different studies: {}, n = {}, instance {} has two seeds", path,
        first, second, one_line(run.family), run.n, run.instance_index));
  }
}

}  // namespace ar3d
