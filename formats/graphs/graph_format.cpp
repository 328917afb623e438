// What the readers of several formats do with the edges and the size that a text claims.
#include "ar3d/formats/graphs/graph_format.h"

#include <algorithm>
#include <tuple>

#include "ar3d/base/printable.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {
constexpr std::uint64_t kMostVertices = std::numeric_limits<Vertex>::max() - 1;
constexpr std::uint64_t kVerticesPerByte = 16;
}  // namespace

void append_vertices(OutputFile& output, const Graph& graph,
                     const std::array<std::string_view, 2>& around) {
  for (Vertex v = 0; v < graph.num_vertices(); ++v) {
    append_all(output.pending(), around[0], v, around[1]);
    output.flush_if_full();
  }
}

void append_edges(OutputFile& output, const Graph& graph,
                  const std::array<std::string_view, 3>& around, unsigned base) {
  for (const auto [u, v] : graph.edges()) {
    append_all(output.pending(), around[0], std::uint64_t{u} + base, around[1],
               std::uint64_t{v} + base, around[2]);
    output.flush_if_full();
  }
}

std::vector<std::string> telling_names(std::vector<std::string> names) {
  for (std::size_t v = 0; v < names.size(); ++v) {
    const std::string number = fmt::format("{}", v);
    if (names[v] != number && names[v] != "n" + number) return names;
  }
  return {};
}

std::optional<std::string> name_problem(std::string_view text) {
  if (std::ranges::any_of(text, is_control)) {
    return fmt::format("a control character in the name {}", shown(text));
  }
  if (valid_utf8(text) == text) return std::nullopt;
  return fmt::format("{} is no UTF-8: `iconv -f LATIN1 -t UTF-8` or the like makes it so",
                     shown(text));
}

void simplify(std::vector<Edge>& edges) {
  std::erase_if(edges, [](const Edge& edge) { return edge.u == edge.v; });
  for (Edge& edge : edges) {
    if (edge.u > edge.v) std::swap(edge.u, edge.v);
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return std::tie(a.u, a.v) < std::tie(b.u, b.v); });
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

std::optional<std::string> vertex_count_problem(std::uint64_t n, std::uint64_t bytes,
                                                const ReadOptions& options) {
  if (n > kMostVertices) {
    return fmt::format("{} vertices are too many, the limit is {}", n, kMostVertices);
  }
  const std::uint64_t allowed = options.free_vertices + kVerticesPerByte * bytes;
  if (n <= allowed) return std::nullopt;
  return fmt::format(
      "{} vertices claimed by a graph of {} bytes, which accounts for at most {}; "
      "--trust-sizes believes it",
      n, bytes, allowed);
}

}  // namespace ar3d
