// A journal's lines and what stands in them as JSON: rows, tables, the study's identity, sessions.
// Rows and heads of lines are written and read by hand, since there are millions of them.
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

constexpr std::array<std::string_view, 4> kKinds = {"ar3d_journal", "session", "row",
                                                    "session_end"};
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
  record.kind = static_cast<JournalKind>(kind - kKinds.begin());
  return kind != kKinds.end() && take(line, word) && take(line, "\":");
}

Json as_json(const std::vector<Field>& fields) {
  Json columns = Json::array();
  for (const Field& field : fields) {
    columns.push_back({field.name, static_cast<int>(field.type), field.size});
  }
  return columns;
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

bool is_missing(const Field& field, const char* from) {
  if (field.type == FieldType::text) return *from == 0;
  std::array<char, sizeof(std::uint64_t)> none{};
  store_missing(field, none.data());
  return std::memcmp(none.data(), from, none.size()) == 0;
}

void write_text(std::string_view text, const Field& field, std::string& json) {
  if (!all_printable(text)) throw InputError(field.name + " is no printable text");
  json += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    json += c;
  }
  json += '"';
}

// JSON has no infinity: its bits are written then, in hexadecimal digits.
void write_value(const Field& field, const char* from, std::string& json) {
  const auto out = std::back_inserter(json);
  switch (field.type) {
    case FieldType::text:
      return write_text({from, strnlen(from, field.size)}, field, json);
    case FieldType::int64:
      fmt::format_to(out, "{}", value_at<std::int64_t>(from));
      return;
    case FieldType::uint64:
      fmt::format_to(out, "{}", value_at<std::uint64_t>(from));
      return;
    case FieldType::float64:
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

// A text without its escapes. False if it has no end or is longer than its field.
bool take_text(std::string_view& json, const Field& field, char* to) {
  if (!take(json, "\"")) return false;
  for (std::size_t i = 0; i <= field.size; ++i) {
    if (take(json, "\"")) return true;
    take(json, "\\");
    if (json.empty() || i == field.size) return false;
    to[i] = json.front();
    json.remove_prefix(1);
  }
  return false;
}

bool take_value(std::string_view& json, const Field& field, char* to) {
  switch (field.type) {
    case FieldType::text:
      return take_text(json, field, to);
    case FieldType::int64:
      return take_number<std::int64_t>(json, to);
    case FieldType::uint64:
      return take_number<std::uint64_t>(json, to);
    case FieldType::float64:
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
      write_record(table.spec.fields, table.record(i), record);
      records.push_back(Json::parse(record));
    }
    tables.push_back({{"name", table.spec.name},
                      {"columns", as_json(table.spec.fields)},
                      {"records", std::move(records)}});
  }
  return tables;
}

std::vector<StoredTable> parse_tables(const Json& json, const std::string& path) {
  std::vector<StoredTable> tables;
  for (const Json& entry : json) {
    for (const TableSpec& spec : side_table_specs()) {
      if (entry.at("name") != spec.name || entry.at("columns") != as_json(spec.fields)) continue;
      const std::size_t size = record_size(spec.fields);
      tables.push_back({spec, std::vector<char>(size * entry.at("records").size())});
      char* to = tables.back().records.data();
      for (const Json& record : entry.at("records")) {
        parse_record(spec.fields, record.dump(), path, std::exchange(to, to + size));
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
                 record.rows, record.not_ok, kKinds[static_cast<std::size_t>(record.kind)],
                 record.payload);
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

void write_record(const std::vector<Field>& fields, const char* record, std::string& json) {
  json += '{';
  for (const Field& field : fields) {
    const char* from = record + field.offset;
    if (is_missing(field, from)) continue;
    json.append(json.back() == '{' ? "\"" : ",\"").append(field.name).append("\":");
    write_value(field, from, json);
  }
  json += '}';
}

void parse_record(const std::vector<Field>& fields, std::string_view json, const std::string& path,
                  char* record) {
  std::string key;
  bool is_good = take(json, "{");
  for (const Field& field : fields) {
    char* to = record + field.offset;
    store_missing(field, to);
    key.append("\"").append(field.name).append("\":");
    if (take(json, key)) {
      is_good = is_good && take_value(json, field, to);
      key.assign(1, ',');
    } else {
      key.resize(key.starts_with(',') ? 1 : 0);
    }
  }
  if (is_good && json == "}") return;
  throw InputError(fmt::format("{}: a record is none of its table from '{}' on", path,
                               printable(json.substr(0, 40))));
}

RowKey key_of_row(std::string_view json) {
  return parse_row_key(take(json, R"({"row_key":")") ? json.substr(0, 32) : "");
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
                 {"columns", as_json(runs_spec().fields)}});
}

StudyIdentity parse_identity(std::string_view text, const std::string& path) {
  return parsed(text, path, [&](const Json& json) {
    StudyIdentity identity;
    json.at("source_hash").get_to(identity.source_hash);
    if (json.at("columns") != as_json(runs_spec().fields)) {
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
