#include "ar3d/store/hdf5/drawing_hdf5.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/store/atomic_file.h"
#include "ar3d/store/hdf5/hdf5_file.h"
#include "ar3d/store/hdf5/hdf5_rows.h"

namespace ar3d {
namespace {

constexpr const char* kFormat = "ar3d-drawing";
constexpr long long kVersion = 1;
constexpr const char* kVertices = "vertices";
constexpr const char* kEdges = "edges";
constexpr const char* kOffsets = "bends/offsets";
constexpr const char* kPoints = "bends/points";

Hdf5Handle gram_space() {
  const hsize_t shape[2] = {3, 3};
  return {H5Screate_simple(2, shape, nullptr), H5Sclose, "shape an attribute"};
}

void write_gram(hid_t file, const Lattice& lattice) {
  const Hdf5Handle space = gram_space();
  const Hdf5Handle attribute(
      H5Acreate2(file, "gram", H5T_STD_I32LE, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
      "create an attribute");
  hdf5_checked(H5Awrite(attribute.get(), H5T_NATIVE_INT32, lattice.gram.data()),
               "write an attribute");
}

void put(std::int64_t* row, Point p) {
  row[0] = p.x;
  row[1] = p.y;
  row[2] = p.z;
}

/// Gives the bends of all edges one after the other.
class BendCursor {
 public:
  explicit BendCursor(const Drawing& drawing) : drawing_(drawing) {}
  /// Number of bends of the next edge.
  std::size_t next_edge() {
    drawing_.polyline(edge_++, points_);
    at_ = 1;
    return points_.size() - 2;
  }
  /// The next bend of any edge; there must be one.
  Point next_bend() {
    while (at_ + 1 >= points_.size()) next_edge();
    return points_[at_++];
  }

 private:
  const Drawing& drawing_;
  EdgeId edge_ = 0;
  std::vector<Point> points_;
  std::size_t at_ = 0;
};

void write_bends(hid_t file, const Drawing& drawing) {
  std::uint64_t bends = 0;
  BendCursor counting(drawing);
  bool first = true;
  write_rows(file, kOffsets, std::uint64_t{drawing.num_edges()} + 1, 1, [&](std::int64_t* row) {
    if (!std::exchange(first, false)) bends += counting.next_edge();
    *row = static_cast<std::int64_t>(bends);
  });
  BendCursor cursor(drawing);
  write_rows(file, kPoints, bends, 3, [&](std::int64_t* row) { put(row, cursor.next_bend()); });
}

std::vector<char> image_of(const Drawing& drawing) {
  const Hdf5Handle file = create_hdf5_in_memory();
  write_attribute(file.get(), "format", kFormat);
  write_attribute(file.get(), "format_version", kVersion);
  write_attribute(file.get(), "algorithm", drawing.algorithm());
  write_gram(file.get(), drawing.lattice());
  write_attribute(file.get(), "gram_denominator", drawing.lattice().gram_denominator);
  Vertex v = 0;
  write_rows(file.get(), kVertices, drawing.num_vertices(), 3,
             [&](std::int64_t* row) { put(row, drawing.vertex(v++)); });
  EdgeId e = 0;
  write_rows(file.get(), kEdges, drawing.num_edges(), 2, [&](std::int64_t* row) {
    const auto [from, to] = drawing.edge(e++);
    row[0] = from;
    row[1] = to;
  });
  write_bends(file.get(), drawing);
  return hdf5_image(file.get());
}

}  // namespace

void write_drawing_hdf5(const Drawing& drawing, const std::string& path) {
  const Hdf5Silence silence;
  try {
    write_file_atomically(path, image_of(drawing));
  } catch (const Hdf5Error& error) {
    throw InputError(fmt::format("cannot write {}: {}", path, error.what()));
  }
}

}  // namespace ar3d
