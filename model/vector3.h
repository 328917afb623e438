#pragma once

namespace ar3d {

/// A point or vector in space, in any type of numbers; lattice.h has those of lattices.
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
  friend bool operator==(const Vector3&, const Vector3&) = default;
};

template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return T(a.x * b.x + a.y * b.y + a.z * b.z);
}

template <class T>
Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {T(a.y * b.z - a.z * b.y), T(a.z * b.x - a.x * b.z), T(a.x * b.y - a.y * b.x)};
}

}  // namespace ar3d
