#pragma once

#include <vector>

#include "ar3d/optimum/question.h"

namespace ar3d::optimum {

/// Holds the points of a box that one connected drawing can visit (Lemma O.1). Steps are numbered
/// as steps_of() gives them.
struct PointClass {
  BoxSize box{};
  int number = 0;                            ///< of the class: 0 to 3, or 0 to 1
  std::vector<std::array<int, 3>> points;    ///< ascending
  std::vector<std::vector<int>> neighbours;  ///< [point][step], -1 outside of the box
  /// Images of all points under each symmetry of the box that keeps the class (and the z axis if
  /// vertices are in a plane), except the identity.
  std::vector<std::vector<int>> symmetries;
};

/// Returns the classes of a box, none the image of another under a symmetry of the box. The plane
/// of a question with one is across the z axis. O(points * 48).
std::vector<PointClass> point_classes(const Question& question, const BoxSize& box);

}  // namespace ar3d::optimum
