#pragma once

#include <string>
#include <vector>

#include "ar3d/analysis/compare/pairing.h"

namespace ar3d {

/// What a change of a value without noise means.
enum class Effect { other, better, worse, violated };

/// One such change of one row.
struct FixedChange {
  Effect effect = Effect::other;
  std::string message;  ///< one line: what, before, after
};

/// Status, certificate, graph, volume (exact, lattice points of the box) and bends of one pair of
/// rows. Values that one of the two misses are not compared; a drawing that differs in something
/// else is `other`.
std::vector<FixedChange> fixed_changes(const PairedRow& row);

/// log2(new / base) of the volume; 0 where one of the two has no box.
double log2_volume_change(const PairedRow& row);

/// Counted instructions of a whole cell: worse or better if their sum changes by more than
/// `threshold` (0.01 is 1 %); rows that miss them are left out. @return at most one.
std::vector<FixedChange> instruction_change(const PairedCell& cell, double threshold);

}  // namespace ar3d
