// Texts of the small tables: paths of any bytes as ASCII, and graphs as words between blanks, so that
// a text field holds them.
#include "ar3d/store/columns/side_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <vector>

#include "ar3d/base/error.h"

namespace ar3d {

std::string encoded(const std::string& path) {
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 32 && byte < 127 && c != '%') {
      text += c;
    } else {
      text += fmt::format("%{:02X}", byte);
    }
  }
  return text;
}

std::string decoded(const std::string& text) {
  const auto digit = [](char c) {
    const std::size_t at = std::string("0123456789ABCDEF").find(c);
    return at == std::string::npos ? 256 : static_cast<int>(at);
  };
  std::string path;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int code =
        text[i] == '%' && i + 2 < text.size() ? 16 * digit(text[i + 1]) + digit(text[i + 2]) : 256;
    path += code < 256 ? static_cast<char>(code) : text[i];
    if (code < 256) i += 2;
  }
  return path;
}

std::string text_of_graphs(const HeldGraphs& graphs) {
  std::string text;
  std::map<std::string_view, std::size_t> numbers;  // of texts that stand there
  for (const auto& [family, by_place] : graphs) {
    text += fmt::format("#{} ", family);
    std::uint64_t next = 0;
    for (const auto& [place, line] : by_place) {
      if (place != next) text += fmt::format("@{} ", place);
      next = std::uint64_t{place} + 1;
      const auto [known, is_new] = numbers.try_emplace(line, numbers.size());
      text += is_new ? line : fmt::format("={}", known->second);
      text += ' ';
    }
  }
  return text;
}

HeldGraphs graphs_of_text(const std::string& text) {
  HeldGraphs graphs;
  std::map<std::uint32_t, std::string>* family = nullptr;
  std::vector<std::string> lines;
  std::uint32_t place = 0;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
    end = std::min(text.find(' ', at), text.size());
    const std::string_view word(text.data() + at, end - at);
    const char kind = word.empty() ? ' ' : word[0];
    std::uint32_t number = 0;
    const auto read = std::from_chars(text.data() + at + 1, text.data() + end, number);
    const bool is_number = read.ec == std::errc() && read.ptr == text.data() + end;
    const bool is_graph = kind == ':' || (kind == '=' && is_number && number < lines.size());
    if (kind == '#') {
      family = &graphs[std::string(word.substr(1))];
      place = 0;
    } else if (kind == '@' && is_number) {
      place = number;
    } else if (is_graph && family != nullptr) {
      if (kind == ':') lines.emplace_back(word);
      family->emplace(place++, kind == ':' ? lines.back() : lines[number]);
    } else {
      throw InputError(fmt::format("/graphs: '{}' is no word of it", word.substr(0, 40)));
    }
  }
  return graphs;
}

}  // namespace ar3d
