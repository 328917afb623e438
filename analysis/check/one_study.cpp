#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "ar3d/analysis/check.h"
#include "ar3d/analysis/text.h"
#include "ar3d/base/error.h"

namespace ar3d {

void require_one_study(const RowView& rows, const std::string& path) {
  struct Graph {
    std::size_t identity;  // hash of family, parameters, n and index
    std::uint64_t seed;
    std::size_t row;
    auto operator<=>(const Graph&) const = default;
  };
  const auto identity_of = [](const RunRecord& run) {
    return fmt::format("{}\n{}\n{}\n{}", run.family, run.parameters, run.n, run.instance_index);
  };
  std::vector<Graph> graphs;
  std::string former;  // neighbours are mostly of one graph
  for (std::size_t row = 0; row < rows.count; ++row) {
    const RunRecord& run = rows.read(row);
    if (run.n < 0) continue;
    std::string identity = identity_of(run);
    if (identity == former && run.seed == graphs.back().seed) continue;
    graphs.push_back({std::hash<std::string>()(identity), run.seed, row});
    former = std::move(identity);
  }
  std::sort(graphs.begin(), graphs.end());
  for (std::size_t i = 1; i < graphs.size(); ++i) {
    const Graph &one = graphs[i - 1], &two = graphs[i];
    if (one.identity != two.identity || one.seed == two.seed) continue;
    const RunRecord run = rows.read(std::min(one.row, two.row));
    if (identity_of(run) != identity_of(rows.read(std::max(one.row, two.row)))) continue;
    throw InputError(fmt::format(
        "{}: rows {} and {} are of different studies: {}, n = {}, instance {} has two seeds", path,
        std::min(one.row, two.row), std::max(one.row, two.row), one_line(run.family), run.n,
        run.instance_index));
  }
}

}  // namespace ar3d
