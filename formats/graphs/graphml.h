#pragma once

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// GraphML, parsed by pugixml: vertices are numbered in the order of their <node> elements; a file
/// may hold several <graph> elements. Attributes are read over. The whole file is held in memory
/// while it is read.
GraphFormat graphml_format();

}  // namespace ar3d
