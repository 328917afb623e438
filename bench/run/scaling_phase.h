#pragma once

#include "ar3d/bench/run/making.h"

namespace ar3d {

/// The last phase of a study, strong and weak scaling: batches of the same drawing shared by 1, ...
/// threads or ranks. The ideal of a batch is the one on a single thread or rank of the same round:
/// its time divided by how many share (strong) or its time (weak). Threads are pinned, each to a
/// core of its own, if there are so many; ranks stay where mpirun has put them.
void run_batches(Making& making);

}  // namespace ar3d
