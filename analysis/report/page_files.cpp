#include "ar3d/analysis/report/page_files.h"

#include "ar3d_page_files.h"

namespace ar3d::report {

std::string page_style() { return std::string(kPageStyle); }
std::string page_script() { return std::string(kPageScript); }
std::string table_script() { return std::string(kTableScript); }
std::string figure_style() { return std::string(kFigureStyle); }

}  // namespace ar3d::report
