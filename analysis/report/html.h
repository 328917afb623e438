#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ar3d::report {

/// Text for element contents and quoted attributes: valid UTF-8, the five special characters
/// escaped, control characters but newline and tab replaced. Every string of a results file goes
/// through here.
std::string escape(std::string_view text);

/// A JSON string that may stand in a script element: no byte of it can end the element. ASCII.
std::string json_string(std::string_view text);

/// "1,234,567"
std::string grouped(std::int64_t value);
/// "215", "4.6k", "46k": a number of vertices where there is little room.
std::string short_count(std::int64_t value);
/// "93.1 %"; "–" if missing.
std::string percent(double share);
/// Three significant digits; "–" if missing.
std::string number(double value);
/// "1.23 µs", "45.6 ms", "7.8 s"; "–" if missing.
std::string duration(double seconds);

/// A sortable table up to its first row. @param columns  their names in HTML, behind '#' those of
/// numbers.
std::string table_head(const std::vector<std::string>& columns);
/// A row up to its second cell; the first one names it. @param text  plain.
std::string row_head(std::string_view text);
/// A wide <td> of prose.
std::string note(const std::string& html);
/// A <td>; numbers are right-aligned. `html` is trusted markup, not text.
std::string cell(const std::string& html, bool is_number = false);

/// analysis/report/page.css, page.js and figure.css, byte for byte: style and script of the page,
/// and the style of a figure that is a document of its own.
std::string page_style();
std::string page_script();
/// analysis/report/tables.js: sorting of tables and what a page of a history needs besides.
std::string table_script();
std::string figure_style();

}  // namespace ar3d::report
