#pragma once

#include <string>

#include "ar3d/store/columns/side_tables.h"

namespace ar3d {

/// A path as tables hold it: %XX for bytes that are no printable ASCII; and back, where what is no
/// code stays as it is.
std::string encoded(const std::string& path);
std::string decoded(const std::string& text);

/// The text of /graphs, each graph once; and back. @throws InputError naming what is no word of it.
std::string text_of_graphs(const HeldGraphs& graphs);
HeldGraphs graphs_of_text(const std::string& text);

}  // namespace ar3d
