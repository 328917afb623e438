#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/formats/drawings/drawing_events.h"
#include "ar3d/formats/drawings/drawing_jsonl.h"
#include "ar3d/formats/text/line_shapes.h"

namespace ar3d {

DrawingJsonlReader::DrawingJsonlReader(const std::string& path)
    : DrawingJsonlReader(TextInput(path)) {}

DrawingJsonlReader::DrawingJsonlReader(TextInput input)
    : input_(std::make_unique<TextInput>(std::move(input))) {
  if (input_->look_ahead_line().empty()) {
    throw InputError(fmt::format("{}: empty file: no drawing in it", input_->name()));
  }
}

std::optional<DrawingJsonlReader::Line> DrawingJsonlReader::next() {
  while (const std::optional<std::string_view> line = input_->next_line()) {
    if (is_blank(*line)) continue;
    try {
      DrawingEvents events;
      nlohmann::json::sax_parse(line->begin(), line->end(), &events);
      return events.finish();
    } catch (const SyntaxError& error) {
      input_->fail(error.column, error.what());
    } catch (const InputError& error) {
      input_->fail(0, error.what());
    }
  }
  return std::nullopt;
}

std::string DrawingJsonlReader::where() const {
  return fmt::format("{}:{}", input_->name(), input_->line());
}

}  // namespace ar3d
