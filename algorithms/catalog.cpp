// The table of all algorithms, and what finds a row in it by its name.
// A program may add rows of its own before anything else reads the table.
#include "ar3d/algorithms/catalog.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ar3d/algorithms/compact/compact.h"
#include "ar3d/algorithms/compact_120/compact_120.h"
#include "ar3d/algorithms/diamond/diamond.h"
#include "ar3d/algorithms/grid/grid.h"
#include "ar3d/algorithms/grid_paper/grid_paper.h"
#include "ar3d/algorithms/lattice/lattice.h"
#include "ar3d/algorithms/routed/routed.h"
#include "ar3d/algorithms/two_bend/two_bend.h"
#include "ar3d/algorithms/two_bend_109/two_bend_109.h"
#include "ar3d/algorithms/two_bend_120/two_bend_120.h"
#include "ar3d/algorithms/two_bend_paper/two_bend_paper.h"
#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/open_table.h"

namespace ar3d {

namespace {

std::vector<Algorithm> catalogue() {
  return {
      // One row per line, so that one more is one more line.
      // clang-format off
      diamond::row(),
      two_bend::row(),
      grid::row(),
      compact::row(),
      compact_120::row(),
      two_bend_109::row(),
      two_bend_120::row(),
      two_bend_paper::row(),
      grid_paper::row(),
      lattice::row_109(),
      lattice::row_120(),
      routed::row_109(),
      routed::row_120(),
      // clang-format on
  };
}

OpenTable<Algorithm>& table() {
  static OpenTable<Algorithm> rows("algorithm", catalogue(),
                                   [](const Algorithm& row) { return row.draw != nullptr; });
  return rows;
}

}  // namespace

const std::vector<Algorithm>& algorithms() { return table().rows(); }

void register_algorithm(Algorithm row) { table().add(std::move(row)); }

std::vector<const Algorithm*> proved_algorithms() {
  std::vector<const Algorithm*> proved;
  for (const Algorithm& row : algorithms()) {
    if (row.guarantee.claim == Claim::proved && !row.by_name_only) proved.push_back(&row);
  }
  return proved;
}

const Algorithm& find_algorithm(std::string_view name) {
  if (const Algorithm* row = table().find(name)) return *row;
  const auto known = names_of(algorithms());
  throw InputError(fmt::format("unknown algorithm '{}'{} (known: {}; see: ar3d list algorithms)",
                               name, did_you_mean(name, known), fmt::join(known, ", ")));
}

}  // namespace ar3d
