#pragma once

namespace ar3d::kernels {

/// Registers the kernels of all catalogue rows. To be called from main(): the catalogues themselves
/// need initialised constants.
void register_catalogues();

}  // namespace ar3d::kernels
