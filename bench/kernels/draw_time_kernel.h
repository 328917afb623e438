#pragma once

namespace ar3d::kernels {

/// Registers time/ALGORITHM/FAMILY/N for every family that an algorithm draws.
void register_draw_times();

}  // namespace ar3d::kernels
