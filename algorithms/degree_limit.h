#pragma once

#include <cstdint>
#include <string_view>

#include "ar3d/model/graph.h"

namespace ar3d {

/// @throws InputError naming the first vertex whose degree passes the algorithm's limit. O(1) if
/// there is none, else O(n).
void refuse_larger_degrees(std::string_view algorithm, const Graph& graph, std::uint32_t limit);

/// @throws InputError if the graph has more vertices than the algorithm's integer widths are proved
/// for. O(1).
void refuse_more_vertices(std::string_view algorithm, const Graph& graph, std::uint32_t limit);

}  // namespace ar3d
