#include "ar3d/bench/corpus/spool.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <span>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;
constexpr std::size_t kHeadBytes = sizeof(std::uint64_t);  // how many bytes follow

int unnamed_file(std::string& name) {
  name = (std::filesystem::temp_directory_path() / "ar3d-graphs-XXXXXX").string();
  const int file = mkostemp(name.data(), O_CLOEXEC);
  if (file < 0) throw InputError(fmt::format("cannot create {}: {}", name, std::strerror(errno)));
  unlink(name.c_str());
  return file;
}

void put(std::vector<char>& bytes, std::uint64_t value) {
  for (; value >= 128; value >>= 7) bytes.push_back(static_cast<char>(value | 128));
  bytes.push_back(static_cast<char>(value));
}

std::uint64_t take(std::span<const char>& bytes) {
  std::uint64_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    expect(!bytes.empty() && shift < 64, "a spooled graph is whole");
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes = bytes.subspan(1);
    value |= std::uint64_t{byte & 127u} << shift;
    if (byte < 128) return value;
  }
}

// Edges ascend by (u, v), u < v.
void put_graph(std::vector<char>& bytes, const Graph& graph) {
  put(bytes, graph.num_vertices());
  put(bytes, graph.num_edges());
  Vertex u = 0;
  for (const Edge edge : graph.edges()) {
    put(bytes, edge.u - u);
    put(bytes, edge.v - edge.u);
    u = edge.u;
  }
}

Graph take_graph(std::span<const char> bytes) {
  const std::uint64_t n = take(bytes);
  std::vector<Edge> edges(take(bytes));
  Vertex u = 0;
  for (Edge& edge : edges) {
    u += static_cast<Vertex>(take(bytes));
    edge = {u, u + static_cast<Vertex>(take(bytes))};
  }
  return Graph(n, std::move(edges));
}

}  // namespace

Spool::Spool() : file_(unnamed_file(name_)) {}

std::uint64_t Spool::append(const Graph& graph) {
  const std::uint64_t offset = end_;
  const std::size_t head = buffer_.size();
  buffer_.resize(head + kHeadBytes);
  put_graph(buffer_, graph);
  const std::uint64_t length = buffer_.size() - head - kHeadBytes;
  std::memcpy(buffer_.data() + head, &length, kHeadBytes);
  end_ += kHeadBytes + length;
  if (buffer_.size() >= kBufferBytes) flush();
  return offset;
}

void Spool::flush() {
  std::span<const char> left = buffer_;
  while (!left.empty()) {
    const ssize_t written = write(file_.get(), left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      throw InputError(
          fmt::format("cannot write {} (TMPDIR says where): {}", name_, std::strerror(errno)));
    }
    left = left.subspan(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

namespace {

void read_all(int file, char* to, std::size_t count, std::uint64_t offset,
              const std::string& name) {
  while (count > 0) {
    const ssize_t got = pread(file, to, count, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) {
      throw InputError(fmt::format("cannot read {}: {}", name,
                                   got == 0 ? "it ends too early" : std::strerror(errno)));
    }
    to += got;
    count -= static_cast<std::size_t>(got);
    offset += static_cast<std::uint64_t>(got);
  }
}

}  // namespace

Graph Spool::read(std::uint64_t offset) const {
  std::array<char, 4096> start;  // a small graph comes with one call
  const std::uint64_t there = end_ - offset;
  const std::size_t first = std::min<std::uint64_t>(start.size(), there);
  read_all(file_.get(), start.data(), first, offset, name_);
  std::uint64_t length = 0;
  std::memcpy(&length, start.data(), kHeadBytes);
  expect(length <= there - kHeadBytes, "a spooled graph stands in the file");
  if (kHeadBytes + length <= first) return take_graph({start.data() + kHeadBytes, length});
  std::vector<char> bytes(length);
  read_all(file_.get(), bytes.data(), length, offset + kHeadBytes, name_);
  return take_graph(bytes);
}

}  // namespace ar3d
