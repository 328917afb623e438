#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "ar3d/algorithms/compact/decomposition.h"
#include "ar3d/algorithms/compact/narrow.h"
#include "ar3d/algorithms/compact/placement.h"

namespace ar3d::compact {

/// What fill_narrow_strip does with RandomStream(seed, stream), with the same census, several times
/// faster.
std::optional<Placement> fill_narrow_strip_fast(const Decomposition& links, std::size_t num_edges,
                                                const Tightness& tightness, std::uint64_t seed,
                                                std::uint64_t stream, Census& census);

}  // namespace ar3d::compact
