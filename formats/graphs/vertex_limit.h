#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// Why a graph of n vertices written in `bytes` bytes is refused: more vertices than 32-bit ids, or
/// far more than its text can account for. Nothing if it is accepted.
std::optional<std::string> vertex_count_problem(std::uint64_t n, std::uint64_t bytes,
                                                const ReadOptions& options);

}  // namespace ar3d
