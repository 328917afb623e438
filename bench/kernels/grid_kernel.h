#pragma once

namespace ar3d::kernels {

/// Registers grid/size-of-FAMILY/N for every family that algorithm `grid` draws.
void register_grid_sizes();

}  // namespace ar3d::kernels
