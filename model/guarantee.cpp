// Decides exactly whether an extent keeps a bound: where the bound has a root, both sides are
// squared, in integers wide enough for every n.
#include "ar3d/model/guarantee.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"

namespace ar3d {
namespace {

/// n^(half_power / 2); empty for 0.
std::string power_text(unsigned half_power) {
  if (half_power == 0) return "";
  if (half_power == 1) return "sqrt(n)";
  if (half_power == 2) return "n";
  return half_power % 2 == 0 ? fmt::format("n^{}", half_power / 2)
                             : fmt::format("n^({}/2)", half_power);
}

}  // namespace

bool AxisBound::holds(std::int64_t extent, std::uint64_t n) const {
  // Widths: n^18 < 2^576, numerator^2 < 2^126; extent terms below 2^256. All fit 1024 bits, and are
  // checked.
  using Wide = boost::multiprecision::checked_int1024_t;
  expect(half_power <= 18 && n < (std::uint64_t{1} << 32),
         "an axis bound stays in its proved range");
  const Wide left = Wide(denominator) * (Wide(extent) - Wide(constant));
  if (left <= 0) return true;
  if (half_power % 2 == 0)
    return left <= Wide(numerator) * boost::multiprecision::pow(Wide(n), half_power / 2);
  return left * left <=
         Wide(numerator) * Wide(numerator) * boost::multiprecision::pow(Wide(n), half_power);
}

double AxisBound::value(std::uint64_t n) const {
  return static_cast<double>(numerator) / static_cast<double>(denominator) *
             std::pow(static_cast<double>(n), half_power / 2.0) +
         static_cast<double>(constant);
}

std::string AxisBound::formula() const {
  const std::string factor = denominator == 1 ? fmt::format("{}", numerator)
                                              : fmt::format("{}/{}", numerator, denominator);
  const std::string power = power_text(half_power);
  std::string text = power.empty()   ? factor
                     : factor == "1" ? power
                                     : fmt::format("{} {}", factor, power);
  if (constant > 0) text += fmt::format(" + {}", constant);
  if (constant < 0) text += fmt::format(" - {}", -constant);
  return text;
}

bool SizeBound::promises_box() const {
  return std::any_of(axes.begin(), axes.end(),
                     [](const AxisBound& axis) { return axis.numerator != 0; });
}

bool SizeBound::holds(const std::array<std::int64_t, 3>& extents, std::uint64_t n) const {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!axes[axis].holds(extents[axis], n)) return false;
  }
  return true;
}

std::string SizeBound::formula() const {
  return fmt::format("{}, {}, {} ({}, {})", axes[0].formula(), axes[1].formula(), axes[2].formula(),
                     name, source);
}

std::string to_string(CertificateMode mode) {
  return mode == CertificateMode::exact ? "exact" : "none";
}

CertificateMode parse_certificate_mode(std::string_view text) {
  for (const CertificateMode mode : {CertificateMode::exact, CertificateMode::none}) {
    if (text == to_string(mode)) return mode;
  }
  throw InputError(fmt::format("certificate '{}' is none of exact and none{}",
                               printable(std::string(text)),
                               did_you_mean(text, {"exact", "none"})));
}

}  // namespace ar3d
