#pragma once

#include <string_view>
#include <vector>

#include "ar3d/algorithms/algorithm.h"

namespace ar3d {

/// All algorithms, in the order in which they are listed.
const std::vector<Algorithm>& algorithms();

/// Returns what "all" means in a study: those whose every drawing keeps its guarantee. Others are
/// named where they are wanted: those that are measured, and those made only for comparison
/// (by_name_only).
std::vector<const Algorithm*> proved_algorithms();

/// @throws InputError naming the unknown algorithm and the known ones.
const Algorithm& find_algorithm(std::string_view name);

/// Adds a row to the catalogue, for programs that bring algorithms of their own: before anything
/// else uses it, by one thread. References to other rows stay valid.
/// @throws InputError if the name is taken or empty, or there is no drawing function; if there are
/// more than 1000 rows.
void register_algorithm(Algorithm row);

}  // namespace ar3d
