#pragma once

#include "ar3d/generators/catalog.h"

namespace ar3d {

/// Adds a row to the catalogue, for programs that bring families of their own: before anything else
/// uses it, by one thread. References to other rows stay valid.
/// @throws InputError if the name is taken or empty, or a function is missing; if there are more
/// than 1000 rows.
void register_family(Family row);

}  // namespace ar3d
