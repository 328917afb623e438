#pragma once

#include <string>

namespace ar3d::testing {

/// A text cut into what people and what compilers read; each part has the other's characters
/// blanked, so that offsets and lines stay.
struct TextParts {
  std::string comments;
  std::string code;
};

/// Comments of C++, JavaScript and style sheets (// and /* */), and of Python, CMake and shell (#,
/// and Python's texts in triple quotes). A page is all comment; any other file is all code.
/// @param path  tells the language by its ending, a file without one by its first line.
TextParts parts_of(const std::string& path, const std::string& text);

}  // namespace ar3d::testing
