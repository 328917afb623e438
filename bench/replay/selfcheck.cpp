#include "ar3d/bench/replay/selfcheck.h"

#include <algorithm>
#include <utility>

#include "ar3d/base/random.h"
#include "ar3d/bench/replay/replay_row.h"
#include "ar3d/bench/run/make_row.h"
#include "ar3d/store/columns/run_columns.h"

namespace ar3d {

std::vector<std::size_t> sample_of_rows(const std::vector<RunRecord>& rows, std::size_t count,
                                        std::uint64_t seed) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_drawn(rows[i]) || rows[i].status == RunStatus::refused) places.push_back(i);
  }
  count = std::min(count, places.size());
  RandomStream random(seed);
  for (std::size_t i = 0; i < count; ++i) {  // a study has at most 10^7 rows
    std::swap(places[i], places[i + random.below(static_cast<std::uint32_t>(places.size() - i))]);
  }
  places.resize(count);
  std::sort(places.begin(), places.end());
  return places;
}

SelfCheck selfcheck(const std::vector<RunRecord>& rows, const std::vector<std::size_t>& places,
                    const StudyOrigin& origin, const std::function<void(std::size_t)>& after_each) {
  SelfCheck check;
  for (const std::size_t place : places) {
    const RunRecord now = replayed(rows[place], origin);
    ++check.replayed;
    if (now.status == RunStatus::violated) ++check.violated;
    std::vector<std::string> columns = differing_columns(rows[place], now);
    if (!columns.empty()) check.irreproducible.push_back({place, std::move(columns)});
    if (after_each) after_each(place);
  }
  return check;
}

}  // namespace ar3d
