// The points that a drawing can visit, and the symmetries of the box that map them to each other
// (Lemmas O.1 and O.5).
#include <algorithm>
#include <map>
#include <set>

#include "ar3d/optimum/encoding.h"

namespace ar3d::optimum {
namespace {

using GridPoint = std::array<int, 3>;

/// A symmetry of the box: coordinate i of the image is coordinate axis[i], counted from the other
/// side if it is flipped.
struct BoxSymmetry {
  std::array<std::size_t, 3> axis;
  std::array<bool, 3> flipped;

  GridPoint operator()(const GridPoint& p, const BoxSize& box) const {
    GridPoint image;
    for (std::size_t i = 0; i < 3; ++i) {
      image[i] = flipped[i] ? box[i] - 1 - p[axis[i]] : p[axis[i]];
    }
    return image;
  }
};

/// The signed permutations of the axes that map the box to itself.
std::vector<BoxSymmetry> symmetries_of(const BoxSize& box, bool keeps_z) {
  std::vector<BoxSymmetry> found;
  std::array<std::size_t, 3> axis = {0, 1, 2};
  do {
    const bool keeps_box = std::ranges::all_of(
        std::array<std::size_t, 3>{0, 1, 2}, [&](std::size_t i) { return box[axis[i]] == box[i]; });
    if (!keeps_box || (keeps_z && axis[2] != 2)) continue;
    for (unsigned flips = 0; flips < 8; ++flips) {
      found.push_back({axis, {(flips & 1) != 0, (flips & 2) != 0, (flips & 4) != 0}});
    }
  } while (std::ranges::next_permutation(axis).found);
  return found;
}

/// Body diagonals: p and p + (1, 1, 1) modulo 2; face diagonals: x + y + z modulo 2.
bool is_in_class(Diagonals diagonals, int number, const GridPoint& p) {
  if (diagonals == Diagonals::face) return (p[0] + p[1] + p[2] + number) % 2 == 0;
  const int x = (p[0] + (number & 1)) % 2;
  const int y = (p[1] + (number >> 1)) % 2;
  return x == y && y == p[2] % 2;
}

std::vector<GridPoint> points_of(Diagonals diagonals, int number, const BoxSize& box) {
  std::vector<GridPoint> points;
  for (int x = 0; x < box[0]; ++x) {
    for (int y = 0; y < box[1]; ++y) {
      for (int z = 0; z < box[2]; ++z) {
        if (is_in_class(diagonals, number, {x, y, z})) points.push_back({x, y, z});
      }
    }
  }
  return points;
}

PointClass make_class(Diagonals diagonals, int number, const BoxSize& box,
                      std::vector<GridPoint> points, const std::vector<BoxSymmetry>& symmetries) {
  PointClass result{box, number, std::move(points), {}, {}};
  std::map<GridPoint, int> index;
  for (const GridPoint& p : result.points) index.emplace(p, static_cast<int>(index.size()));
  const auto index_of = [&](const GridPoint& p) {
    const auto at = index.find(p);
    return at == index.end() ? -1 : at->second;
  };
  const std::vector<Vector> steps = steps_of(diagonals);
  for (const GridPoint& p : result.points) {
    std::vector<int>& near = result.neighbours.emplace_back();
    for (const Vector& d : steps) {
      near.push_back(index_of({p[0] + static_cast<int>(d.x), p[1] + static_cast<int>(d.y),
                               p[2] + static_cast<int>(d.z)}));
    }
  }
  for (const BoxSymmetry& symmetry : symmetries) {
    std::vector<int> images;
    for (const GridPoint& p : result.points) images.push_back(index_of(symmetry(p, box)));
    const bool keeps_class = std::ranges::find(images, -1) == images.end();
    if (keeps_class && !std::ranges::is_sorted(images)) result.symmetries.push_back(images);
  }
  return result;
}

}  // namespace

std::vector<PointClass> point_classes(const Question& question, const BoxSize& box) {
  const std::vector<BoxSymmetry> symmetries = symmetries_of(box, question.in_plane);
  std::vector<PointClass> classes;
  std::set<std::vector<GridPoint>> seen;  // all images of the classes so far
  for (int number = 0; number < (question.diagonals == Diagonals::body ? 4 : 2); ++number) {
    std::vector<GridPoint> points = points_of(question.diagonals, number, box);
    if (seen.contains(points)) continue;
    for (const BoxSymmetry& symmetry : symmetries) {
      std::vector<GridPoint> image;
      for (const GridPoint& p : points) image.push_back(symmetry(p, box));
      std::ranges::sort(image);
      seen.insert(std::move(image));
    }
    classes.push_back(make_class(question.diagonals, number, box, std::move(points), symmetries));
  }
  return classes;
}

}  // namespace ar3d::optimum
