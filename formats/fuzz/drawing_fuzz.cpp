// Any bytes either are refused with one line, or give drawings whose written lines give the same
// lines again.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <variant>

#include "ar3d/formats/drawing_jsonl.h"
#include "ar3d/model/error.h"

namespace {

std::string rewritten(std::string text) {
  ar3d::DrawingJsonlReader reader(ar3d::TextInput("fuzz", ar3d::bytes_of(std::move(text))));
  std::string result;
  while (const auto line = reader.next()) {
    if (const auto* drawing = std::get_if<ar3d::Drawing>(&*line)) {
      ar3d::append_drawing_line(result, *drawing);
    } else {
      ar3d::append_error_line(result, std::get<ar3d::UndrawnGraph>(*line));
    }
  }
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string lines;
  try {
    lines = rewritten({reinterpret_cast<const char*>(data), size});
  } catch (const ar3d::InputError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
    return 0;
  }
  if (!lines.empty() && rewritten(lines) != lines) std::abort();
  return 0;
}
