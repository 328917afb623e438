#include "ar3d/results/hdf5/drawing_hdf5.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <utility>
#include <vector>

#include "ar3d/model/error.h"
#include "ar3d/results/atomic_file.h"
#include "ar3d/results/hdf5/hdf5_file.h"
#include "ar3d/results/hdf5/hdf5_rows.h"

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

void require_drawing(hid_t file) {
  const std::string format = read_text_attribute(file, "format");
  if (format != kFormat)
    throw Hdf5Error(fmt::format("its format is '{}', not '{}'", format, kFormat));
  const long long version = read_integer_attribute(file, "format_version");
  if (version != kVersion) {
    throw Hdf5Error(
        fmt::format("it has format version {}, this program reads version {}", version, kVersion));
  }
}

Lattice read_lattice(hid_t file) {
  Lattice lattice;
  const Hdf5Handle attribute(H5Aopen(file, "gram", H5P_DEFAULT), H5Aclose,
                             "open the attribute gram");
  const Hdf5Handle space(H5Aget_space(attribute.get()), H5Sclose, "read the shape of gram");
  const Hdf5Handle wanted = gram_space();
  if (H5Sextent_equal(space.get(), wanted.get()) <= 0) throw Hdf5Error("gram is not 3 x 3");
  hdf5_checked(H5Aread(attribute.get(), H5T_NATIVE_INT32, lattice.gram.data()), "read gram");
  const long long denominator = read_integer_attribute(file, "gram_denominator");
  if (denominator < 1 || denominator > std::numeric_limits<std::int32_t>::max()) {
    throw Hdf5Error(fmt::format("gram_denominator {} is not in 1..2^31-1", denominator));
  }
  lattice.gram_denominator = static_cast<std::int32_t>(denominator);
  lattice.validate();
  return lattice;
}

Point point_of(const std::int64_t* row, const char* dataset, std::uint64_t index) {
  const Point p{row[0], row[1], row[2]};
  if (!in_range(p)) {
    throw Hdf5Error(fmt::format("/{}[{}]: {} passes the largest coordinate {}", dataset, index,
                                to_string(p), kMaxCoordinate));
  }
  return p;
}

std::vector<Point> read_points(hid_t file, const char* name, std::uint64_t bytes) {
  const std::uint64_t rows = count_rows(file, name, 3, bytes);
  std::vector<Point> points;
  read_rows(file, name, rows, 3,
            [&](const std::int64_t* row) { points.push_back(point_of(row, name, points.size())); });
  return points;
}

std::vector<Edge> read_edges(hid_t file, std::uint64_t bytes, std::size_t vertices) {
  const std::uint64_t rows = count_rows(file, kEdges, 2, bytes);
  std::vector<Edge> edges;
  const auto vertex = [&](std::int64_t id) {
    if (id < 0 || static_cast<std::uint64_t>(id) >= vertices) {
      throw Hdf5Error(
          fmt::format("/edges[{}]: {} is no vertex, there are {}", edges.size(), id, vertices));
    }
    return static_cast<Vertex>(id);
  };
  read_rows(file, kEdges, rows, 2, [&](const std::int64_t* row) {
    edges.push_back({vertex(row[0]), vertex(row[1])});
  });
  return edges;
}

std::shared_ptr<StoredBends> read_bends(hid_t file, std::uint64_t bytes, std::size_t edges) {
  const std::vector<Point> points = read_points(file, kPoints, bytes);
  const std::uint64_t rows = count_rows(file, kOffsets, 1, bytes);
  if (rows != edges + 1) {
    throw Hdf5Error(fmt::format("/bends/offsets has {} rows for {} edges", rows, edges));
  }
  auto bends = std::make_shared<StoredBends>();
  std::vector<Point> of_edge;
  std::int64_t before = -1;
  read_rows(file, kOffsets, rows, 1, [&](const std::int64_t* row) {
    const bool first = before < 0;
    if (*row < before || *row > static_cast<std::int64_t>(points.size()) || (first && *row != 0)) {
      throw Hdf5Error(
          fmt::format("/bends/offsets: {} after {}, with {} bends", *row, before, points.size()));
    }
    if (!first) {
      of_edge.assign(points.begin() + before, points.begin() + *row);
      bends->add_edge(of_edge);
    }
    before = *row;
  });
  if (before != static_cast<std::int64_t>(points.size())) {
    throw Hdf5Error(
        fmt::format("/bends/offsets ends with {}, there are {} bends", before, points.size()));
  }
  return bends;
}

Drawing read_file(const std::string& path) {
  const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose, "open it");
  require_drawing(file.get());
  const std::uint64_t bytes = std::filesystem::file_size(path);
  const Lattice lattice = read_lattice(file.get());
  const std::vector<Point> points = read_points(file.get(), kVertices, bytes);
  auto edges = std::make_shared<std::vector<Edge>>(read_edges(file.get(), bytes, points.size()));
  auto bends = read_bends(file.get(), bytes, edges->size());
  Coordinates vertices(points.size(), kMaxCoordinate);
  for (std::size_t v = 0; v < points.size(); ++v) vertices.set(v, points[v]);
  return Drawing(read_text_attribute(file.get(), "algorithm"), lattice, std::move(vertices),
                 std::move(edges), std::move(bends));
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

Drawing read_drawing_hdf5(const std::string& path) {
  const Hdf5Silence silence;
  require_hdf5_file(path);
  try {
    return read_file(path);
  } catch (const Hdf5Error& error) {
    throw InputError(fmt::format("{} is not a readable drawing: {}", path, error.what()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} is not a readable drawing: {}", path, error.what()));
  }
}

}  // namespace ar3d
