// GraphML of a drawing: exact coordinates and bends as attributes, so that graph tools keep them.
#include "ar3d/formats/drawings/drawing_exports.h"

namespace ar3d {
namespace {

constexpr const char* kHead = R"(<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
<key id="algorithm" for="graph" attr.name="algorithm" attr.type="string"/>
<key id="gram" for="graph" attr.name="gram" attr.type="string"/>
<key id="name" for="node" attr.name="name" attr.type="string"/>
<key id="x" for="node" attr.name="x" attr.type="long"/>
<key id="y" for="node" attr.name="y" attr.type="long"/>
<key id="z" for="node" attr.name="z" attr.type="long"/>
<key id="bends" for="edge" attr.name="bends" attr.type="string"/>
<key id="role" for="edge" attr.name="role" attr.type="string"/>
<graph id="G" edgedefault="undirected">
)";

/// Rows, then the denominator: "1 0 0;0 1 0;0 0 1;/1".
std::string gram_text(const Lattice& lattice) {
  std::string text;
  for (const auto& row : lattice.gram) text += fmt::format("{} {} {};", row[0], row[1], row[2]);
  return text + fmt::format("/{}", lattice.gram_denominator);
}

}  // namespace

void write_graphml(OutputFile& output, const Drawing& drawing) {
  count_export_points(drawing, "graphml");
  const EdgeRoles roles = edge_roles(drawing);
  output.append(kHead);
  output.append(fmt::format("<data key=\"algorithm\">{}</data><data key=\"gram\">{}</data>\n",
                            xml_text(drawing.algorithm()), gram_text(drawing.lattice())));
  for (std::size_t v = 0; v < drawing.num_vertices(); ++v) {
    const Point p = drawing.vertex(static_cast<Vertex>(v));
    const std::string name =
        drawing.names ? fmt::format("<data key=\"name\">{}</data>", xml_text((*drawing.names)[v]))
                      : "";
    output.append(
        fmt::format("<node id=\"n{}\">{}<data key=\"x\">{}</data><data key=\"y\">{}</data><data "
                    "key=\"z\">{}</data></node>\n",
                    v, name, p.x, p.y, p.z));
  }
  for_each_polyline(drawing, [&](EdgeId e, const std::vector<Point>& points) {
    std::string bends;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      bends += fmt::format("{}{} {} {}", i > 1 ? ";" : "", points[i].x, points[i].y, points[i].z);
    }
    output.append(fmt::format(
        "<edge id=\"e{}\" source=\"n{}\" target=\"n{}\"><data key=\"bends\">{}</data><data "
        "key=\"role\">{}</data></edge>\n",
        e, drawing.edge(e).u, drawing.edge(e).v, bends,
        xml_text(roles.roles[roles.edges[e]].first)));
  });
  output.append("</graph>\n</graphml>\n");
}

}  // namespace ar3d
