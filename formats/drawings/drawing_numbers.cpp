// The numbers of drawings that are no integers of 64 bits: decimals of programs, and values of real
// types.
#include <fmt/format.h>

#include <cstdlib>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/model/real_points.h"

namespace ar3d {
namespace {

constexpr int kMostDigits = 18;  // fit 63 bits
constexpr int kMostExponent = 1000;

/// Name, and bits of the significand.
using RealType = std::pair<std::string_view, unsigned>;
constexpr std::array<RealType, 5> kTypes{
    {{"float", 24}, {"double", 53}, {"binary80", 64}, {"binary128", 113}, {"reference", 237}}};

unsigned significant_bits(const BigInteger& value) {
  if (value == 0) return 0;
  const BigInteger size = boost::multiprecision::abs(value);
  return static_cast<unsigned>(msb(size) - lsb(size)) + 1;
}

void require_bits(const std::vector<BigPoint>& points, const char* what, RealType type) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const BigInteger& c : {points[i].x, points[i].y, points[i].z}) {
      const unsigned bits = significant_bits(c);
      if (bits <= type.second) continue;
      throw InputError(fmt::format("{} {} has a coordinate of {} significant bits, {} holds {}",
                                   what, i, bits, type.first, type.second));
    }
  }
}

}  // namespace

Decimal parse_decimal(const std::string& text) {
  const auto refuse = [&](const char* problem) {
    throw InputError(fmt::format("number {} {}", printable(text.substr(0, 60)), problem));
  };
  std::string digits;
  long exponent = 0;
  bool behind_point = false;
  std::size_t at = text.starts_with('-') ? 1 : 0;
  for (; at < text.size() && text[at] != 'e' && text[at] != 'E'; ++at) {
    if (text[at] == '.') {
      behind_point = true;
      continue;
    }
    digits += text[at];
    exponent -= behind_point ? 1 : 0;
  }
  if (at < text.size()) {
    const long given = std::strtol(text.c_str() + at + 1, nullptr, 10);
    if (given > kMostExponent || given < -kMostExponent) refuse("has an exponent beyond 1000");
    exponent += given;
  }
  const std::size_t last = digits.find_last_not_of('0');
  if (last == std::string::npos) return {};
  exponent += static_cast<long>(digits.size() - 1 - last);
  digits.erase(last + 1);
  digits.erase(0, digits.find_first_not_of('0'));
  if (digits.size() > kMostDigits) refuse("has more than 18 significant digits");
  const std::int64_t value = std::strtoll(digits.c_str(), nullptr, 10);
  return {text.starts_with('-') ? -value : value, static_cast<int>(exponent)};
}

std::int64_t scaled(const Decimal& number, int unit) {
  if (number.digits == 0) return 0;
  std::int64_t value = number.digits;
  for (int power = number.exponent; power > unit; --power) {
    if (value > kMaxCoordinate / 10 || value < -kMaxCoordinate / 10) {
      throw InputError(
          fmt::format("{}e{} in units of 1e{} passes 2^61: fewer decimals, or smaller numbers, fit",
                      number.digits, number.exponent, unit));
    }
    value *= 10;
  }
  return value;
}

void require_values_of_type(const RealPoints& points) {
  const auto* const type = std::find_if(kTypes.begin(), kTypes.end(), [&](const RealType& known) {
    return known.first == points.type;
  });
  if (type == kTypes.end()) {
    throw InputError(
        fmt::format("real type {} is none of float, double, binary80, binary128 and reference",
                    shown(points.type)));
  }
  require_bits(points.vertices, "vertex", *type);
  require_bits(points.bends, "bend", *type);
}

}  // namespace ar3d
