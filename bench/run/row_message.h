#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ar3d/store/columns/run_record.h"

namespace ar3d {

/// Returns a row as one process sends it to another: checksum, tag and record. The checksum tells
/// it from what a program under test writes into descriptors that are not its own.
std::string row_message(char tag, const RunRecord& row);
/// Returns the number of its bytes, the same for every row.
std::size_t row_message_size();
/// Reads such bytes into `row`. @return the tag; nothing if they are no message.
std::optional<char> read_row_message(std::string_view bytes, RunRecord& row);

}  // namespace ar3d
