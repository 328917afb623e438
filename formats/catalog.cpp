// The table of graph formats, and the reader that finds a file's format by its content: endings lie
// too often.
#include "ar3d/formats/catalog.h"

#include "ar3d/base/printable.h"
#include "ar3d/formats/text/tokens.h"

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

/// From the first line on that is neither blank nor a comment.
std::string_view body_of(std::string_view text) {
  for (;;) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (!is_blank(line) && !is_comment(line)) return text;
    if (line.size() == text.size()) return {};
    text.remove_prefix(line.size() + 1);
  }
}

void refuse_results(const TextInput& input, std::string_view text) {
  if (!text.starts_with("\x89HDF")) return;
  throw InputError(fmt::format(
      "{}: results (HDF5), no graph and no drawing; `ar3d replay {} --keep all -o drawings.jsonl` "
      "writes their drawings",
      input.name(), shell_word(input.name())));
}

/// The format of the text to come. Looks beyond the first line unless that is one word, so that a
/// pipe's first graph can be read before its second is written.
const GraphFormat& detect_format(TextInput& input, const ReadOptions& options) {
  std::string_view text = input.look_ahead_line();
  if (text.empty()) throw InputError(fmt::format("{}: empty file: no graph in it", input.name()));
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  if (is_comment(text) || is_blank(line) || line.find_first_of("0123456789 \t,;") != line.npos ||
      line.starts_with("graph") || line == "c") {
    text = input.look_ahead(kDetectionBytes);
  }
  const bool is_list = options.base || options.first_line != FirstLine::automatic;
  const InputHead head{text, input.sees_end(), told_format(input.name()), is_list, body_of(text)};
  try {
    for (const GraphFormat& format : graph_formats()) {
      if (format.detect(head)) return format;
    }
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}:1: {}", input.name(), error.what()));
  }
  const std::string_view first = head.body.empty() ? text : head.body;
  const std::string_view before = text.substr(0, text.size() - first.size());
  throw InputError(
      fmt::format("{}:{}: this is no graph format known here: {}; --from says which one "
                  "is meant",
                  input.name(), std::ranges::count(before, '\n') + 1,
                  shown(first.substr(0, first.find_first_of("\r\n")))));
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

std::string_view told_format(std::string_view name) {
  for (const std::string_view packed : {".gz", ".xz"}) {
    if (name.ends_with(packed)) name.remove_suffix(packed.size());
  }
  for (const std::string_view table : {".csv", ".tsv", ".ncol"}) {
    if (name.ends_with(table)) return "edgelist";
  }
  const GraphFormat* const format = graph_format_of_path(name);
  if (format == nullptr || name.ends_with(".txt") || name.ends_with(".xml")) return {};
  return format->name;
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
  if (options.base.value_or(0) > 1) {
    throw InputError(fmt::format("vertex ids start at 0 or 1, not at {}", *options.base));
  }
  if (input_->look_ahead_line().starts_with("{\"n\":")) {  // graph6 has no '"'
    throw InputError(fmt::format("{}:1: these are drawings, no graphs; `ar3d verify` judges them",
                                 input_->name()));
  }
  const GraphFormat* const forced =
      options.format.empty() ? nullptr : &find_graph_format(options.format);
  refuse_results(*input_, input_->look_ahead_line());
  refuse_foreign(*input_, forced != nullptr);
  format_ = forced != nullptr ? forced : &detect_format(*input_, options);
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
  refuse_results(input, input.look_ahead_line());
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

Graph read_graph(const std::string& path, const ReadOptions& options,
                 std::vector<std::string>* notes) {
  GraphReader reader(path, options);
  std::optional<Graph> graph = reader.next();
  if (!graph) throw InputError(fmt::format("{}: no graph", path));
  if (reader.next()) {
    throw InputError(fmt::format("{}: a second graph; one is wanted", reader.where()));
  }
  if (notes != nullptr) *notes = reader.take_notes();
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
