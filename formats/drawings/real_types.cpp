#include "real_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ar3d/base/error.h"
#include "ar3d/formats/text/text_input.h"

namespace ar3d {
namespace {

struct RealTypeName {
  const char* name;
  unsigned bits;  ///< of the significand
};
constexpr std::array<RealTypeName, 5> kTypes{
    {{"float", 24}, {"double", 53}, {"long double", 64}, {"binary128", 113}, {"reference", 237}}};

unsigned significant_bits(const BigInteger& value) {
  if (value == 0) return 0;
  const BigInteger size = boost::multiprecision::abs(value);
  return static_cast<unsigned>(msb(size) - lsb(size)) + 1;
}

void require_bits(const std::vector<BigPoint>& points, const char* what, RealTypeName type) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const BigInteger& c : {points[i].x, points[i].y, points[i].z}) {
      const unsigned bits = significant_bits(c);
      if (bits <= type.bits) continue;
      throw InputError(fmt::format("{} {} has a coordinate of {} significant bits, {} holds {}",
                                   what, i, bits, type.name, type.bits));
    }
  }
}

}  // namespace

void require_values_of_type(const RealPoints& points) {
  const auto* const type =
      std::find_if(kTypes.begin(), kTypes.end(),
                   [&](const RealTypeName& known) { return known.name == points.type; });
  if (type == kTypes.end()) {
    throw InputError(
        fmt::format("real type {} is none of float, double, long double, binary128 and reference",
                    shown(points.type)));
  }
  require_bits(points.vertices, "vertex", *type);
  require_bits(points.bends, "bend", *type);
}

}  // namespace ar3d
