#pragma once

#include <string>

namespace ar3d::report {

/// analysis/report/page.css, page.js and figure.css, byte for byte: style and script of the page,
/// and the style of a figure that is a document of its own.
std::string page_style();
std::string page_script();
/// analysis/report/tables.js: sorting of tables and what a page of a history needs besides.
std::string table_script();
std::string figure_style();

}  // namespace ar3d::report
