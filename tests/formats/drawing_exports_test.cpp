// Exports are read back: positions, numbers, edges and roles are those of the drawing.
#include "ar3d/formats/drawings/drawing_exports.h"

#include <array>
#include <cstring>
#include <map>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/edge_roles.h"
#include "ar3d/formats/drawings/embedding.h"
#include "ar3d/generators/catalog.h"
#include "support/problem.h"
#include "support/program.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

Drawing drawing_of(const char* algorithm, std::uint64_t n = 60) {
  const char* family =
      find_algorithm(algorithm).guarantee.max_degree == 4 ? "random-4-regular" : "random-cubic";
  return draw(find_algorithm(algorithm), generate(find_family(family), n, 3));
}

const std::array<const char*, 4> kAll = {"diamond", "compact", "grid", "two-bend"};

template <class Write>
std::string written(Write write) {
  const ScratchDirectory scratch;
  OutputFile file(scratch.path("x"));
  write(file);
  file.commit();
  return read_file(scratch.path("x"));
}

TEST(Exports, GraphmlIsTheGraph) {
  const ScratchDirectory scratch;
  for (const char* algorithm : kAll) {
    const Drawing drawing = drawing_of(algorithm);
    const std::string path = scratch.write(
        "x.graphml", written([&](OutputFile& file) { write_graphml(file, drawing); }));
    const Graph graph = read_graph(path);
    ASSERT_EQ(graph.num_vertices(), drawing.num_vertices());
    ASSERT_EQ(graph.num_edges(), drawing.num_edges());
    const std::string text = read_file(path);
    std::vector<Point> points;
    drawing.polyline(7, points);
    const auto coordinate = [](const char* key, std::int64_t value) {
      return std::string("<data key=\"") + key + "\">" + std::to_string(value) + "</data>";
    };
    EXPECT_THAT(text, HasSubstr("<node id=\"n" + std::to_string(drawing.edge(7).u) + "\">" +
                                coordinate("x", points[0].x) + coordinate("y", points[0].y) +
                                coordinate("z", points[0].z)));
    std::string bends;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      bends += (i > 1 ? ";" : "") + std::to_string(points[i].x) + " " +
               std::to_string(points[i].y) + " " + std::to_string(points[i].z);
    }
    EXPECT_THAT(text, HasSubstr("<data key=\"bends\">" + bends + "</data>"));
  }
}

using Corner = std::array<float, 3>;
using Face = std::array<Corner, 3>;

std::vector<Face> faces_of_stl(const std::string& file) {
  std::uint32_t count = 0;
  std::memcpy(&count, file.data() + 80, 4);
  EXPECT_EQ(file.size(), 84 + 50 * std::size_t{count});
  std::vector<Face> faces(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(faces[i].data(), file.data() + 84 + 50 * i + 12, sizeof(Face));
  }
  return faces;
}

/// Six times the volume that the faces enclose: positive if their normals point outwards.
double volume6(const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& f : faces) {
    const auto real = [](const Corner& c) { return Real3{c[0], c[1], c[2]}; };
    sum += dot(real(f[0]), cross(real(f[1]), real(f[2])));
  }
  return sum;
}

TEST(Exports, StlIsWatertight) {
  for (const char* algorithm : kAll) {
    const Drawing drawing = drawing_of(algorithm, 20);
    const auto faces =
        faces_of_stl(written([&](OutputFile& file) { write_stl(file, drawing, 0.2); }));
    std::map<std::pair<Corner, Corner>, int> edges;
    for (const Face& f : faces) {
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_NE(f[i], f[(i + 1) % 3]) << "no triangle is a line";
        ++edges[{f[i], f[(i + 1) % 3]}];
      }
    }
    for (const auto& [edge, count] : edges) {
      ASSERT_EQ(count, 1) << algorithm;
      ASSERT_EQ(edges.count({edge.second, edge.first}), 1u) << algorithm;
    }
    // A prism of 12 sides has 12 sin(30 degrees) / 2 = 3 r^2 of area; the balls add theirs.
    double tubes = 0;
    const Embedding embed(drawing.lattice());
    for_each_polyline(drawing, [&](EdgeId, const std::vector<Point>& line) {
      for (std::size_t i = 1; i < line.size(); ++i) tubes += length(embed(line[i] - line[i - 1]));
    });
    const double balls = 20 * 4.0 / 3 * 3.14159 * std::pow(0.44, 3);
    EXPECT_NEAR(volume6(faces) / 6, tubes * 3 * 0.04 + balls, 0.02 * tubes * 0.12 + 0.2 * balls);
  }
}

template <class Write>
std::string refusal_of(Write write) {
  return problem([&] { written(write); }, "nothing is refused");
}

Drawing segment(Point a, Point b, const std::vector<Point>& bends = {}) {
  return Draft{{a, b}, {{{0, 1}, bends}}}.drawing();
}

TEST(Exports, RefuseWhatTheFormatCannotHold) {
  const auto stl = [](const Drawing& drawing, double radius = 0.2) {
    return refusal_of([&, radius](OutputFile& file) { write_stl(file, drawing, radius); });
  };
  EXPECT_EQ(stl(segment({}, {0, 65537, 0})), "an extent of 65537, stl holds at most 65536");
  EXPECT_THAT(stl(segment({}, {0, 0, 0})), HasSubstr("length 0"));
  EXPECT_THAT(stl(segment({}, {1, 0, 0}, {{2, 0, 0}})), HasSubstr("turns back"));
  EXPECT_THAT(stl(segment({}, {3, 1, 0}, {{3, 0, 0}}), 2), HasSubstr("too short for its bends"));
  EXPECT_EQ(refusal_of([](OutputFile& file) {
              write_glb(file, segment({}, {1 << 25, 0, 0}));
            }),
            "an extent of 33554432, glb holds at most 16777216");
}

}  // namespace
}  // namespace ar3d::testing
