#pragma once

// What writer and reader of a journal share. The page results/JOURNAL.md describes it.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ar3d/store/columns/study_identity.h"
#include "ar3d/store/columns/table.h"

namespace ar3d {

/// Stands at the beginning of every record, and holds it nowhere else.
inline constexpr std::string_view kRecordStart = R"({"rows":)";
/// Stands at the beginning of a journal.
inline constexpr std::string_view kJournalStart =
    R"({"rows":0,"not_ok":0,"ar3d_journal":{"version":3,)";

/// Returns true of the first bytes of a journal, also of one of an older version.
bool begins_as_journal(std::string_view bytes);

/// Name the kinds of records, as the keys of their content in the line.
inline constexpr std::string_view kIdentity = "ar3d_journal", kSession = "session", kRow = "row",
                                  kSessionEnd = "session_end";

/// Describes a line.
struct JournalRecord {
  std::string_view kind = kRow;
  std::uint64_t rows = 0;    ///< in the journal up to and with this record
  std::uint64_t not_ok = 0;  ///< of them, with another status than ok or measured
  std::uint64_t offset = 0;  ///< of its line
  std::uint64_t payload_offset = 0;
  std::string_view payload = {};  ///< JSON; valid during the visit
};

/// Writes a record's line, which is to stand at its offset: a moved one fails its checksum.
void frame_record(const JournalRecord& record, std::string& line);

/// Returns the record of a line that ends with a newline; none if it is not whole.
std::optional<JournalRecord> parse_line(std::string_view line, std::uint64_t offset);

/// Returns true if the bytes are the beginning of one record, or all of it but the newline.
bool is_cut_short(std::string_view bytes);

/// Calls `visit` for every record, to the first that is not whole or for which it returns false.
/// @return the end of the last whole record; what is behind it is a record cut short by a crash.
/// @throws InputError naming file and offset if whole records follow behind a damaged one, if the
/// file cannot be read, or if it is no journal.
std::uint64_t scan_journal(int file, const std::string& path,
                           const std::function<bool(const JournalRecord&)>& visit);

/// Returns the last whole record without its payload, found from the file's end in bounded time,
/// however long the file is; one without rows if there is none. @throws InputError as scan_journal.
JournalRecord last_journal_record(int file, const std::string& path);

/// Appends a record as a JSON object of its columns, without those that hold what stands for no
/// value. Every number reads back bit for bit. @throws InputError if a text is not printable.
void write_record(const std::vector<Column>& columns, const char* record, std::string& json);
/// Reads what write_record() has written; anything else is refused, other JSON too.
/// @throws InputError naming `path` and the place.
void parse_record(const std::vector<Column>& columns, std::string_view json,
                  const std::string& path, char* record);

/// Returns the study's identity with its tables, and the columns that the rows have, as JSON.
std::string identity_text(const StudyIdentity& identity);
/// @throws InputError naming `path` if it is not the identity of a study with this program's
/// columns.
StudyIdentity parse_identity(std::string_view text, const std::string& path);

std::string session_text(const std::vector<EnvironmentEntry>& environment);
/// @throws InputError naming `path`.
std::vector<EnvironmentEntry> parse_session(std::string_view text, const std::string& path);

}  // namespace ar3d
