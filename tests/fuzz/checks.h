#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"

namespace ar3d::fuzz {

inline std::string rewritten(std::string text) {
  DrawingJsonlReader reader(TextInput("fuzz", bytes_of(std::move(text))));
  std::string result;
  while (const auto line = reader.next()) {
    if (const auto* drawing = std::get_if<Drawing>(&*line)) {
      append_drawing_line(result, *drawing);
    } else {
      append_error_line(result, std::get<UndrawnGraph>(*line));
    }
  }
  return result;
}

/// Any bytes either are refused with one line, or give drawings whose written lines give the same
/// lines again. Throws std::logic_error otherwise.
inline void check_drawings(std::string text) {
  std::string lines;
  try {
    lines = rewritten(std::move(text));
  } catch (const InputError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) {
      throw std::logic_error("a message has one line");
    }
    return;
  }
  if (!lines.empty() && rewritten(lines) != lines) {
    throw std::logic_error("the written lines give themselves again");
  }
}

inline std::vector<std::uint64_t> edge_numbers(const Graph& graph) {
  std::vector<std::uint64_t> numbers;
  for (const auto [u, v] : graph.edges()) {
    numbers.push_back((std::uint64_t{std::max(u, v)} << 32) | std::min(u, v));
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

inline std::vector<Graph> read_all(std::string text, const std::string& format) {
  const ReadOptions options{.format = format, .free_vertices = 4096};
  GraphReader reader(TextInput("fuzz", bytes_of(std::move(text))), options);
  std::vector<Graph> graphs;
  while (std::optional<Graph> graph = reader.next()) graphs.push_back(std::move(*graph));
  return graphs;
}

inline std::string written(const std::vector<Graph>& graphs, const GraphFormat& format) {
  static OutputFile output("/dev/null");  // the text is taken before it gets there
  const GraphWriter write = format.writer(output, {});
  std::string text;
  const auto take = [&] { text += std::exchange(output.pending(), {}); };
  for (const Graph& graph : graphs) {
    write(graph);
    take();
  }
  output.append(format.tail);
  take();
  return text;
}

/// What a fuzzer takes for a crash and a test for a failure.
inline void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

/// Any bytes either are refused with one line, or give graphs that the format's writer and reader
/// return unchanged. @param format  its name; empty: whichever is detected.
inline void check_graphs(const std::string& format, std::string text) {
  std::vector<Graph> graphs;
  try {
    graphs = read_all(std::move(text), format);
  } catch (const InputError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos, "a message has one line");
    return;
  }
  // A writer passes text on before 64 KiB; larger graphs are only read. graph6 takes n^2 bits.
  for (const Graph& graph : graphs) {
    if (graph.num_vertices() > 300 || graph.num_edges() > 1000) return;
  }
  const std::string name = format.empty() ? "edgelist" : format;
  const std::vector<Graph> again = read_all(written(graphs, find_graph_format(name)), name);
  require(again.size() == graphs.size(), "as many graphs come back");
  for (std::size_t i = 0; i < graphs.size(); ++i) {
    require(again[i].num_vertices() == graphs[i].num_vertices(), "the vertices come back");
    require(edge_numbers(again[i]) == edge_numbers(graphs[i]), "the edges come back");
  }
}

}  // namespace ar3d::fuzz
