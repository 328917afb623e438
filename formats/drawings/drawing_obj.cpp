// Wavefront OBJ and PLY, as text.
#include "ar3d/formats/drawings/drawing_exports.h"

namespace ar3d {
namespace {

void append_point(std::string& out, Real3 p) {
  fmt::format_to(std::back_inserter(out), "v {} {} {}\n", p.x, p.y, p.z);
}

}  // namespace

void write_obj(OutputFile& output, const Drawing& drawing) {
  count_export_points(drawing, "obj");
  const Embedding embed(drawing.lattice());
  const EdgeRoles roles = edge_roles(drawing);
  std::string& out = output.pending();
  const std::size_t n = drawing.num_vertices();
  out += fmt::format("# ar3d, {}: vertices 0 to n - 1 are v 1 to {}\no vertices\n",
                     printable(drawing.algorithm()), n);
  for (std::size_t v = 0; v < n; ++v) {
    append_point(out, embed(drawing.vertex(static_cast<Vertex>(v))));
    output.flush_if_full();
  }
  if (n > 0) out += "p";
  for (std::size_t v = 1; v <= n; ++v) {
    fmt::format_to(std::back_inserter(out), " {}", v);
    output.flush_if_full();
  }
  out += "\n";
  std::uint64_t next = n + 1;
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    const Edge ends = drawing.edge(e);
    out += fmt::format("o edge_{}_{}\ng role_{}\n", ends.u, ends.v, roles.edges[e]);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) append_point(out, embed(points[i]));
    out += fmt::format("l {}", ends.u + 1);
    for (std::size_t i = 1; i + 1 < points.size(); ++i) out += fmt::format(" {}", next++);
    out += fmt::format(" {}\n", ends.v + 1);
    output.flush_if_full();
  });
}

void write_ply(OutputFile& output, const Drawing& drawing) {
  const std::uint64_t points = count_export_points(drawing, "ply");
  const Embedding embed(drawing.lattice());
  const EdgeRoles roles = edge_roles(drawing);
  const std::size_t n = drawing.num_vertices();
  const std::uint64_t segments = points - n + drawing.num_edges();
  std::string& out = output.pending();
  out += fmt::format(
      "ply\nformat ascii 1.0\ncomment ar3d, {}\nelement vertex {}\nproperty double x\nproperty "
      "double y\nproperty double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
      "property int number\nelement edge {}\nproperty int vertex1\nproperty int vertex2\nproperty "
      "uchar red\nproperty uchar green\nproperty uchar blue\nproperty int number\nend_header\n",
      printable(drawing.algorithm()), points, segments);
  const auto append = [&](Point p, Rgb c, std::int64_t number) {
    const Real3 q = embed(p);
    fmt::format_to(std::back_inserter(out), "{} {} {} {} {} {} {}\n", q.x, q.y, q.z, c[0], c[1],
                   c[2], number);
    output.flush_if_full();
  };
  for (std::size_t v = 0; v < n; ++v) {
    append(drawing.vertex(static_cast<Vertex>(v)), kVertexColour, static_cast<std::int64_t>(v));
  }
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& polyline) {
    for (std::size_t i = 1; i + 1 < polyline.size(); ++i) {
      append(polyline[i], colour_of(roles, e), -1);
    }
  });
  for_each_numbered_polyline(drawing, [&](EdgeId e, const std::vector<std::uint64_t>& numbers) {
    const Rgb c = colour_of(roles, e);
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      fmt::format_to(std::back_inserter(out), "{} {} {} {} {} {}\n", numbers[i - 1], numbers[i],
                     c[0], c[1], c[2], e);
    }
    output.flush_if_full();
  });
}

}  // namespace ar3d
