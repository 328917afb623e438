#pragma once

#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/formats/graphs/graph_format.h"

namespace ar3d {

/// Returns the format of a catalogue, of graphs or of drawings as `kind` says, that has the name.
/// @throws InputError naming the unknown format and the known ones.
template <class Format>
const Format& format_called(std::string_view name, const std::vector<Format>& formats,
                            std::string_view kind) {
  const auto found = std::ranges::find(formats, name, &Format::name);
  if (found != formats.end()) return *found;
  const auto known = names_of(formats);
  throw InputError(fmt::format("unknown {} format '{}', known: {}{}", kind, name,
                               fmt::join(known, ", "), did_you_mean(name, known)));
}

/// Returns the one with that ending. @throws InputError naming the path, whose ending is none's.
template <class Format>
const Format& format_of_ending(const std::string& ending, const std::string& path,
                               const std::vector<Format>& formats, std::string_view kind) {
  std::vector<std::string> known;
  for (const Format& format : formats) {
    if (std::ranges::count(format.extensions, ending) > 0) return format;
    known.insert(known.end(), format.extensions.begin(), format.extensions.end());
  }
  throw InputError(
      fmt::format("{}: '{}' is no {} format's ending (known: {}); --format says which one is meant",
                  path, ending, kind, fmt::join(known, " ")));
}

/// All graph formats, in the order in which detection asks them.
const std::vector<GraphFormat>& graph_formats();

/// @throws InputError naming the unknown format and the known ones.
const GraphFormat& find_graph_format(std::string_view name);

/// The format whose extension the path has (a final .gz or .xz is looked through), or null.
const GraphFormat* graph_format_of_path(std::string_view path);

/// Returns what stands behind the last dot of the path's last part, dot included: ".s6"; empty
/// without one.
std::string path_ending(std::string_view path);

/// The format called `name`, or, if that is empty, the one whose ending the path has; sparse6 where
/// the path has no ending and for "-".
/// @throws InputError naming the unknown format, or the ending that is none's: files are not
/// packed, so .gz and .xz are none either.
const GraphFormat& graph_format_to_write(std::string_view name, const std::string& path);

/// A streaming reader of all graphs of a file.
///
///     GraphReader reader("cubic.s6.gz");
///     while (std::optional<Graph> graph = reader.next()) draw(*graph);
class GraphReader {
 public:
  /// Opens a file or, for "-", standard input; unpacks gzip and xz; finds the format by content
  /// unless options.format names it.
  /// @throws InputError if it cannot be opened, is empty, holds drawings, or its format is unknown.
  explicit GraphReader(const std::string& path, const ReadOptions& options = {});
  /// Reads from any text.
  GraphReader(TextInput input, const ReadOptions& options = {});

  /// The next graph; nothing at the end. Not to be called again after an exception.
  /// @throws InputError "FILE:LINE:COLUMN: message" (without line or column where there is none) if
  /// the text is not of the format or not a simple graph, or "FILE: …" if there is no graph at all.
  std::optional<Graph> next();

  /// The vertices' names in the graph just given; empty if the file has none but numbers.
  std::vector<std::string> names() const { return parser_->names(); }

  /// What has been assumed since the last call, a line each (GraphParser::take_notes).
  std::vector<std::string> take_notes() { return parser_->take_notes(); }

  const GraphFormat& format() const { return *format_; }
  /// "FILE:LINE" of the last line read, for messages about the graph just given.
  std::string where() const;

 private:
  std::unique_ptr<TextInput> input_;
  const GraphFormat* format_ = nullptr;
  std::unique_ptr<GraphParser> parser_;
  std::uint64_t graphs_read_ = 0;
};

/// @throws InputError if the text, which is no drawing, is a graph or results. Reads at most 2^24 bytes ahead.
void refuse_graph(TextInput& input);

/// The only graph of a file. @throws InputError as GraphReader, and if there is none or
/// a second one.
/// @param notes  takes what has been assumed, a line each.
Graph read_graph(const std::string& path, const ReadOptions& options = {},
                 std::vector<std::string>* notes = nullptr);

/// Writes graphs to a file ("-": standard output) that appears only when it is complete.
/// @throws InputError if it cannot be written.
void write_graphs(const std::vector<Graph>& graphs, const GraphFormat& format,
                  const std::string& path, unsigned base = 0);

}  // namespace ar3d
