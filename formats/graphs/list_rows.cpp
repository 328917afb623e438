// Cuts the rows of edge lists: tables between commas, semicolons or tabs (RFC 4180, as pandas, R and
// Gephi write them) and words between blanks (networkx, igraph). How a list is cut is decided by its
// first row alone, and a row that two ways fit is refused.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/formats/graphs/graph_format.h"
#include "ar3d/formats/graphs/list_graph.h"
#include "ar3d/formats/text/tokens.h"

namespace ar3d {
namespace {

bool is_white(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// Small letters and digits alone: "From_Node-ID" is "fromnodeid".
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0) result += static_cast<char>(std::tolower(byte));
  }
  return result;
}

constexpr std::array<std::array<std::string_view, 2>, 26> kEnds = {{{"source", "target"},
                                                                    {"from", "to"},
                                                                    {"src", "dst"},
                                                                    {"src", "dest"},
                                                                    {"src", "tgt"},
                                                                    {"source", "destination"},
                                                                    {"source", "dest"},
                                                                    {"origin", "destination"},
                                                                    {"sourceid", "targetid"},
                                                                    {"sourcenode", "targetnode"},
                                                                    {"fromid", "toid"},
                                                                    {"fromnode", "tonode"},
                                                                    {"fromnodeid", "tonodeid"},
                                                                    {"node1", "node2"},
                                                                    {"nodea", "nodeb"},
                                                                    {"nodeid1", "nodeid2"},
                                                                    {"vertex1", "vertex2"},
                                                                    {"id1", "id2"},
                                                                    {"start", "end"},
                                                                    {"startnode", "endnode"},
                                                                    {"startid", "endid"},
                                                                    {"head", "tail"},
                                                                    {"tail", "head"},
                                                                    {"u", "v"},
                                                                    {"v1", "v2"},
                                                                    {"i", "j"}}};

/// Brackets that are opened are closed, as in f(x): no piece of a printed list or tuple.
bool has_whole_brackets(std::string_view text) {
  std::string open;
  for (const char c : text) {
    const std::size_t closing = std::string_view(")]}").find(c);
    if (std::string_view("([{").find(c) != std::string_view::npos) {
      open += c;
    } else if (closing != std::string_view::npos) {
      if (open.empty() || open.back() != "([{"[closing]) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

/// From its { to the } of that, which ends the text; braces in strings are none.
bool is_one_dictionary(std::string_view text) {
  std::size_t depth = 0;
  char quote = '\0';
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != '\0') {
      if (c == '\\') ++at;
      if (c == quote) quote = '\0';
    } else if (c == '\'' || c == '"') {
      quote = c;
    } else if (c == '{') {
      ++depth;
    } else if (c == '}' && depth > 0) {
      --depth;
    }
    if (depth == 0) return at > 0 && at + 1 == text.size();
  }
  return false;
}

bool is_separator(char c) { return c == ',' || c == ';'; }

bool is_several_numbers(const ListField& field, const char* between = " ") {
  const std::string& text = field.text;
  return !field.is_quoted && text.find_first_of(between) != std::string::npos &&
         is_digit(text.front()) && is_digit(text.back()) &&
         text.find_first_not_of(std::string("0123456789") + between) == std::string::npos;
}

/// Can this be a row of a list that is cut so?
bool fits(const ListRow& row) {
  const auto is_cut = [](const ListField& field) {  // "a," is no usual name of a vertex
    const std::string& text = field.text;
    return !field.is_quoted && !text.empty() && !text.starts_with('{') &&
           (is_separator(text.front()) || is_separator(text.back()));
  };
  if (std::ranges::any_of(row, is_cut)) return false;
  if (ends_of_heading(row)) return true;
  return (row.size() == 2 || (row.size() == 3 && is_attribute(row[2]))) && !end_problem(row[0]) &&
         !end_problem(row[1]);
}

}  // namespace

