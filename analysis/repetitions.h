#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "ar3d/analysis/check.h"

namespace ar3d {

/// Returns which graph, drawn how: rows that agree in it are repetitions.
std::string repetition_key(const RunRecord& run);

/// Holds what is kept of a row: hashes, so that only rows that may be wrong are read again.
struct Fingerprint {
  std::size_t key = 0;          ///< of repetition_key
  std::size_t row = 0;          ///< so that rows of one key are neighbours, in file order
  std::size_t measurement = 0;  ///< of phase, scale and repetition
  std::size_t drawing = 0;      ///< of what repetitions must have in common; 0: the row is not ok
  auto operator<=>(const Fingerprint&) const = default;
};
Fingerprint fingerprint_of(const RunRecord& run, std::size_t row);

using FindingSink = std::function<void(Finding, const RunRecord&)>;

/// Measurements that stand twice and repetitions that differ. Only rows whose fingerprints are
/// suspicious are read. @param sorted  the fingerprints of all rows.
void find_in_repetitions(const RowView& rows, const std::vector<Fingerprint>& sorted,
                         const FindingSink& found);

}  // namespace ar3d
