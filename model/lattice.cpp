// Exact angles on a lattice. The cosine is compared by squares, in 128 bits where these are proved
// enough and in 1024 bits elsewhere.
#include "ar3d/model/lattice.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <initializer_list>
#include <numeric>

#include "ar3d/base/error.h"
#include "ar3d/model/cosine_comparison.h"

namespace ar3d {
namespace {

using Wide = boost::multiprecision::checked_int1024_t;
__extension__ using Int128 = __int128;

/// Bits of the largest absolute value, which is below 2^bits.
int bits(std::initializer_list<std::int64_t> values) {
  std::uint64_t all = 0;
  for (const std::int64_t v : values) {
    all |= v < 0 ? std::uint64_t{0} - static_cast<std::uint64_t>(v) : static_cast<std::uint64_t>(v);
  }
  return static_cast<int>(std::bit_width(all));
}

/// Does __int128 hold every value of compare()? With components of u, v below 2^a, 2^b and Gram
/// entries below 2^g, the nine terms of an inner product of these two are below 2^(a + b + g) each,
/// so its square, and the product of both squared lengths, is below 81 * 2^(2 (a + b + g)); times a
/// squared cosine term below 2^(2 c), and 81 < 2^7.
bool fits_int128(const Lattice& lattice, Vector u, Vector v, Cosine cosine) {
  int g = 0;
  for (const auto& row : lattice.gram) g = std::max(g, bits({row[0], row[1], row[2]}));
  const int c = bits({cosine.numerator, cosine.denominator});
  const int a = bits({u.x, u.y, u.z});
  const int b = bits({v.x, v.y, v.z});
  return 2 * (a + b + g + c) + 7 <= 127 && 2 * std::max(a, b) + g + 4 <= 127;
}

}  // namespace

std::string to_string(Point p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }
std::string to_string(Vector d) { return fmt::format("({}, {}, {})", d.x, d.y, d.z); }

Vector primitive(Vector d) {
  const std::int64_t g = std::gcd(std::gcd(d.x, d.y), d.z);
  return g <= 1 ? d : Vector{d.x / g, d.y / g, d.z / g};
}

void Lattice::validate() const {
  if (gram_denominator <= 0) {
    throw InputError(fmt::format("gram_denominator is {}, it must be positive", gram_denominator));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (gram[i][j] != gram[j][i]) throw InputError("the Gram matrix is not symmetric");
    }
  }
  const auto g = [&](std::size_t i, std::size_t j) { return Wide(gram[i][j]); };
  const Wide minor = g(0, 0) * g(1, 1) - g(0, 1) * g(1, 0);
  const Wide determinant = g(0, 0) * (g(1, 1) * g(2, 2) - g(1, 2) * g(2, 1)) -
                           g(0, 1) * (g(1, 0) * g(2, 2) - g(1, 2) * g(2, 0)) +
                           g(0, 2) * (g(1, 0) * g(2, 1) - g(1, 1) * g(2, 0));
  if (gram[0][0] <= 0 || minor <= 0 || determinant <= 0) {
    throw InputError("the Gram matrix is not positive definite");
  }
}

std::strong_ordering compare_cosine(const Lattice& lattice, Vector u, Vector v, Cosine c) {
  using cosine_comparison::compare;
  using cosine_comparison::converted;
  if (fits_int128(lattice, u, v, c)) {
    return compare(lattice, converted<Int128>(u), converted<Int128>(v), c);
  }
  const Vector p = primitive(u);
  const Vector q = primitive(v);
  if (fits_int128(lattice, p, q, c)) {
    return compare(lattice, converted<Int128>(p), converted<Int128>(q), c);
  }
  return compare(lattice, converted<Wide>(p), converted<Wide>(q), c);
}

double approximate_square(const Lattice& lattice, Vector u) {
  const double a[3] = {static_cast<double>(u.x), static_cast<double>(u.y),
                       static_cast<double>(u.z)};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) sum += a[i] * lattice.gram[i][j] * a[j];
  }
  return sum;
}

}  // namespace ar3d
