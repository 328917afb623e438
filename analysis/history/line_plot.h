#pragma once

#include <string>

#include "ar3d/analysis/history/history.h"

namespace ar3d {

/// A figure of a line: values against commits, its levels, and every change with where it may lie.
std::string line_figure(const History& history, const HistoryLine& line);

/// A small picture of the same for a table. A click on it makes it large (page.js).
std::string sparkline(const History& history, const HistoryLine& line);

}  // namespace ar3d
