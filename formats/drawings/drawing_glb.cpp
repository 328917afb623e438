// glTF 2.0, binary: the JSON of the scene and one buffer with everything that it describes.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ar3d/base/printable.h"
#include "ar3d/formats/drawings/drawing_exports.h"

namespace ar3d {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUint = 5125;                  // component types
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;  // targets
constexpr int kPoints = 0, kLines = 1;                      // modes of primitives

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

/// The binary part, with the views and accessors that describe it.
struct Buffer {
  std::string bytes;
  Json views = Json::array();
  Json accessors = Json::array();

  template <class Number>
  int add(const std::vector<Number>& values, int components, int target, const Json& limits = {}) {
    views.push_back({{"buffer", 0},
                     {"byteOffset", bytes.size()},
                     {"byteLength", values.size() * sizeof(Number)},
                     {"target", target}});
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number));
    Json accessor = {{"bufferView", views.size() - 1},
                     {"componentType", target == kIndexBuffer ? kUint : kFloat},
                     {"count", values.size() / static_cast<std::size_t>(components)},
                     {"type", components == 3 ? "VEC3" : "SCALAR"}};
    if (!limits.is_null()) accessor.update(limits);
    accessors.push_back(std::move(accessor));
    return static_cast<int>(accessors.size() - 1);
  }
};

int add_positions(Buffer& buffer, const Drawing& drawing, Point low) {
  const Embedding embed(drawing.lattice());
  std::vector<float> values;
  std::array<float, 3> least{}, most{};
  for_each_export_point(drawing, [&](Point p) {
    const Real3 q = embed(p - low);
    const std::array<float, 3> position = {static_cast<float>(q.x), static_cast<float>(q.y),
                                           static_cast<float>(q.z)};
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = values.empty() ? position[i] : std::min(least[i], position[i]);
      most[i] = values.empty() ? position[i] : std::max(most[i], position[i]);
    }
    values.insert(values.end(), position.begin(), position.end());
  });
  return buffer.add(values, 3, kVertexBuffer, {{"min", least}, {"max", most}});
}

int add_numbers(Buffer& buffer, const Drawing& drawing, std::uint64_t points, bool of_edges) {
  std::vector<float> values(points, -1);
  if (!of_edges) {
    for (std::size_t v = 0; v < drawing.num_vertices(); ++v) values[v] = static_cast<float>(v);
  } else {
    for_each_numbered_polyline(drawing, [&](EdgeId e, const std::vector<std::uint64_t>& numbers) {
      for (std::size_t i = 1; i + 1 < numbers.size(); ++i) {
        values[numbers[i]] = static_cast<float>(e);
      }
    });
  }
  return buffer.add(values, 1, kVertexBuffer);
}

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Json material(const std::string& name, Rgb c) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {linear(c[0]), linear(c[1]), linear(c[2]), 1.0}}}},
          {"extensions", {{"KHR_materials_unlit", Json::object()}}}};
}

/// One primitive of points, and one of lines for each role that occurs.
Json primitives(Buffer& buffer, const Drawing& drawing, const EdgeRoles& roles,
                const Json& attributes) {
  std::vector<std::vector<std::uint32_t>> lines(roles.roles.size());
  for_each_numbered_polyline(drawing, [&](EdgeId e, const std::vector<std::uint64_t>& numbers) {
    for (std::size_t i = 1; i < numbers.size(); ++i) {
      lines[roles.edges[e]].push_back(static_cast<std::uint32_t>(numbers[i - 1]));
      lines[roles.edges[e]].push_back(static_cast<std::uint32_t>(numbers[i]));
    }
  });
  std::vector<std::uint32_t> vertices(drawing.num_vertices());
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v] = static_cast<std::uint32_t>(v);
  Json list = Json::array();
  list.push_back({{"attributes", attributes},
                  {"indices", buffer.add(vertices, 1, kIndexBuffer)},
                  {"mode", kPoints},
                  {"material", roles.roles.size()}});
  for (std::size_t role = 0; role < lines.size(); ++role) {
    if (lines[role].empty()) continue;
    list.push_back({{"attributes", attributes},
                    {"indices", buffer.add(lines[role], 1, kIndexBuffer)},
                    {"mode", kLines},
                    {"material", role}});
  }
  return list;
}

void append_word(std::string& out, std::size_t value) {
  const auto word = static_cast<std::uint32_t>(value);
  out.append(reinterpret_cast<const char*>(&word), 4);
}

void append_chunk(OutputFile& output, std::string bytes, const char* type, char padding) {
  bytes.resize((bytes.size() + 3) / 4 * 4, padding);
  std::string head;
  append_word(head, bytes.size());
  output.append(head + std::string(type, 4));
  output.append(bytes);
}

}  // namespace

void write_glb(OutputFile& output, const Drawing& drawing) {
  const std::uint64_t points = count_export_points(drawing, "glb");
  refuse_larger_extents(drawing, std::int64_t{1} << 24, "glb");
  if (drawing.num_vertices() == 0) throw InputError("glb holds no drawing without vertices");
  const EdgeRoles roles = edge_roles(drawing);
  const Point low = bounding_box(drawing).low;
  Buffer buffer;
  const Json attributes = {{"POSITION", add_positions(buffer, drawing, low)},
                           {"_VERTEX", add_numbers(buffer, drawing, points, false)},
                           {"_EDGE", add_numbers(buffer, drawing, points, true)}};
  const Json mesh = primitives(buffer, drawing, roles, attributes);
  Json materials = Json::array();
  for (const auto& [name, colour] : roles.roles) materials.push_back(material(name, colour));
  materials.push_back(material("vertex", kVertexColour));
  const std::string json = Json({{"asset", {{"version", "2.0"}, {"generator", "ar3d"}}},
                                 {"extensionsUsed", {"KHR_materials_unlit"}},
                                 {"scene", 0},
                                 {"scenes", {{{"nodes", {0}}}}},
                                 {"nodes",
                                  {{{"mesh", 0},
                                    {"name", printable(drawing.algorithm())},
                                    {"rotation", {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}}}}},
                                 {"meshes", {{{"primitives", mesh}}}},
                                 {"materials", materials},
                                 {"bufferViews", buffer.views},
                                 {"accessors", buffer.accessors},
                                 {"buffers", {{{"byteLength", buffer.bytes.size()}}}},
                                 {"extras", {{"low", {low.x, low.y, low.z}}}}})
                               .dump(-1, ' ', true, Json::error_handler_t::replace);
  const auto padded = [](std::size_t size) { return (size + 3) / 4 * 4; };
  std::string head = "glTF";
  append_word(head, 2);
  append_word(head, 12 + 8 + padded(json.size()) + 8 + padded(buffer.bytes.size()));
  output.append(head);
  append_chunk(output, json, "JSON", ' ');
  append_chunk(output, std::move(buffer.bytes), "BIN\0", '\0');
}

}  // namespace ar3d
