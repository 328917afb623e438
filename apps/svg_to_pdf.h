#pragma once

#include <string>

namespace ar3d {

/// Converts a file with rsvg-convert (Debian: librsvg2-bin); equal pictures give equal bytes.
/// @throws InputError if the program is missing or fails.
void convert_svg_to_pdf(const std::string& svg_path, const std::string& pdf_path);

}  // namespace ar3d
