#pragma once

#include <cmath>
#include <limits>
#include <string>

// Everything here has internal linkage: each source that includes it meets its own compiler flags.

namespace ar3d {
namespace {

/// Names long double by its bits, which machines differ in: 64 or 113 of the significand.
constexpr const char* kLongDouble =
    std::numeric_limits<long double>::digits == 64 ? "binary80" : "binary128";

// Functions of their own, so that the compiler meets them as it meets the drawing's.
template <class T>
[[gnu::noinline]] T product_minus(T a, T b, T c) {
  return a * b - c;
}

template <class T>
[[gnu::noinline]] T there_and_back(T a, T b) {
  return (a + b) - b;
}

template <class T>
[[gnu::noinline]] T product(T a, T b) {
  return a * b;
}

[[gnu::noinline]] bool equals_itself(double a) { return a == a; }

template <class T>
std::string departures_of(const char* type) {
  constexpr T kEps = std::numeric_limits<T>::epsilon();
  std::string found;
  const T a = 1 + kEps;
  if (product_minus<T>(a, a, product<T>(a, a)) != 0) found += " contraction";
  if (there_and_back<T>(kEps / 4, 1) != 0) found += " reordering";
  if (product_minus<T>(std::numeric_limits<T>::max(), 2, std::numeric_limits<T>::max()) <=
      std::numeric_limits<T>::max()) {
    found += " excess precision";
  }
  if (product<T>(std::numeric_limits<T>::min(), T(0.5)) == 0) found += " denormals";
  return found.empty() ? found : type + (":" + found) + ";";
}

/// Tells, by computing, how floating-point arithmetic departs from IEEE 754 where this header is
/// included: products and sums contracted to one rounding, sums reordered, more precision kept than
/// the type has, denormal numbers lost, NaN taken for a number. Empty if it does not.
[[maybe_unused]] std::string arithmetic_departures() {
  std::string found = departures_of<float>("float") + departures_of<double>("double") +
                      departures_of<long double>(kLongDouble);
  if (equals_itself(std::nan(""))) found += "NaN;";
  return found;
}

}  // namespace
}  // namespace ar3d
