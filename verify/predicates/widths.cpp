// The range check (Lemma V.5 of docs/verify.md).
#include "ar3d/verify/predicates/widths.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdlib>

namespace ar3d::verify {
namespace {

using Wide = boost::multiprecision::checked_uint1024_t;  // all values are below 2^512

int bits_of(const Wide& value) {
  return value == 0 ? 0 : static_cast<int>(boost::multiprecision::msb(value)) + 1;
}

std::array<Wide, 3> sides(const Reach& reach) { return {reach.x, reach.y, reach.z}; }

std::uint64_t magnitude(std::int32_t value) {
  return static_cast<std::uint64_t>(std::abs(std::int64_t{value}));
}

Wide largest_square(Cosine c) {
  const Wide largest = std::max(magnitude(c.numerator), magnitude(c.denominator));
  return largest * largest;
}

int angle_bits(const Reach& reach, const Lattice& lattice, Cosine cosine) {
  const auto side = sides(reach);
  Wide inner = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inner += magnitude(lattice.gram[i][j]) * side[i] * side[j];
  }
  return bits_of(inner * inner * largest_square(cosine));
}

int meeting_bits(const Reach& segments, const Reach& between) {
  const auto u = sides(segments);
  const auto w = sides(between);
  Wide triple = 0, products = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    triple += 2 * w[i] * u[j] * u[k];
    products = std::max({products, Wide(2 * u[j] * u[k]), Wide(w[j] * u[k] + w[k] * u[j]), w[i]});
  }
  return bits_of(std::max(triple, products));
}

int height_bits(const Reach& reach) { return bits_of(Wide(reach.z) * std::max(reach.x, reach.y)); }

}  // namespace

PredicateBits predicate_bits(const Reach& segments, const Reach& between, const Lattice& lattice,
                             Cosine cosine) {
  return {angle_bits(segments, lattice, cosine), meeting_bits(segments, between),
          height_bits(segments)};
}

PredicateBits predicate_bits(const Reach& segments, const Lattice& lattice, Cosine cosine) {
  const Reach between{2 * segments.x, 2 * segments.y, 2 * segments.z};
  return predicate_bits(segments, between, lattice, cosine);
}

/// With components of u, v below 2^a, 2^b and S the sum of all |gram_ij|, <u,v>^2 and <u,u> <v,v>
/// are below S^2 4^(a + b), and so is every value before them, as a and b are at least 1.
AngleComparison::AngleComparison(const Lattice& lattice, Cosine cosine)
    : lattice_(lattice), cosine_(cosine) {
  Wide sum = 0;
  for (const auto& row : lattice.gram) {
    for (const std::int32_t entry : row) sum += magnitude(entry);
  }
  room_ = (kInt64Bits - bits_of(sum * sum * largest_square(cosine))) / 2;
}

}  // namespace ar3d::verify
