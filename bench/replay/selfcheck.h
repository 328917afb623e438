#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/store/run_storage.h"

namespace ar3d {

/// A row that was made again and did not come out the same.
struct IrreproducibleRow {
  std::size_t row = 0;  ///< place in Results::runs
  std::vector<std::string> columns;
};

struct SelfCheck {
  std::size_t replayed = 0;
  std::size_t violated = 0;  ///< of the rows made again
  std::vector<IrreproducibleRow> irreproducible;
};

/// The places of `count` rows drawn at random without replacement, increasing; all if there are
/// fewer. A function of the seed and the rows. Rows that no replay can reproduce (timeout,
/// out_of_memory, crashed) are not drawn.
std::vector<std::size_t> sample_of_rows(const std::vector<RunRecord>& rows, std::size_t count,
                                        std::uint64_t seed);

/// Makes the rows at those places again and compares every column that is not measured, bit by bit.
/// @param after_each  told the place of every row that has been made again; may be empty.
/// @throws InputError as replayed.
SelfCheck selfcheck(const std::vector<RunRecord>& rows, const std::vector<std::size_t>& places,
                    const StudyOrigin& origin = {},
                    const std::function<void(std::size_t)>& after_each = {});

}  // namespace ar3d
