// THE JOURNAL, VERSION 3
//
// While a study runs, its rows are in journals beside the results file: NAME.h5.journal, and
// NAME.h5.rank-1.journal and so on of further ranks. A journal is a file of records, each one line:
//
//   {"rows":R,"not_ok":K,"KIND":PAYLOAD,"xxh3":"CHECKSUM"}
//
//   R         rows of the journal up to and with this record
//   K         how many of them are neither ok nor measured
//   KIND      what the record holds; it says what the payload is:
//     ar3d_journal   the study, {"version":3,"study_id":…,"spec":…,…}: the specification verbatim,
//                    the side tables [{"name":…,"columns":…,"records":[{…},…]},…] and the columns
//                    of rows, [[name, type, bytes], …]
//     session        [[name, value], …]: where the rows to come are made
//     row            {"row_key":…,…}: its columns in their order, without those that hold no value
//     session_end    as session: what is known only at the end
//   CHECKSUM  XXH3 (64 bits, hexadecimal digits) of the line's bytes before ,"xxh3", with the line's
//             offset in the file as seed: a record that was moved fails
//
// The first record is ar3d_journal, and a row belongs to the session before it. JSON is written and
// read by hand where there are millions: in heads of lines and in rows. Every number of a row reads
// back bit for bit; what is no finite number, and not missing, stands as the 16 hexadecimal digits
// of its bits.
//
// WRITING. One process has the file locked (F_OFD_SETLK) and appends each record by one write(2).
// A row is acknowledged when that call has returned; a thread calls fdatasync every second. Where
// locks do nothing a writer sees that its record does not stand at its offset, and ends.
//
// READING. Records count up to the first that is not whole. If no whole one stands behind it, it is
// what a crash has left: the next writer cuts it off, and keeps in NAME.h5.journal.cut-1 (-2, …)
// what is more than the beginning of one record. If a whole one does, the file is damaged: it is
// refused with the offset, and nothing is changed. Two ends tell the standing: the study is in the
// first record, R and K are in the last.
#include "ar3d/store/journal/journal_format.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/columns/side_tables.h"

namespace ar3d {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kKinds = {kIdentity, kSession, kRow, kSessionEnd};
constexpr std::string_view kChecksumKey = R"(,"xxh3":")";
constexpr std::size_t kTailSize = kChecksumKey.size() + 16 + 3;

std::string tail_of(std::string_view covered, std::uint64_t offset) {
  return fmt::format("{}{:016x}\"}}\n", kChecksumKey,
                     XXH3_64bits_withSeed(covered.data(), covered.size(), offset));
}

bool take(std::string_view& line, std::string_view word) {
  if (!line.starts_with(word)) return false;
  line.remove_prefix(word.size());
  return true;
}

// To memory that need not be aligned.
template <class Number, class... Base>
bool take_number(std::string_view& text, void* to, Base... base) {
  Number number{};
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), number, base...);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  std::memcpy(to, &number, sizeof(number));
  return error == std::errc();
}

// To the payload.
bool take_head(std::string_view& line, JournalRecord& record) {
  if (!take(line, kRecordStart) || !take_number<std::uint64_t>(line, &record.rows) ||
      !take(line, ",\"not_ok\":") || !take_number<std::uint64_t>(line, &record.not_ok) ||
      !take(line, ",\"")) {
    return false;
  }
  const std::string_view word = line.substr(0, line.find('"'));
  const auto* const kind = std::find(kKinds.begin(), kKinds.end(), word);
  if (kind == kKinds.end()) return false;
  record.kind = *kind;
  return take(line, word) && take(line, "\":");
}

Json as_json(const std::vector<Column>& columns) {
  Json json = Json::array();
  for (const Column& column : columns) {
    json.push_back({column.name, static_cast<int>(column.type), column.size});
  }
  return json;
}

// Environments come from the system, which knows no character set.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <class Read>
auto parsed(std::string_view text, const std::string& path, const Read& read) {
  try {
    return read(Json::parse(text.begin(), text.end()));
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: unreadable record: {}", path, error.what()));
  }
}

template <class Value>
Value value_at(const char* from) {
  Value value;
  std::memcpy(&value, from, sizeof(value));
  return value;
}

bool is_missing(const Column& column, const char* from) {
  if (column.type == ColumnType::text) return *from == 0;
  std::array<char, sizeof(std::uint64_t)> none{};
  store_missing(column, none.data());
  return std::memcmp(none.data(), from, none.size()) == 0;
}

