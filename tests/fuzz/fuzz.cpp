// One target a format: AR3D_FUZZ_FORMAT is its name; empty: whichever is detected; "drawing":
// drawings.
#include <cstddef>
#include <cstdint>
#include <string>

#include "checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string format = AR3D_FUZZ_FORMAT;
  std::string text(reinterpret_cast<const char*>(data), size);
  if (format == "drawing") {
    ar3d::fuzz::check_drawings(std::move(text));
  } else {
    ar3d::fuzz::check_graphs(format, std::move(text));
  }
  return 0;
}
