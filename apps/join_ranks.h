#pragma once

#include <memory>

#include "ar3d/bench/run/ranks.h"

namespace ar3d {

/// Returns the processes that mpirun has started; in the program that is not made for it, this
/// process alone.
std::unique_ptr<Ranks> join_ranks();

}  // namespace ar3d