void write_text(std::string_view text, const Column& column, std::string& json) {
  if (!all_printable(text)) throw InputError(column.name + " is not printable text");
  json += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  json += '"';
}

// JSON has no infinity: its bits are written then, in hexadecimal digits.
void write_value(const Column& column, const char* from, std::string& json) {
  const auto out = std::back_inserter(json);
  switch (column.type) {
    case ColumnType::text:
      return write_text({from, strnlen(from, column.size)}, column, json);
    case ColumnType::int64:
      fmt::format_to(out, "{}", value_at<std::int64_t>(from));
      return;
    case ColumnType::uint64:
      fmt::format_to(out, "{}", value_at<std::uint64_t>(from));
      return;
    case ColumnType::float64:
      const auto value = value_at<double>(from);
      if (!std::isfinite(value)) {
        fmt::format_to(out, "\"{:016x}\"", value_at<std::uint64_t>(from));
      } else if (value == 0) {
        json += std::signbit(value) ? "-0.0" : "0.0";  // -0 is an integer in JSON, without a sign
      } else {
        fmt::format_to(out, "{}", value);
      }
  }
}

// A text without its escapes. False if it has no end or is longer than its column.
bool take_text(std::string_view& json, const Column& column, char* to) {
  if (!take(json, "\"")) return false;
  std::size_t at = 0;
  for (std::size_t i = 0; at < json.size() && json[at] != '"'; ++i) {
    if (json[at] == '\\') ++at;
    if (at == json.size() || i == column.size) break;
    to[i] = json[at++];
  }
  json.remove_prefix(at);
  return take(json, "\"");
}

// A column's key with its colon, behind a comma unless it is the first one.
bool take_key(std::string_view& json, std::string_view name, bool is_first) {
  const std::size_t begin = is_first ? 1 : 2, end = begin + name.size();
  const bool is_it = json.size() > end + 1 && json.substr(begin, name.size()) == name &&
                     json.substr(0, begin) == (is_first ? "\"" : ",\"") && json[end] == '"' &&
                     json[end + 1] == ':';
  if (is_it) json.remove_prefix(end + 2);
  return is_it;
}

bool take_value(std::string_view& json, const Column& column, char* to) {
  switch (column.type) {
    case ColumnType::text:
      return take_text(json, column, to);
    case ColumnType::int64:
      return take_number<std::int64_t>(json, to);
    case ColumnType::uint64:
      return take_number<std::uint64_t>(json, to);
    case ColumnType::float64:
      break;
  }
  if (!take(json, "\"")) return take_number<double>(json, to);
  return take_number<std::uint64_t>(json, to, 16) && take(json, "\"");
}

Json tables_as_json(const StudyIdentity& identity) {
  Json tables = Json::array();
  for (const StoredTable& table : identity.tables) {
    Json records = Json::array();
    for (std::size_t i = 0; i < table.size(); ++i) {
      std::string record;
      write_record(table.columns, table.record(i), record);
      records.push_back(Json::parse(record));
    }
    tables.push_back({{"name", table.name},
                      {"columns", as_json(table.columns)},
                      {"records", std::move(records)}});
  }
  return tables;
}

std::vector<StoredTable> parse_tables(const Json& json, const std::string& path) {
  std::vector<StoredTable> tables;
  for (const Json& entry : json) {
    for (const StoredTable& spec : side_table_specs()) {
      if (entry.at("name") != spec.name || entry.at("columns") != as_json(spec.columns)) continue;
      const std::size_t size = record_size(spec.columns);
      tables.push_back(spec);
      tables.back().records.resize(size * entry.at("records").size());
      char* to = tables.back().records.data();
      for (const Json& record : entry.at("records")) {
        parse_record(spec.columns, record.dump(), path, std::exchange(to, to + size));
      }
    }
  }
  if (tables.size() != json.size()) {
    throw InputError(fmt::format("{}: it has tables that this program does not know", path));
  }
  return tables;
}

}  // namespace

bool begins_as_journal(std::string_view bytes) {
  return bytes.starts_with(kJournalStart) || bytes.starts_with("ar3d-journal ");
}

void frame_record(const JournalRecord& record, std::string& line) {
  line.clear();
  fmt::format_to(std::back_inserter(line), "{}{},\"not_ok\":{},\"{}\":{}", kRecordStart,
                 record.rows, record.not_ok, record.kind, record.payload);
  line += tail_of(line, record.offset);
}

