#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "ar3d/model/drawing.h"
#include "ar3d/model/vector3.h"

namespace ar3d {

using BigInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                                 boost::multiprecision::et_off>;

using BigPoint = Vector3<BigInteger>;

/// The points of a drawing that was made in a real type. Every finite binary floating-point number
/// is a dyadic rational, so nothing is rounded here: a coordinate is an integer times
/// 2^unit_exponent. Cartesian: the squared length of (x, y, z) is x^2 + y^2 + z^2.
struct RealPoints {
  std::string type;  ///< that it was made in: "float", "double", ...
  int unit_exponent = 0;
  std::vector<BigPoint> vertices;
  std::vector<std::size_t> offsets{0};  ///< bends of edge e: bends[offsets[e]] ... [offsets[e + 1]]
  std::vector<BigPoint> bends;

  std::span<const BigPoint> bends_of(std::size_t edge) const {
    return std::span(bends).subspan(offsets[edge], offsets[edge + 1] - offsets[edge]);
  }
  friend bool operator==(const RealPoints&, const RealPoints&) = default;
};

/// value = integer * 2^exponent.
struct DyadicNumber {
  BigInteger integer;
  int exponent = 0;
};

/// The sum of finite doubles. @throws InternalError if one is not finite.
DyadicNumber dyadic_sum(std::span<const double> parts);

/// Gives all points a common unit, the coarsest possible.
class RealPointsBuilder {
 public:
  explicit RealPointsBuilder(std::string type) { points_.type = std::move(type); }

  using Point = std::array<DyadicNumber, 3>;
  /// Vertices in order of their numbers, edges in order of theirs.
  void add_vertex(Point point) { vertices_.push_back(std::move(point)); }
  void add_edge(std::vector<Point> bends);
  RealPoints finish() const;

 private:
  RealPoints points_;
  std::vector<Point> vertices_;
  std::vector<Point> bends_;
};

/// A drawing made in a real type. Its own integer points are a picture for viewers and exports:
/// the nearest multiples of a power of two, at most 2^-30, that lets all of them fit. Its exact
/// points are Drawing::real; the judge reads these.
/// @param edges  in the order of the bends of `points`.
/// @throws InputError if the numbers of vertices or edges do not fit.
Drawing real_drawing(std::string algorithm, std::shared_ptr<const std::vector<Edge>> edges,
                     RealPoints points);

}  // namespace ar3d
