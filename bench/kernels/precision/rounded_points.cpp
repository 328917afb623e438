#include "rounded_points.h"

#include <vector>

namespace ar3d::precision {
namespace {

using boost::multiprecision::abs;
using boost::multiprecision::msb;

BigInteger rounded(const BigInteger& value, int bits) {
  const BigInteger size = abs(value);
  if (size == 0) return value;
  const int drop = static_cast<int>(msb(size)) + 1 - bits;
  if (drop <= 0) return value;
  const BigInteger half = BigInteger(1) << (drop - 1);
  const BigInteger result = ((size + half) >> drop) << drop;
  return value < 0 ? BigInteger(-result) : result;
}

}  // namespace

RealPoints in_bits(RealPoints points, int bits) {
  for (std::vector<BigPoint>* list : {&points.vertices, &points.bends}) {
    for (BigPoint& p : *list) p = {rounded(p.x, bits), rounded(p.y, bits), rounded(p.z, bits)};
  }
  return points;
}

}  // namespace ar3d::precision
