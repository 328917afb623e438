// VTK PolyData as XML text: what ParaView opens; text, since its arrays are then readable by any
// tool.
#include "ar3d/formats/drawings/drawing_exports.h"

namespace ar3d {
namespace {

/// Writes the arrays of the file one after the other, as text.
class Arrays {
 public:
  explicit Arrays(OutputFile& output) : output_(output), out_(output.pending()) {}

  /// @param fill  adds the values.
  template <class Fill>
  void array(std::string_view type, std::string_view name, int components, Fill fill) {
    out_ += fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"ascii\">\n", type,
        name, components);
    fill();
    out_ += "</DataArray>\n";
  }
  template <class... Values>
  void add(Values... values) {
    ((fmt::format_to(std::back_inserter(out_), "{} ", values)), ...);
    out_ += '\n';
    output_.flush_if_full();
  }
  void tag(std::string_view text) { out_ += fmt::format("<{}>\n", text); }

 private:
  OutputFile& output_;
  std::string& out_;
};

void add_point_data(Arrays& arrays, const Drawing& drawing, std::uint64_t points) {
  const std::size_t n = drawing.num_vertices();
  arrays.tag("PointData");
  arrays.array("Int64", "vertex", 1, [&] {
    for (std::uint64_t i = 0; i < points; ++i)
      arrays.add(i < n ? static_cast<std::int64_t>(i) : -1);
  });
  arrays.array("Int64", "lattice", 3, [&] {
    for_each_export_point(drawing, [&](Point p) { arrays.add(p.x, p.y, p.z); });
  });
  arrays.tag("/PointData");
}

void add_cell_data(Arrays& arrays, const Drawing& drawing, const EdgeRoles& roles) {
  const std::size_t n = drawing.num_vertices();
  arrays.tag("CellData");
  arrays.array("Int64", "edge", 1, [&] {
    for (std::size_t v = 0; v < n; ++v) arrays.add(-1);
    for (EdgeId e = 0; e < drawing.num_edges(); ++e) arrays.add(e);
  });
  arrays.array("Int32", "role", 1, [&] {
    for (std::size_t v = 0; v < n; ++v) arrays.add(-1);
    for (EdgeId e = 0; e < drawing.num_edges(); ++e) arrays.add(int{roles.edges[e]});
  });
  arrays.array("UInt8", "colour", 3, [&] {
    const auto add = [&](Rgb c) { arrays.add(int{c[0]}, int{c[1]}, int{c[2]}); };
    for (std::size_t v = 0; v < n; ++v) add(kVertexColour);
    for (EdgeId e = 0; e < drawing.num_edges(); ++e) add(roles.roles[roles.edges[e]].second);
  });
  arrays.tag("/CellData");
}

void add_cells(Arrays& arrays, const Drawing& drawing) {
  const std::size_t n = drawing.num_vertices();
  arrays.tag("Verts");
  arrays.array("Int64", "connectivity", 1, [&] {
    for (std::size_t v = 0; v < n; ++v) arrays.add(v);
  });
  arrays.array("Int64", "offsets", 1, [&] {
    for (std::size_t v = 0; v < n; ++v) arrays.add(v + 1);
  });
  arrays.tag("/Verts");
  arrays.tag("Lines");
  arrays.array("Int64", "connectivity", 1, [&] {
    for_each_numbered_polyline(drawing, [&](EdgeId, const std::vector<std::uint64_t>& numbers) {
      for (const std::uint64_t number : numbers) arrays.add(number);
    });
  });
  arrays.array("Int64", "offsets", 1, [&] {
    std::uint64_t end = 0;
    for_each_numbered_polyline(drawing, [&](EdgeId, const std::vector<std::uint64_t>& numbers) {
      arrays.add(end += numbers.size());
    });
  });
  arrays.tag("/Lines");
}

}  // namespace

void write_vtp(OutputFile& output, const Drawing& drawing) {
  const std::uint64_t points = count_export_points(drawing, "vtp");
  const Embedding embed(drawing.lattice());
  output.append(fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece "
      "NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      points, drawing.num_vertices(), drawing.num_edges()));
  Arrays arrays(output);
  add_point_data(arrays, drawing, points);
  add_cell_data(arrays, drawing, edge_roles(drawing));
  arrays.tag("Points");
  arrays.array("Float64", "Points", 3, [&] {
    for_each_export_point(drawing, [&](Point p) {
      const Real3 q = embed(p);
      arrays.add(q.x, q.y, q.z);
    });
  });
  arrays.tag("/Points");
  add_cells(arrays, drawing);
  output.append("</Piece>\n</PolyData>\n</VTKFile>\n");
}

}  // namespace ar3d
