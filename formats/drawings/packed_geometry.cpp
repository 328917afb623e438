// Bytes deflated, as text: the geometry of a drawing then takes a tenth of the same numbers as JSON.
#include <zlib.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/edge_roles.h"

namespace ar3d {

std::string packed_text(std::string_view text) {
  using boost::archive::iterators::base64_from_binary;
  using boost::archive::iterators::transform_width;
  using Digits = base64_from_binary<transform_width<const unsigned char*, 6, 8>>;
  uLongf size = compressBound(text.size());
  std::vector<unsigned char> zip(size + 2);  // two zeros to fill the last group
  const int status =
      compress(zip.data(), &size, reinterpret_cast<const Bytef*>(text.data()), text.size());
  expect(status == Z_OK, "zlib has room for what it writes");
  std::fill(zip.begin() + static_cast<std::ptrdiff_t>(size), zip.end(), 0);
  const std::size_t groups = (size + 2) / 3;
  std::string packed(Digits(zip.data()), Digits(zip.data() + 3 * groups));
  const std::size_t missing = 3 * groups - size;
  return packed.replace(packed.size() - missing, missing, missing, '=');
}

std::string packed_geometry(const Drawing& drawing, const EdgeRoles& roles, Point low) {
  return packed_text(geometry_numbers(drawing, roles, low));
}

}  // namespace ar3d
