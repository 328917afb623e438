# Writes ar3d_page_files.h: the files of the report's page as texts. Included by analysis/CMakeLists.txt.
ar3d_text_literal(${CMAKE_CURRENT_SOURCE_DIR}/report/page.css page_style)
ar3d_text_literal(${CMAKE_CURRENT_SOURCE_DIR}/report/page.js page_script)
ar3d_text_literal(${CMAKE_CURRENT_SOURCE_DIR}/report/tables.js table_script)
ar3d_text_literal(${CMAKE_CURRENT_SOURCE_DIR}/report/figure.css figure_style)
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/ar3d_page_files.h @ONLY CONTENT
"// Made from analysis/report/*.css and *.js by analysis/report/embed_files.cmake.
#include <string_view>
namespace ar3d::report {
inline constexpr std::string_view kPageStyle = @page_style@;
inline constexpr std::string_view kPageScript = @page_script@;
inline constexpr std::string_view kTableScript = @table_script@;
inline constexpr std::string_view kFigureStyle = @figure_style@;
}  // namespace ar3d::report
")