std::optional<JournalRecord> parse_line(std::string_view line, std::uint64_t offset) {
  if (line.size() < kTailSize) return std::nullopt;
  const std::string_view covered = line.substr(0, line.size() - kTailSize);
  if (line.substr(covered.size()) != tail_of(covered, offset)) return std::nullopt;
  JournalRecord record;
  record.offset = offset;
  record.payload = covered;
  if (!take_head(record.payload, record)) return std::nullopt;
  record.payload_offset = offset + covered.size() - record.payload.size();
  return record;
}

bool is_cut_short(std::string_view bytes) {
  if (bytes.size() <= kRecordStart.size()) return kRecordStart.starts_with(bytes);
  const std::size_t tail = bytes.find(kChecksumKey);
  return bytes.rfind(kRecordStart) == 0 && bytes.find('\n') == bytes.npos &&
         bytes.find('\0') == bytes.npos && (tail == bytes.npos || bytes.size() < tail + kTailSize);
}

void write_record(const std::vector<Column>& columns, const char* record, std::string& json) {
  json += '{';
  for (const Column& column : columns) {
    const char* from = record + column.offset;
    if (is_missing(column, from)) continue;
    json.append(json.back() == '{' ? "\"" : ",\"").append(column.name).append("\":");
    write_value(column, from, json);
  }
  json += '}';
}

void parse_record(const std::vector<Column>& columns, std::string_view json,
                  const std::string& path, char* record) {
  bool is_good = take(json, "{"), is_first = true;
  for (const Column& column : columns) {
    char* to = record + column.offset;
    store_missing(column, to);
    if (!take_key(json, column.name, is_first)) continue;
    is_good = is_good && take_value(json, column, to);
    is_first = false;
  }
  if (is_good && json == "}") return;
  throw InputError(fmt::format("{}: a record is none of its table from '{}' on", path,
                               printable(json.substr(0, 40))));
}

std::string identity_text(const StudyIdentity& identity) {
  return dumped({{"version", 3},
                 {"study_id", identity.study_id},
                 {"spec", identity.spec},
                 {"spec_hash", identity.spec_hash},
                 {"source_hash", identity.source_hash},
                 {"dirty", identity.dirty},
                 {"dirty_hash", identity.dirty_hash},
                 {"created", identity.created},
                 {"shard", {identity.shard.index, identity.shard.count}},
                 {"planned_rows", identity.planned_rows},
                 {"tables", tables_as_json(identity)},
                 {"columns", as_json(runs_spec().columns)}});
}

StudyIdentity parse_identity(std::string_view text, const std::string& path) {
  return parsed(text, path, [&](const Json& json) {
    StudyIdentity identity;
    json.at("source_hash").get_to(identity.source_hash);
    if (json.at("columns") != as_json(runs_spec().columns)) {
      throw InputError(
          fmt::format("{}: its rows have other columns; it was written by the program of source {}",
                      path, identity.source_hash));
    }
    json.at("study_id").get_to(identity.study_id);
    json.at("spec").get_to(identity.spec);
    json.at("spec_hash").get_to(identity.spec_hash);
    json.at("dirty").get_to(identity.dirty);
    json.at("dirty_hash").get_to(identity.dirty_hash);
    json.at("created").get_to(identity.created);
    const std::string shard =
        fmt::format("{}/{}", json.at("shard").at(0).dump(), json.at("shard").at(1).dump());
    if (!parse_shard(shard)) throw InputError(fmt::format("{}: {} is no shard", path, shard));
    identity.shard = *parse_shard(shard);
    json.at("planned_rows").get_to(identity.planned_rows);
    if (!json.at("planned_rows").is_number_integer() || identity.planned_rows < -1) {
      throw InputError(fmt::format("{}: planned_rows is not a number in range", path));
    }
    identity.tables = parse_tables(json.at("tables"), path);
    return identity;
  });
}

std::string session_text(const std::vector<EnvironmentEntry>& environment) {
  Json json = Json::array();
  for (const EnvironmentEntry& entry : environment) json.push_back({entry.name, entry.value});
  return dumped(json);
}

std::vector<EnvironmentEntry> parse_session(std::string_view text, const std::string& path) {
  return parsed(text, path, [](const Json& json) {
    std::vector<EnvironmentEntry> environment;
    for (const Json& entry : json) {
      environment.push_back({entry.at(0).get<std::string>(), entry.at(1).get<std::string>()});
    }
    return environment;
  });
}

}  // namespace ar3d