ListRow RowCut::operator()(const TextInput& input, std::string_view line) const {
  ListRow row;
  const auto is_blank = [&](char c) { return is_white(c) && c != separator; };
  const auto ends = [&](char c) { return separator == 0 ? is_white(c) : c == separator; };
  std::size_t at = 0;
  for (;;) {
    const std::size_t before = at;
    while (at < line.size() && is_blank(line[at])) ++at;
    if (separator != 0 && at < line.size() && line[at] == '"' &&
        line.substr(before, at - before).find('\t') != std::string_view::npos) {
      input.fail(before + 1, "a tab in front of a quote: is the quote a part of the name?");
    }
    if (at == line.size() && (separator == 0 || row.empty())) return row;
    ListField& field = row.emplace_back();
    field.column = at + 1;
    field.is_quoted = at < line.size() && line[at] == '"' && (separator != 0 || has_quotes);
    if (field.is_quoted) {
      for (++at; at < line.size(); ++at) {
        if (line[at] == '"' && !line.substr(at + 1).starts_with('"')) break;
        if (line[at] == '"') ++at;
        field.text += line[at];
      }
      if (at >= line.size()) {
        input.fail(field.column,
                   fmt::format("no quote ends {}", shown(line.substr(field.column - 1))));
      }
      ++at;
      while (at < line.size() && is_blank(line[at]) && separator != 0) ++at;
      if (at < line.size() && !ends(line[at])) {
        input.fail(at + 1,
                   fmt::format("{} behind a closing quote: a quote in a name is written \"\"",
                               shown(line.substr(at))));
      }
    } else {
      const std::string_view rest = line.substr(at, line.find_last_not_of(" \t\r") + 1 - at);
      const bool is_rest = row.size() > 2 && is_one_dictionary(rest);
      const std::size_t begin = at;
      while (at < line.size() && (is_rest || !ends(line[at]))) ++at;
      field.text = line.substr(begin, at - begin);
      while (!field.text.empty() && is_white(field.text.back())) field.text.pop_back();
    }
    if (at == line.size()) return row;
    ++at;
  }
}

RowCut cut_of(const TextInput& input, std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  const RowCut words{0, first != std::string_view::npos && line[first] == '"'};
  const auto fits_cut = [&](RowCut cut) {
    try {
      return fits(cut(input, line));
    } catch (const InputError&) {
      return false;
    }
  };
  std::vector<RowCut> ways;
  for (const char separator : {'\t', ';', ','}) {
    if (line.find(separator) != std::string_view::npos && fits_cut({separator, true})) {
      ways.push_back({separator, true});
    }
  }
  if (!ways.empty() && ways[0].separator == '\t') return ways[0];
  if (const std::size_t tab = line.find('\t'); tab != std::string_view::npos && ways.empty()) {
    const ListField first_field{std::string(line.substr(0, tab)), 1, false};
    const bool is_last = line.find('\t', tab + 1) == std::string_view::npos;
    if (is_last && is_several_numbers(first_field)) return {'\t', true};  // a tab may be lost
  }
  // A comma may be the decimal one of a weight: 0;1;0,5
  if (ways.size() == 2 && RowCut{';', true}(input, line).size() == 3) ways.pop_back();
  if (fits_cut(words)) {
    if (const std::size_t tabs = line.find("\t\t"); ways.empty() && tabs != line.npos) {
      input.fail(tabs + 1, "two tabs: a field may be missing between them, one tab or blank tells");
    }
    ways.push_back(words);
  }
  if (ways.size() == 1) return ways[0];
  if (ways.size() > 1) {
    input.fail(0, fmt::format("{} can be cut at '{}' and at {}: names in quotes tell", shown(line),
                              ways[0].separator, ways[1].separator == 0 ? "blanks" : "','"));
  }
  for (const char separator : {'\t', ';', ','}) {  // what is wrong with it, is said of its fields
    if (line.substr(0, line.find('{')).find(separator) != std::string_view::npos) {
      return {separator, true};
    }
  }
  return words;
}

std::optional<EndColumns> ends_of_heading(const ListRow& row) {
  std::vector<std::string> names;
  for (const ListField& field : row) names.push_back(plain(field.text));
  for (const auto& [source, target] : kEnds) {
    const auto from = std::ranges::find(names, source);
    const auto to = std::ranges::find(names, target);
    if (from == names.end() || to == names.end()) continue;
    return EndColumns{static_cast<std::size_t>(from - names.begin()),
                      static_cast<std::size_t>(to - names.begin())};
  }
  return std::nullopt;
}

bool is_heading_of_ends(std::string_view line) {
  std::string words(line);
  const auto stands_between = [](char c) { return is_separator(c) || c == '"'; };
  std::replace_if(words.begin(), words.end(), stands_between, ' ');
  ListRow row;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t begin = words.find_first_not_of(" \t\r", at);
    if (begin == std::string::npos) break;
    at = std::min(words.find_first_of(" \t\r", begin), words.size());
    row.push_back({words.substr(begin, at - begin)});
  }
  return ends_of_heading(row).has_value();
}

bool is_whole_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos &&
         (text[0] != '0' || text.size() == 1);
}

