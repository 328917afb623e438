#pragma once

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// DIMACS: "p edge N M" or "p col N M" with lines "e u v"; "p sp N M" with arcs "a u v [weight]"
/// both ways.
GraphFormat dimacs_format();

}  // namespace ar3d
