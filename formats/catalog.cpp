// The table of graph formats, and the reader that finds a file's format by its content: endings lie
// too often.
#include "ar3d/formats/catalog.h"

namespace ar3d {

// The rows of the catalogue, each defined in graphs/, in the file of its format.
GraphFormat adjacency_list_format();
GraphFormat dimacs_format();
GraphFormat dot_format();
GraphFormat edge_list_format();
GraphFormat gml_format();
GraphFormat graph6_format();
GraphFormat graphml_format();
GraphFormat incremental_sparse6_format();
GraphFormat matrix_market_format();
GraphFormat metis_format();
GraphFormat sparse6_format();

namespace {

constexpr std::size_t kDetectionBytes = std::size_t{1} << 16;

/// @throws InputError where the text is of a format that others read, with what converts it.
void refuse_foreign_format(TextInput& input) {
  const bool is_xml = input.look_ahead_line().starts_with("<");
  const std::string_view text = is_xml ? input.look_ahead(1024) : input.look_ahead_line();
  const auto refuse = [&](const char* name, const char* reader) {
    throw InputError(
        fmt::format("{}:1: this is {}, which is not read; examples/convert.py makes GraphML of it: "
                    "networkx.write_graphml(networkx.Graph(networkx.{}(FILE)), OUTPUT)",
                    input.name(), name, reader));
  };
  if (text.find("<gexf") != std::string_view::npos) refuse("GEXF", "read_gexf");
  if (text.starts_with("*Vertices") || text.starts_with("*vertices") ||
      text.starts_with("*Network") || text.starts_with("*network")) {
    refuse("Pajek", "read_pajek");
  }
}

/// The format of the text to come. Looks beyond the first line only where numbers leave several
/// choices, so that a pipe's first graph can be read before its second is written.
const GraphFormat& detect_format(TextInput& input) {
  std::string_view text = input.look_ahead_line();
  if (text.empty()) throw InputError(fmt::format("{}: empty file: no graph in it", input.name()));
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos ||
      std::string_view("#%0123456789").find(text[first]) != std::string_view::npos ||
      text.substr(first).starts_with("graph")) {
    text = input.look_ahead(kDetectionBytes);
  }
  const InputHead head{text, input.sees_end(), is_named_edge_list(input.name())};
  for (const GraphFormat& format : graph_formats()) {
    if (format.detect(head)) return format;
  }
  const std::string_view line = text.substr(0, text.find('\n'));
  throw InputError(
      fmt::format("{}:1: this is no graph format known here: {}", input.name(), shown(line)));
}

}  // namespace

const std::vector<GraphFormat>& graph_formats() {
  static const std::vector<GraphFormat> kFormats = {
      matrix_market_format(),
      dimacs_format(),
      graphml_format(),
      gml_format(),
      dot_format(),
      sparse6_format(),
      incremental_sparse6_format(),
      graph6_format(),
      adjacency_list_format(),
      metis_format(),
      edge_list_format(),
  };
  return kFormats;
}

const GraphFormat& find_graph_format(std::string_view name) {
  return format_called(name, graph_formats(), "graph");
}

bool is_named_edge_list(const std::string& name) {
  const GraphFormat* const named = graph_format_of_path(name);
  const bool is_text = name.find(".txt") != std::string::npos;
  return named != nullptr && named->name == "edgelist" && !is_text;
}

const GraphFormat* graph_format_of_path(std::string_view path) {
  for (const std::string_view packed : {".gz", ".xz"}) {
    if (path.ends_with(packed)) path.remove_suffix(packed.size());
  }
  for (const GraphFormat& format : graph_formats()) {
    for (const std::string& extension : format.extensions) {
      if (path.ends_with(extension)) return &format;
    }
  }
  return nullptr;
}

std::string path_ending(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos || dot == 0 ? "" : std::string(name.substr(dot));
}

const GraphFormat& graph_format_to_write(std::string_view name, const std::string& path) {
  if (!name.empty()) return find_graph_format(name);
  const std::string ending = path == "-" ? "" : path_ending(path);
  if (ending.empty()) return find_graph_format("sparse6");
  return format_of_ending(ending, path, graph_formats(), "graph");
}

GraphReader::GraphReader(const std::string& path, const ReadOptions& options)
    : GraphReader(TextInput(path), options) {}

GraphReader::GraphReader(TextInput input, const ReadOptions& options)
    : input_(std::make_unique<TextInput>(std::move(input))) {
  if (options.base > 1) {
    throw InputError(fmt::format("vertex ids start at 0 or 1, not at {}", options.base));
  }
  if (input_->look_ahead_line().starts_with("{\"n\":")) {  // graph6 has no '"'
    throw InputError(fmt::format("{}:1: these are drawings, no graphs; `ar3d verify` judges them",
                                 input_->name()));
  }
  refuse_foreign_format(*input_);
  format_ = options.format.empty() ? &detect_format(*input_) : &find_graph_format(options.format);
  if (input_->look_ahead_line().empty()) {
    throw InputError(fmt::format("{}: empty file: no graph in it", input_->name()));
  }
  parser_ = format_->parser(*input_, options);
}

std::optional<Graph> GraphReader::next() {
  std::optional<Graph> graph = parser_->next();
  if (graph) {
    ++graphs_read_;
  } else if (graphs_read_ == 0) {
    throw InputError(
        fmt::format("{}: no graph in it, only comments or blank lines", input_->name()));
  }
  return graph;
}

std::string GraphReader::where() const {
  return fmt::format("{}:{}", input_->name(), input_->line());
}

void refuse_graph(TextInput& input) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 24;
  std::string format;
  try {
    GraphReader graphs(
        TextInput(input.name(), bytes_of(std::string(input.look_ahead(kMostBytes)))));
    graphs.next();
    format = graphs.format().name;
  } catch (const InputError&) {
    return;  // neither: the parser says where it is no drawing
  }
  throw InputError(fmt::format("{}:1: this is a graph ({}), no drawing; `ar3d draw` draws it",
                               input.name(), format));
}

Graph read_graph(const std::string& path, const ReadOptions& options) {
  GraphReader reader(path, options);
  std::optional<Graph> graph = reader.next();
  if (!graph) throw InputError(fmt::format("{}: no graph", path));
  if (reader.next()) {
    throw InputError(fmt::format("{}: a second graph; one is wanted", reader.where()));
  }
  return std::move(*graph);
}

void write_graphs(const std::vector<Graph>& graphs, const GraphFormat& format,
                  const std::string& path, unsigned base) {
  OutputFile output(path);
  const GraphWriter write = format.writer(output, base);
  for (const Graph& graph : graphs) write(graph);
  output.append(format.tail);
  output.commit();
}

}  // namespace ar3d