bool is_list_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  std::string point(text);  // or a decimal comma
  if (point.find('.') == std::string::npos) std::ranges::replace(point, ',', '.');
  double value = 0;
  const char* const end = point.data() + point.size();
  const auto read = std::from_chars(point.data(), end, value);
  return !point.empty() && read.ptr == end && read.ec != std::errc::invalid_argument;
}

bool is_attribute(const ListField& field) {
  return field.text.empty() || (field.text.starts_with('{') && field.text.ends_with('}')) ||
         is_list_number(field.text);
}

std::optional<std::string> end_problem(const ListField& field, bool is_headed) {
  const std::string& text = field.text;
  if (text.empty()) return "an end of an edge is missing";
  std::string name = text;
  if (field.is_quoted) std::ranges::replace(name, '\t', ' ');
  if (auto problem = name_problem(name)) return problem;
  if (text.find("\xef\xbb\xbf") != std::string::npos) return "a byte order mark is in a name";
  if (field.is_quoted || is_whole_number(text)) return std::nullopt;
  if (is_several_numbers(field, is_headed ? " " : " ,;")) {
    return fmt::format("{} is several numbers: a line break or a blank may be missing",
                       shown(text));
  }
  for (const char* missing : {"NA", "N/A", "NaN", "nan", "NULL", "null", "None"}) {
    if (text == missing)
      return fmt::format(
          "{} for an end of an edge says that it is missing (in "
          "quotes it is a name)",
          shown(text));
  }
  if (is_list_number(text)) {
    return fmt::format(
        "expected a vertex id, found {}: ids are whole numbers, without sign or "
        "zeros in front (in quotes it is a name)",
        shown(text));
  }
  const bool has_attributes = text.starts_with('{') || text.find(" {") != std::string::npos;
  if (has_attributes && text.ends_with('}') && !is_headed) {
    return fmt::format("{} is attributes, no end of an edge (in quotes it is a name)", shown(text));
  }
  if (!is_headed && !has_whole_brackets(text)) {
    return fmt::format("{} is a piece of a printed list or tuple: an edge is 'u v' or 'u,v'",
                       shown(text));
  }
  return std::nullopt;
}

void StatedCounts::read(const TextInput& input, std::string_view comment) {
  std::vector<std::string> words;
  const auto count_of = [](const std::string& word) {
    return std::strtoull(word.c_str(), nullptr, 10);
  };
  // "Nodes: 6 Edges: 3", "n=6", "6 nodes, 3 edges": a number belongs to the word before it, or to
  // the word behind it in a part that begins with a number.
  const auto take_part = [&] {
    const bool is_number_first = !words.empty() && is_whole_number(words[0]);
    for (std::size_t i = 0; i < words.size(); ++i) {
      const std::size_t other = is_number_first ? i - 1 : i + 1;  // -1 is beyond them, too
      if (other >= words.size() || !is_whole_number(words[other])) continue;
      const auto is_one_of = [&](std::initializer_list<std::string_view> known) {
        return std::ranges::find(known, words[i]) != known.end();
      };
      const Count count{count_of(words[other]), input.line()};
      if (is_one_of({"nodes", "vertices", "n", "numnodes", "numvertices", "order", "nnodes"})) {
        vertices = count;
      } else if (is_one_of({"edges", "m", "numedges", "links", "nedges"})) {
        edges = count;
      }
    }
    words.clear();
  };
  std::string word;
  for (const char c : std::string(comment.substr(1)) + ",") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-') {
      if (c != '_') word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    if (!word.empty()) words.push_back(std::exchange(word, ""));
    if (c != ',' || words.empty()) continue;
    is_directed = is_directed || words[0] == "directed";  // SNAP's "Directed graph"
    const bool is_counts = std::ranges::all_of(words, is_whole_number);
    if (is_konect && is_counts) {  // edges, vertices, vertices
      edges = {count_of(words[0]), input.line()};
      if (words.size() > 1) vertices = {count_of(words[1]), input.line()};
      words.clear();
    }
    if (comment[0] == '%' && (words.size() == 2 || words.size() == 3) &&
        (words[0] == "sym" || words[0] == "asym" || words[0] == "bip")) {
      is_konect = true;
      is_directed = words[0] == "asym";
      if (words[0] == "bip") {
        input.fail(0,
                   "a bipartite list of KONECT counts each side from 1: write the ids of the "
                   "second side behind those of the first");
      }
    }
    take_part();
  }
}

}  // namespace ar3d
