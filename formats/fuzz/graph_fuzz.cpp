// AR3D_FUZZ_FORMAT is the format's name; empty: whichever is detected.
#include "ar3d/formats/fuzz/check_graphs.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ar3d::fuzz::check_graphs(AR3D_FUZZ_FORMAT, {reinterpret_cast<const char*>(data), size});
  return 0;
}
