#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cfloat>
#include <cmath>
#include <type_traits>

namespace ar3d::two_bend_paper {

#ifdef __FAST_MATH__
#error \
    "the drawings of two-bend-paper tell what rounding does: they cannot be made with -ffast-math"
#endif
static_assert(FLT_EVAL_METHOD == 0, "every operation rounds to its own type (no x87 arithmetic)");

/// A significand of 113 bits; arithmetic by the compiler's support library.
__extension__ using Binary128 = __float128;

/// A significand of 237 bits: what the other types are measured against.
using Reference = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<237, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// The square root, rounded as the type's own functions do; that of Binary128 to within a unit in
/// the last place: Newton's method from 64 bits, twice.
template <class T>
T square_root(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::sqrt(value);
  } else if constexpr (std::is_same_v<T, Reference>) {
    return boost::multiprecision::sqrt(value);
  } else {
    if (!(value > 0)) return value;
    T root = static_cast<T>(std::sqrt(static_cast<long double>(value)));
    for (int i = 0; i < 2; ++i) root = (root + value / root) / 2;
    return root;
  }
}

template <class T>
struct Place {
  T x{};
  T y{};
};

template <class T>
struct Vector3 {
  T x{};
  T y{};
  T z{};

  friend Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {T(a.x + b.x), T(a.y + b.y), T(a.z + b.z)};
  }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) {
    return {T(a.x - b.x), T(a.y - b.y), T(a.z - b.z)};
  }
  friend Vector3 operator-(const Vector3& a) { return {T(-a.x), T(-a.y), T(-a.z)}; }
  friend Vector3 operator*(const T& k, const Vector3& a) {
    return {T(k * a.x), T(k * a.y), T(k * a.z)};
  }
};

template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return T(a.x * b.x + a.y * b.y + a.z * b.z);
}

template <class T>
Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {T(a.y * b.z - a.z * b.y), T(a.z * b.x - a.x * b.z), T(a.x * b.y - a.y * b.x)};
}

template <class T>
Vector3<T> unit(const Vector3<T>& a) {
  const T length = square_root(dot(a, a));
  return {T(a.x / length), T(a.y / length), T(a.z / length)};
}

}  // namespace ar3d::two_bend_paper
