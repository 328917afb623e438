#include "support/comments.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

namespace ar3d::testing {
namespace {

void blank(std::string& in, std::size_t from, std::size_t to) {
  for (std::size_t i = from; i < to; ++i) in[i] = in[i] == '\n' ? '\n' : ' ';
}

/// The end of the string or character literal that begins at `at`.
std::size_t end_of_literal(const std::string& text, std::size_t at) {
  if (text[at] == '"' && at > 0 && text[at - 1] == 'R') {
    const std::size_t open = text.find('(', at);
    const std::string close = ")" + text.substr(at + 1, open - at - 1) + "\"";
    return std::min(text.size(), text.find(close, open) + close.size());
  }
  std::size_t end = at + 1;
  while (end < text.size() && text[end] != text[at]) end += text[end] == '\\' ? 2 : 1;
  return std::min(text.size(), end + 1);
}

std::size_t end_of_comment(const std::string& text, std::size_t at) {
  const bool block = text[at + 1] == '*';
  const std::size_t end = text.find(block ? "*/" : "\n", at + 2);
  return end == std::string::npos ? text.size() : end + (block ? 2 : 0);
}

TextParts parts_with_slashes(const std::string& text, const std::string& quotes) {
  TextParts result{text, text};
  for (std::size_t at = 0; at < text.size();) {
    const char next = at + 1 < text.size() ? text[at + 1] : '\0';
    const bool digits = at > 0 && std::isalnum(static_cast<unsigned char>(text[at - 1])) != 0;
    std::size_t end = at + 1;
    if (text[at] == '/' && (next == '/' || next == '*')) {
      end = end_of_comment(text, at);
      blank(result.code, at, end);
      for (std::size_t i = at; i < end && text[i] == '/'; ++i) result.comments[i] = ' ';
    } else {
      const bool opens = quotes.find(text[at]) != std::string::npos;
      if (opens && (text[at] != '\'' || !digits)) end = end_of_literal(text, at);
      blank(result.comments, at, end);
    }
    at = end;
  }
  return result;
}

/// A # begins a comment at the start of a line or behind a blank, unless it is in quotes that began
/// in the line.
TextParts parts_with_hashes(const std::string& text, bool python) {
  TextParts result{text, text};
  char quote = '\0';
  for (std::size_t at = 0; at < text.size();) {
    const bool apart = at == 0 || std::isspace(static_cast<unsigned char>(text[at - 1])) != 0;
    std::size_t end = at + 1;
    if (python && quote == '\0' && text.compare(at, 3, "\"\"\"") == 0) {
      end = std::min(text.size(), text.find("\"\"\"", at + 3));
      blank(result.code, at, end);
      blank(result.comments, at, at + 3);
      end = std::min(text.size(), end + 3);
      blank(result.comments, end - 3, end);
    } else if (text[at] == '#' && apart && quote == '\0') {
      end = std::min(text.size(), text.find('\n', at));
      blank(result.code, at, end);
      result.comments[at] = ' ';
    } else {
      blank(result.comments, at, end);
      if (text[at] == '\n' || text[at] == quote) {
        quote = '\0';
      } else if (quote == '\0' && (text[at] == '"' || text[at] == '\'')) {
        quote = text[at];
      } else if (text[at] == '\\') {
        ++end;
        blank(result.comments, at, std::min(text.size(), end));
      }
    }
    at = end;
  }
  return result;
}

std::string blanked(std::string text) {
  blank(text, 0, text.size());
  return text;
}

}  // namespace

TextParts parts_of(const std::string& path, const std::string& text) {
  static const std::set<std::string> slashes = {".h", ".cpp", ".js", ".mjs", ".css"};
  static const std::set<std::string> hashes = {".py", ".cmake", ".sh"};
  const std::string ending = std::filesystem::path(path).extension();
  if (ending == ".md") return {text, blanked(text)};
  if (slashes.contains(ending)) {
    return parts_with_slashes(text, ending == ".js" || ending == ".mjs" ? "\"'`" : "\"'");
  }
  const bool script = hashes.contains(ending) || path.ends_with("CMakeLists.txt") ||
                      (ending.empty() && text.starts_with("#!"));
  if (script)
    return parts_with_hashes(text, ending == ".py" || text.starts_with("#!/usr/bin/env p"));
  return {blanked(text), text};
}

}  // namespace ar3d::testing
