#include <cstddef>
#include <cstdint>

#include "ar3d/formats/fuzz/check_drawings.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ar3d::fuzz::check_drawings({reinterpret_cast<const char*>(data), size});
  return 0;
}
