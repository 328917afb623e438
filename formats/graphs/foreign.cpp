// What stands in the place of a graph, and formats that other programs read, by their first bytes and
// words: each is refused by its name, with what makes it readable.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/predicate.hpp>
#include <string_view>

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {
namespace {

using namespace std::string_view_literals;

/// How a text begins, what it is, and what makes a graph of it.
using Beginning = std::array<std::string_view, 3>;

/// By the first bytes.
constexpr Beginning kBytes[] = {
    {"PK\x03\x04"sv, "a zip archive (also .npz, .xlsx, .docx)", "unzip it"},
    {"\x28\xb5\x2f\xfd"sv, "packed by zstd", "`zstd -d` unpacks it"},
    {"7z\xbc\xaf\x27\x1c"sv, "a 7z archive", "unpack it"},
    {"Rar!\x1a"sv, "a rar archive", "unpack it"},
    {"\x04\x22\x4d\x18"sv, "packed by lz4", "`lz4 -d` unpacks it"},
    {"\x1f\x9d"sv, "packed by compress", "`gzip -d` unpacks it"},
    {"%PDF-"sv, "a PDF", "save the graph itself"},
    {"\x89PNG"sv, "a picture (PNG)", "save the graph itself"},
    {"\x93NUMPY"sv, "an array of numpy (.npy)",
     "as_graph(numpy.load(FILE)) of the package reads it"},
    {"PAR1"sv, "Parquet", "pandas makes CSV of it: read_parquet(FILE).to_csv(OUTPUT)"},
    {"SQLite format 3"sv, "a database of SQLite", "export a table of edges as CSV"},
    {"\x7f"
     "ELF"sv,
     "a program", "give the graph"},
};

/// By the first words, in small letters for letters of any size.
constexpr Beginning kWords[] = {
    {"version https://git-lfs.github.com/spec/", "a pointer of git-lfs",
     "`git lfs pull` fetches the file"},
    {"<!doctype html", "a page of HTML", "save the file itself"},
    {"<html", "a page of HTML", "save the file itself"},
    {"{", "JSON", "networkx reads it: node_link_graph(json.load(FILE)), then write_graphml"},
    {"[", "JSON", "write an edge as 'u v' on a line"},
    {"leda.graph", "LEDA", "networkx reads it: read_leda(FILE), then write_graphml"},
    {"nodedef>", "GDF", "Gephi exports it as GraphML"},
    {"graph 1, order ", "text of nauty's showg", "write the graphs as graph6 (geng, copyg)"},
};

/// Pajek's and its relatives'.
constexpr std::string_view kStars[] = {"*vertices", "*network", "*arcs",
                                       "*edges",    "*matrix",  "*node"};

/// Graphs of 28 and 60 vertices begin with a bracket. JSON without digits and commas is short.
bool is_graph6(std::string_view text) {
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  return line.size() > 16 && std::ranges::all_of(line, [](char c) { return c >= '?' && c <= '~'; });
}

}  // namespace

std::string_view first_text(std::string_view text) {
  for (;;) {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
    const bool is_block = text.starts_with("/*");
    const bool is_line = text.starts_with('#') || text.starts_with("% ") || text.starts_with("//");
    if (!is_block && !is_line) return text;
    const std::size_t end = is_block ? text.find("*/") : text.find('\n');
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2 - (is_block ? 0 : 1));
  }
}

void refuse_foreign(TextInput& input, bool is_forced) {
  const auto refuse = [&](std::string_view what, std::string_view way) {
    throw InputError(
        fmt::format("{}:1: this is {}, which is not read; {}", input.name(), what, way));
  };
  const auto by_networkx = [&](std::string_view what, std::string_view reader) {
    refuse(what, fmt::format("examples/convert.py makes GraphML of it: networkx.write_graphml("
                             "networkx.Graph(networkx.{}(FILE)), OUTPUT)",
                             reader));
  };
  const std::string_view bytes = input.look_ahead_line();
  for (const auto& [text, what, way] : kBytes) {
    if (bytes.starts_with(text)) refuse(what, way);
  }
  if (bytes.size() > 10 && bytes.starts_with("BZh") && bytes.substr(4).starts_with("1AY&SY")) {
    refuse("packed by bzip2", "`bunzip2` unpacks it");
  }
  if (bytes.size() > 262 && bytes.substr(257).starts_with("ustar")) {
    refuse("a tar archive", "`tar -x` unpacks it");
  }
  std::string_view text = first_text(bytes);
  if (text.starts_with('<')) text = first_text(input.look_ahead(1024));
  using boost::algorithm::istarts_with;
  for (const auto& [word, what, way] : kWords) {
    if (istarts_with(text, word) && !is_graph6(text)) refuse(what, way);
  }
  if (text.starts_with('<') && text.find("<gexf") != std::string_view::npos) {
    by_networkx("GEXF", "read_gexf");
  }
  if (text.starts_with('<') && boost::algorithm::ifind_first(text, "<html")) {
    refuse("a page of HTML", "save the file itself");
  }
  for (const std::string_view star : kStars) {
    if (istarts_with(text, star)) by_networkx("Pajek", "read_pajek");
  }
  const bool is_ucinet = istarts_with(text, "dl ") && boost::algorithm::ifind_first(text, "n");
  if (is_ucinet && text.substr(0, text.find('\n')).find('=') != std::string_view::npos) {
    refuse("UCINET's DL", "igraph reads it: Graph.Read_DL(FILE).write_graphml(OUTPUT)");
  }
  if (is_forced) return;
  if (input.name().ends_with(".sif")) {
    refuse("SIF of Cytoscape by its ending", "Cytoscape exports it as GraphML");
  }
  if (input.name().ends_with(".lgl")) {
    refuse("LGL by its ending", "igraph reads it: Graph.Read_Lgl(FILE).write_graphml(OUTPUT)");
  }
  if (input.name().ends_with(".tgf")) {
    refuse("Trivial Graph Format by its ending", "write its edges, behind the line '#', as a list");
  }
}

}  // namespace ar3d
