#pragma once

#include "ar3d/algorithms/catalog.h"

namespace ar3d {

/// Adds a row to the catalogue, for programs that bring algorithms of their own: before anything
/// else uses it, by one thread. References to other rows stay valid.
/// @throws InputError if the name is taken or empty, or there is no drawing function; if there are
/// more than 1000 rows.
void register_algorithm(Algorithm row);

}  // namespace ar3d
