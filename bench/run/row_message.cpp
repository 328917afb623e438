// Rows on their way from one process to another, worker or rank.
#include "ar3d/bench/run/row_message.h"

#include <xxhash.h>

#include <cstring>

#include "ar3d/store/columns/run_columns.h"

namespace ar3d {
namespace {

constexpr std::size_t kHead = sizeof(std::uint64_t);  // of the checksum

std::uint64_t checksum_of(std::string_view message) {
  return XXH3_64bits(message.data() + kHead, message.size() - kHead);
}

}  // namespace

std::size_t row_message_size() { return kHead + 1 + run_record_size(); }

std::string row_message(char tag, const RunRecord& row) {
  std::string message(row_message_size(), '\0');
  message[kHead] = tag;
  store_record(row, message.data() + kHead + 1);
  const std::uint64_t checksum = checksum_of(message);
  std::memcpy(message.data(), &checksum, kHead);
  return message;
}

std::optional<char> read_row_message(std::string_view bytes, RunRecord& row) {
  std::uint64_t checksum = 0;
  if (bytes.size() != row_message_size()) return std::nullopt;
  std::memcpy(&checksum, bytes.data(), kHead);
  if (checksum != checksum_of(bytes)) return std::nullopt;
  row = load_record(bytes.data() + kHead + 1);
  return bytes[kHead];
}

}  // namespace ar3d
