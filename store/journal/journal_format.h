#pragma once

// What writer and reader of a journal share. The page results/JOURNAL.md describes it.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ar3d/store/columns/row_format.h"
#include "ar3d/store/study_identity.h"

namespace ar3d {

inline constexpr char kJournalMagic[] = "ar3d-journal 2\n";  ///< 16 bytes with the null

inline constexpr std::uint32_t kLargestPayload = 1u << 26;

enum class JournalKind : std::uint32_t { identity = 1, session = 2, row = 3, session_end = 4 };

/// Stands before every payload. `checksum` is XXH3 of everything behind itself up to the payload's
/// end, with the record's offset as seed: a record that was moved is damaged too.
struct JournalHead {
  std::uint64_t checksum = 0;
  std::uint32_t payload_size = 0;
  JournalKind kind = JournalKind::row;
  std::uint64_t rows = 0;    ///< in the journal up to and with this record
  std::uint64_t not_ok = 0;  ///< of them, with another status than ok or measured
};
static_assert(sizeof(JournalHead) == 32);

struct JournalRecord {
  JournalHead head;
  std::uint64_t offset = 0;
  std::span<const char> payload;  ///< valid during the visit
};

/// A record's bytes, ready for one write at `offset`.
void frame_record(JournalHead head, std::span<const char> payload, std::uint64_t offset,
                  std::vector<char>& bytes);

/// Calls `visit` for every record, to the first that is not whole or for which it returns false.
/// @return the end of the last whole record; what is behind it is a record cut short by a crash.
/// @throws InputError naming file and offset if whole records follow behind a damaged one, if the
/// file cannot be read, or if it is no journal.
std::uint64_t scan_journal(int file, const std::string& path,
                           const std::function<bool(const JournalRecord&)>& visit);

/// The last whole record, found from the file's end in bounded time, however long the file is.
/// @throws InputError as scan_journal.
JournalHead last_journal_record(int file, const std::string& path);

/// A record without its padding: for every field 8 bytes, or two bytes of length and text. The
/// result lies in `buffer`, which keeps the size that any row fits in.
std::span<const char> pack_row(const RowFormat& format, const char* record,
                               std::vector<char>& buffer);
/// @throws InputError if the bytes are no packed row.
void unpack_row(const RowFormat& format, std::span<const char> packed, char* record);
RowKey packed_row_key(const RowFormat& format, std::span<const char> packed);

/// The study's identity with its tables, and the columns that the rows have, as JSON.
std::string identity_text(const StudyIdentity& identity, const RowFormat& format);
/// @throws InputError naming `path` if it is not the identity of a study with the format's columns.
StudyIdentity parse_identity(std::span<const char> text, const RowFormat& format,
                             const std::string& path);

std::string session_text(const std::vector<EnvironmentEntry>& environment);
/// @throws InputError naming `path`.
std::vector<EnvironmentEntry> parse_session(std::span<const char> text, const std::string& path);

}  // namespace ar3d
