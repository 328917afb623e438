#include "ar3d/formats/text/line_shapes.h"

namespace ar3d {

std::optional<Tokens> size_header(const TextInput& input, std::string_view line) {
  if (line.empty() || (!is_comment(line) && line[0] != 'n')) return std::nullopt;
  Tokens tokens(input, line);
  const std::string_view first = tokens.word();
  if (first == "n") return tokens;
  if (first != "#" && first != "%") return std::nullopt;
  if (tokens.word() != "vertices") return std::nullopt;
  return tokens;
}

}  // namespace ar3d
