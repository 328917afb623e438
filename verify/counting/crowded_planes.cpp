// Horizontal against vertical segments by a plane sweep over the columns. It counts and does not
// name what it finds, so the active rows need no search tree, and a plane with a quadratic number
// of meetings costs no more than one without any. For up to 160 comparisons per record, comparing
// several at a time was faster (plane_counts.cpp). Source: Fenwick, A new data structure for
// cumulative frequency tables (1994).
#include "ar3d/verify/counting/plane_counts.h"

namespace ar3d::verify {
namespace {

/// A key that orders as the number does.
std::uint32_t key_of(std::int32_t value, std::int32_t least) {
  return static_cast<std::uint32_t>(value) - static_cast<std::uint32_t>(least);
}

/// The records from `begin` on that lie in the same plane.
std::span<const PlaneRecord> plane_from(const std::vector<PlaneRecord>& records,
                                        std::size_t begin) {
  std::size_t end = begin;
  while (end < records.size() && records[end].plane == records[begin].plane) ++end;
  return std::span(records).subspan(begin, end - begin);
}

}  // namespace

std::uint64_t CrowdedPlanes::count(Records rows, Records columns) {
  std::uint64_t crossing = 0;
  sort_records(rows, rows_);
  sort_records(columns, columns_);
  for (std::size_t r = 0, c = 0; r < rows_.size() && c < columns_.size();) {
    const Records in_row_plane = plane_from(rows_, r);
    const Records in_column_plane = plane_from(columns_, c);
    const std::uint32_t plane = in_row_plane[0].plane;
    const std::uint32_t other = in_column_plane[0].plane;
    if (plane == other) crossing += count_plane(in_row_plane, in_column_plane);
    if (plane <= other) r += in_row_plane.size();
    if (other <= plane) c += in_column_plane.size();
  }
  return crossing;
}

/// By plane, then across: radix sorts from the last key to the first.
void CrowdedPlanes::sort_records(Records from, std::vector<PlaneRecord>& to) {
  to.clear();
  if (from.empty()) return;
  std::int32_t least = from[0].at;
  bool one_plane = true;
  for (const PlaneRecord& r : from) {
    one_plane &= r.plane == from[0].plane;
    least = std::min(least, r.at);
  }
  order_.clear();
  for (std::uint32_t i = 0; i < from.size(); ++i) order_.push_back({key_of(from[i].at, least), i});
  sort_by_key(order_, buffer_);
  if (!one_plane) {
    for (ShortKeyed& item : order_) item.key = from[item.item].plane;
    sort_by_key(order_, buffer_);
  }
  for (const ShortKeyed& item : order_) to.push_back(from[item.item]);
}

void CrowdedPlanes::order_ends(Records rows) {
  std::int32_t least = rows[0].low;
  for (const PlaneRecord& row : rows) least = std::min(least, row.low);
  by_low_.clear();
  by_high_.clear();
  for (std::uint32_t i = 0; i < rows.size(); ++i) {
    by_low_.push_back({key_of(rows[i].low, least), i});
    by_high_.push_back({key_of(rows[i].high(), least), i});
  }
  sort_by_key(by_low_, buffer_);
  sort_by_key(by_high_, buffer_);
}

/// Fills a table from which rank() begins its search: about two entries per row.
void CrowdedPlanes::rank_places(Records rows) {
  places_.clear();
  for (const PlaneRecord& row : rows) places_.push_back(row.at);
  const std::uint64_t width = key_of(places_.back(), places_.front());
  shift_ = 0;
  while (width >> shift_ >= 2 * places_.size()) ++shift_;
  table_.clear();
  for (std::uint32_t i = 0; i < places_.size(); ++i) {
    const std::uint64_t entry = key_of(places_[i], places_.front()) >> shift_;
    while (table_.size() <= entry) table_.push_back(i);
  }
}

/// The number of rows at places below `value`.
std::size_t CrowdedPlanes::rank(std::int64_t value) const {
  if (value <= places_.front()) return 0;
  if (value > places_.back()) return places_.size();
  std::size_t i = table_[static_cast<std::uint64_t>(value - places_.front()) >> shift_];
  while (places_[i] < value) ++i;
  return i;
}

/// The active rows among the first `rank`.
std::uint64_t CrowdedPlanes::active_before(std::size_t rank) const {
  std::int32_t sum = 0;
  for (; rank > 0; rank &= rank - 1) sum += tree_[rank];
  return static_cast<std::uint64_t>(sum);
}

void CrowdedPlanes::change(std::size_t rank, std::int32_t by) {
  for (++rank; rank < tree_.size(); rank += rank & (~rank + 1)) tree_[rank] += by;
}

/// Both in order across.
std::uint64_t CrowdedPlanes::count_plane(Records rows, Records columns) {
  std::uint64_t crossing = 0;
  order_ends(rows);
  rank_places(rows);
  tree_.assign(rows.size() + 1, 0);
  std::size_t begun = 0;
  std::size_t ended = 0;
  for (const PlaneRecord& column : columns) {
    for (; begun < rows.size() && rows[by_low_[begun].item].low <= column.at; ++begun) {
      change(by_low_[begun].item, 1);
    }
    for (; ended < rows.size() && rows[by_high_[ended].item].high() < column.at; ++ended) {
      change(by_high_[ended].item, -1);
    }
    if (begun == ended) continue;
    const std::size_t first = rank(column.low);
    const std::size_t last = rank(std::int64_t{column.high()} + 1);
    if (first < last) crossing += active_before(last) - active_before(first);
  }
  return crossing;
}

}  // namespace ar3d::verify
