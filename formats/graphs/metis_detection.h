#pragma once

#include <string_view>

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// The comment that our writer puts before every graph.
inline constexpr std::string_view kMetisMark = "% METIS graph, 1-based";

/// Tells METIS files from edge lists, both being lines of numbers. METIS if the text begins with
/// our mark, or if it can be METIS (a header with n >= 1 and ids 1 to n in the lines after it, as
/// far as they are seen) and cannot be an edge list: a line has not two numbers, or the first edge
/// would be the loop (n, n). A text that can be neither passes for an edge list.
bool looks_like_metis(const InputHead& head);

}  // namespace ar3d
