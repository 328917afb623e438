// Any bytes either are refused with one line, or give graphs that the format's writer and reader
// return unchanged. AR3D_FUZZ_FORMAT is the format's name; empty: whichever is detected.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "ar3d/formats/catalog.h"
#include "ar3d/model/error.h"

namespace {

using ar3d::Graph;

std::vector<std::uint64_t> edge_numbers(const Graph& graph) {
  std::vector<std::uint64_t> numbers;
  for (const auto [u, v] : graph.edges()) {
    numbers.push_back((std::uint64_t{std::max(u, v)} << 32) | std::min(u, v));
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::vector<Graph> read_all(std::string text, const std::string& format) {
  const ar3d::ReadOptions options{.format = format, .free_vertices = 4096};
  ar3d::GraphReader reader(ar3d::TextInput("fuzz", ar3d::bytes_of(std::move(text))), options);
  std::vector<Graph> graphs;
  while (std::optional<Graph> graph = reader.next()) graphs.push_back(std::move(*graph));
  return graphs;
}

std::string written(const std::vector<Graph>& graphs, const ar3d::GraphFormat& format) {
  ar3d::OutputFile output("/dev/null");
  const auto writer = format.writer(output, {});
  std::string text;
  const auto take = [&] { text += std::exchange(output.pending(), {}); };
  for (const Graph& graph : graphs) {
    writer->write(graph);
    take();
  }
  writer->finish();
  take();
  return text;
}

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string format = AR3D_FUZZ_FORMAT;
  std::vector<Graph> graphs;
  try {
    graphs = read_all({reinterpret_cast<const char*>(data), size}, format);
  } catch (const ar3d::InputError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos);
    return 0;
  }
  // A writer passes text on before 64 KiB; larger graphs are only read. graph6 takes n^2 bits.
  for (const Graph& graph : graphs) {
    if (graph.num_vertices() > 300 || graph.num_edges() > 1000) return 0;
  }
  const std::string name = format.empty() ? "edgelist" : format;
  const std::vector<Graph> again = read_all(written(graphs, ar3d::find_graph_format(name)), name);
  require(again.size() == graphs.size());
  for (std::size_t i = 0; i < graphs.size(); ++i) {
    require(again[i].num_vertices() == graphs[i].num_vertices());
    require(edge_numbers(again[i]) == edge_numbers(graphs[i]));
  }
  return 0;
}
