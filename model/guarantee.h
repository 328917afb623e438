#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/model/lattice.h"

namespace ar3d {

/// extent <= (numerator / denominator) * n^(half_power / 2) + constant, decided exactly. Written
/// linear(16, 3) for 16n/3 and sqrt_n(726) + 1800 for 726 sqrt(n) + 1800.
struct AxisBound {
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  unsigned half_power =
      2;  ///< twice the exponent of n, at most 18: 1 for sqrt(n), 2 for n, 4 for n^2
  std::int64_t constant = 0;

  /// Exact; n < 2^32, extent >= 0.
  bool holds(std::int64_t extent, std::uint64_t n) const;
  /// The bound's value, rounded, for plots and slack.
  double value(std::uint64_t n) const;
  /// "16/3 n", "8 n", "12 n^2 + 7", … for people.
  std::string formula() const;
};

inline constexpr AxisBound sqrt_n(std::int64_t numerator, std::int64_t denominator = 1) {
  return {numerator, denominator, 1, 0};
}
inline constexpr AxisBound linear(std::int64_t numerator, std::int64_t denominator = 1) {
  return {numerator, denominator, 2, 0};
}
inline constexpr AxisBound quadratic(std::int64_t numerator, std::int64_t denominator = 1) {
  return {numerator, denominator, 4, 0};
}
inline constexpr AxisBound cubic(std::int64_t numerator, std::int64_t denominator = 1) {
  return {numerator, denominator, 6, 0};
}
inline constexpr AxisBound operator+(AxisBound bound, std::int64_t constant) {
  bound.constant += constant;
  return bound;
}

/// Extents (largest minus smallest coordinate) per axis in terms of the input's number n >= 1 of
/// vertices.
struct SizeBound {
  std::string name;    ///< "proved here", "paper"
  std::string source;  ///< theorem or section
  std::array<AxisBound, 3> axes;
  bool holds(const std::array<std::int64_t, 3>& extents, std::uint64_t n) const;
  /// False if no axis grows with n: nothing is promised of the box or, by a program of a study's
  /// own, only what integers can hold.
  bool promises_box() const;
  /// "16/3 n, 16/3 n, 8 n (proved here, docs/theorem1.md)"
  std::string formula() const;
};

/// Says which angles a guarantee promises between consecutive segments and between any two segments
/// at a vertex.
enum class AngleRule {
  exactly,   ///< every one of them is arccos(cosine)
  at_least,  ///< none of them is smaller (three at a vertex then are exactly 120 degrees for cosine
             ///< = -1/2)
};

/// Says what a drawing is held to.
enum class Claim {
  proved,    ///< every drawing keeps the whole guarantee: one that does not is violated
  measured,  ///< angles and crossings hold in exact arithmetic only: drawings are made in real
             ///< types, which round, and what they miss is measured; no box is promised
  nothing,   ///< drawings are measured and not judged
};

/// Says how a drawing is judged: by a proof in integers, or not at all.
enum class CertificateMode : std::uint8_t { exact, none };
/// "exact", "none".
std::string to_string(CertificateMode mode);
/// @throws InputError naming the text if it is neither.
CertificateMode parse_certificate_mode(std::string_view text);

/// Holds what a theorem promises about every drawing; plain data that tests, study, verifier and
/// report read.
struct Guarantee {
  Claim claim = Claim::proved;
  std::uint32_t max_degree = 0;  ///< inputs of larger degree are refused
  std::uint32_t max_bends = 0;   ///< per edge
  AngleRule angle_rule = AngleRule::exactly;
  Cosine cosine;
  Lattice lattice;
  std::vector<Vector> directions = {};    ///< allowed segment directions up to sign; empty: any
  bool vertices_in_plane = false;         ///< all vertices have z = 0
  SizeBound bound = {};                   ///< holds for every input; all zero if none is promised
  std::vector<SizeBound> published = {};  ///< bounds of others, for comparison only
};

}  // namespace ar3d
