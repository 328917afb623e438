#pragma once

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// The formats of nauty and its relatives (https://users.cecs.anu.edu.au/~bdm/data/formats.txt):
/// one graph per line of printable characters. A file may mix the kinds of lines: whichever of the
/// formats is chosen, ':' begins sparse6, ';' incremental sparse6, everything else graph6.
GraphFormat graph6_format();
GraphFormat sparse6_format();
GraphFormat incremental_sparse6_format();

}  // namespace ar3d
