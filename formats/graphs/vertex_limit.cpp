#include "ar3d/formats/graphs/vertex_limit.h"

#include <fmt/format.h>

#include <limits>

namespace ar3d {
namespace {
constexpr std::uint64_t kMaxVertices = std::numeric_limits<Vertex>::max() - 1;
constexpr std::uint64_t kVerticesPerByte = 16;
}  // namespace

std::optional<std::string> vertex_count_problem(std::uint64_t n, std::uint64_t bytes,
                                                const ReadOptions& options) {
  if (n > kMaxVertices) {
    return fmt::format("{} vertices are too many, the limit is {}", n, kMaxVertices);
  }
  const std::uint64_t allowed = options.free_vertices + kVerticesPerByte * bytes;
  if (n <= allowed) return std::nullopt;
  return fmt::format(
      "{} vertices claimed by a graph of {} bytes, which accounts for at most {}; "
      "--trust-sizes believes it",
      n, bytes, allowed);
}

}  // namespace ar3d
