// Differences of successive points as integers of 7 bits a byte, deflated: a tenth of the same
// numbers as JSON.
#include "ar3d/formats/drawings/packed_geometry.h"

#include <zlib.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include "ar3d/base/error.h"

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
  std::string out;
  const auto add = [&](std::uint64_t value) {
    for (; value >= 128; value >>= 7) out.push_back(static_cast<char>(value | 128));
    out.push_back(static_cast<char>(value));
  };
  const auto add_signed = [&](std::int64_t value) {
    add(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
  };
  const auto add_vector = [&](Vector d) {
    add_signed(d.x);
    add_signed(d.y);
    add_signed(d.z);
  };
  Point last = low;
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    const Point p = drawing.vertex(static_cast<Vertex>(v));
    add_vector(p - last);
    last = p;
  }
  std::int64_t last_u = 0;
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    const Edge ends = drawing.edge(e);
    add_signed(std::int64_t{ends.u} - last_u);
    last_u = ends.u;
    add_signed(std::int64_t{ends.v} - last_u);
    add(points.size() - 2);
    add(roles.edges[e]);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) add_vector(points[i] - points[i - 1]);
  });
  return packed_text(out);
}

}  // namespace ar3d
