#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/formats/text/text_input.h"

namespace ar3d {

/// A field of a row of a list, without its quotes.
struct ListField {
  std::string text;
  std::size_t column = 1;  ///< where it begins in the line
  bool is_quoted = false;
};
using ListRow = std::vector<ListField>;

/// How the lines of a list are cut into fields, which holds for all of them.
struct RowCut {
  char separator = 0;       ///< between the fields; 0: blanks and tabs
  bool has_quotes = false;  ///< words may stand in quotes; fields between separators always may

  /// From a { at the third field or later to a } at the end of the line is one field: attributes
  /// of networkx. @throws InputError for a quote without its other one, or with a name behind it.
  ListRow operator()(const TextInput& input, std::string_view line) const;
};

/// Returns the one way in which the first row of a list can be cut: two ends, maybe with a weight
/// or attributes, or a heading. @throws InputError if there are two ways.
RowCut cut_of(const TextInput& input, std::string_view line);

/// The columns of a heading that are the ends of edges, such as source and target.
struct EndColumns {
  std::size_t source = 0;
  std::size_t target = 1;
};
std::optional<EndColumns> ends_of_heading(const ListRow& row);

/// True if the line is a heading that names the ends, however it is cut.
bool is_heading_of_ends(std::string_view line);

/// A weight: any number, written as programs write them.
bool is_list_number(std::string_view text);
/// Digits without a zero in front.
bool is_whole_number(std::string_view text);
/// True for what stands behind an edge: attributes, a weight, or nothing between two separators.
bool is_attribute(const ListField& field);
/// Why that field is no end of an edge in any list; nothing if it may be one.
/// @param is_headed  in a table whose heading names the ends: brackets are those of a name.
std::optional<std::string> end_problem(const ListField& field, bool is_headed = false);

/// The counts of vertices and edges that a comment at a list's head states.
struct StatedCounts {
  struct Count {
    std::uint64_t count = 0;
    std::uint64_t line = 0;
  };
  std::optional<Count> vertices, edges;
  bool is_konect = false;    ///< its ids are from 1
  bool is_directed = false;  ///< KONECT's "asym", SNAP's "Directed graph"

  /// @throws InputError for a list of KONECT whose two sides are numbered each from 1.
  void read(const TextInput& input, std::string_view comment);
};

}  // namespace ar3d
