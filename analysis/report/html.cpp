// Text and numbers as HTML, and the page's own files. Every foreign string goes through escape().
#include "ar3d/analysis/report/html.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ar3d/base/printable.h"
#include "ar3d_page_files.h"

namespace ar3d::report {

namespace {
constexpr const char* kNothing = "–";
}  // namespace

std::string escape(std::string_view text) {
  std::string escaped;
  for (const char c : valid_utf8(text)) {
    const auto code = static_cast<unsigned char>(c);
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        if ((code < 0x20 && c != '\n' && c != '\t') || code == 0x7F) {
          escaped += "\uFFFD";
        } else {
          escaped += c;
        }
    }
  }
  return escaped;
}

std::string grouped(std::int64_t value) {
  const std::string digits = std::to_string(value);
  const std::size_t first = value < 0 ? 1 : 0;
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > first && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

std::string json_string(std::string_view text) {
  std::string json;
  for (const char c : nlohmann::json(valid_utf8(text)).dump(-1, ' ', true)) {
    const bool is_special = c == '<' || c == '>' || c == '&';
    json += is_special ? fmt::format("\\u{:04x}", static_cast<int>(c)) : std::string(1, c);
  }
  return json;
}

std::string short_count(std::int64_t value) {
  const auto rounded = [](double number) {
    const std::string text = fmt::format("{:.{}f}", number, number < 9.95 ? 1 : 0);
    return text.ends_with(".0") ? text.substr(0, text.size() - 2) : text;
  };
  const auto number = static_cast<double>(value);
  if (value < 1000) return std::to_string(value);
  return value < 1000000 ? rounded(number / 1e3) + "k" : rounded(number / 1e6) + "M";
}

std::string percent(double share) {
  return std::isnan(share) ? kNothing : fmt::format("{:.1f} %", 100 * share);
}

std::string number(double value) {
  return std::isnan(value) ? kNothing : fmt::format("{:.3g}", value);
}

std::string duration(double seconds) {
  if (std::isnan(seconds)) return kNothing;
  const double size = std::abs(seconds);
  if (size < 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
  if (size < 1e-3) return fmt::format("{:.3g} µs", seconds * 1e6);
  if (size < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

std::string table_head(const std::vector<std::string>& columns) {
  std::string html = "<div class=scroll><table class=sortable><thead><tr>";
  for (const std::string& name : columns) {
    html += name.starts_with('#') ? "<th class=num>" + name.substr(1) : "<th>" + name;
  }
  return html + "</tr></thead><tbody>\n";
}

std::string row_head(std::string_view text) {
  return "<tr><th scope=row>" + escape(text) + "</th>";
}

std::string note(const std::string& html) { return "<td class=note>" + html + "</td>"; }

std::string cell(const std::string& html, bool is_number) {
  return (is_number ? "<td class=num>" : "<td>") + html + "</td>";
}

std::string page_style() { return std::string(kPageStyle); }
std::string page_script() { return std::string(kPageScript); }
std::string table_script() { return std::string(kTableScript); }
std::string figure_style() { return std::string(kFigureStyle); }

}  // namespace ar3d::report
