#pragma once

namespace ar3d::kernels {

/// Registers grid/size-of-FAMILY/N for every family that algorithm `grid` draws.
void register_grid_sizes();
/// Registers grid/time/FAMILY/N likewise.
void register_grid_times();

}  // namespace ar3d::kernels
