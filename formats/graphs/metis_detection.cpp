#include "ar3d/formats/graphs/metis_detection.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <vector>

#include "ar3d/formats/text/line_shapes.h"

namespace ar3d {
namespace {

/// The numbers of a line; nothing if there is another word or a number of more than 64 bits.
std::optional<std::vector<std::uint64_t>> numbers_of(std::string_view line) {
  constexpr std::string_view kSpace = " \t\r\v\f";
  std::vector<std::uint64_t> numbers;
  for (;;) {
    const std::size_t first = line.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return numbers;
    line.remove_prefix(first);
    std::uint64_t value = 0;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc()) return std::nullopt;
    line.remove_prefix(static_cast<std::size_t>(stop - line.data()));
    if (!line.empty() && kSpace.find(line[0]) == std::string_view::npos) return std::nullopt;
    numbers.push_back(value);
  }
}

/// Takes the next whole line that is no comment from the text.
std::optional<std::string_view> take_line(std::string_view& text, bool whole) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos && !whole) return std::nullopt;
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (!is_comment(line)) return line;
  }
  return std::nullopt;
}

}  // namespace

bool looks_like_metis(const InputHead& head) {
  if (head.text.starts_with(kMetisMark)) return true;
  std::string_view text = head.text;
  std::optional<std::string_view> line = take_line(text, head.whole);
  while (line && is_blank(*line)) line = take_line(text, head.whole);
  if (!line) return false;
  const auto header = numbers_of(*line);
  if (!header || header->size() < 2 || header->size() > 4) return false;
  const std::uint64_t n = header->front();
  const std::uint64_t m = header->at(1);
  const bool plain = header->size() == 2;
  if (n == 0) return m == 0;
  if (m == 0 && plain) return false;  // the edge (n, 0), or a header: the edge list's to ask
  bool edge_list = plain && n != m;   // it can be one, too
  std::uint64_t rows = 0;
  for (line = take_line(text, head.whole); line && rows < n; line = take_line(text, head.whole)) {
    const auto row = numbers_of(*line);
    if (!row) return false;
    ++rows;
    if (plain &&
        !std::all_of(row->begin(), row->end(), [&](auto id) { return id >= 1 && id <= n; })) {
      return false;
    }
    if (!row->empty() && row->size() != 2) edge_list = false;
  }
  if (m == 0)
    return rows == n || !head.whole;  // nothing but blank lines: all of them, or an edge (n, 0)
  return !edge_list;
}

}  // namespace ar3d
