#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"

namespace ar3d::fuzz {

inline std::string rewritten(std::string text) {
  DrawingJsonlReader reader(TextInput("fuzz", bytes_of(std::move(text))));
  std::string result;
  while (const auto line = reader.next()) {
    if (const auto* drawing = std::get_if<Drawing>(&*line)) {
      append_drawing_line(result, *drawing);
    } else {
      append_error_line(result, std::get<UndrawnGraph>(*line));
    }
  }
  return result;
}

/// Any bytes either are refused with one line, or give drawings whose written lines give the same
/// lines again. Throws std::logic_error otherwise.
inline void check_drawings(std::string text) {
  std::string lines;
  try {
    lines = rewritten(std::move(text));
  } catch (const InputError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) {
      throw std::logic_error("a message has one line");
    }
    return;
  }
  if (!lines.empty() && rewritten(lines) != lines) {
    throw std::logic_error("the written lines give themselves again");
  }
}

}  // namespace ar3d::fuzz
