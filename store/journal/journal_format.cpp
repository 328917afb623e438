#include "ar3d/store/journal/journal_format.h"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

using Json = nlohmann::json;

// Takes `count` bytes from the front.
std::span<const char> take(std::span<const char>& bytes, std::size_t count) {
  if (bytes.size() < count) throw InputError("a row of the journal ends too early");
  const std::span<const char> taken = bytes.first(count);
  bytes = bytes.subspan(count);
  return taken;
}

Json as_json(const std::vector<Field>& fields) {
  Json columns = Json::array();
  for (const Field& field : fields) {
    columns.push_back({field.name, static_cast<int>(field.type), field.size});
  }
  return columns;
}

constexpr const char* kDigits = "0123456789abcdef";

std::string hexadecimal(const std::vector<char>& bytes) {
  std::string text;
  text.reserve(2 * bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

std::vector<char> parse_hexadecimal(const std::string& text, const std::string& path) {
  std::vector<char> bytes;
  bytes.reserve(text.size() / 2);
  const std::string_view digits(kDigits);
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const std::size_t high = digits.find(text[i]);
    const std::size_t low = i + 1 < text.size() ? digits.find(text[i + 1]) : digits.npos;
    if (high == digits.npos || low == digits.npos) {
      throw InputError(fmt::format("{}: a table is not written in hexadecimal bytes", path));
    }
    bytes.push_back(static_cast<char>(16 * high + low));
  }
  return bytes;
}

Json tables_as_json(const StudyIdentity& identity) {
  Json tables = Json::array();
  for (const StoredTable& table : identity.tables) {
    tables.push_back({{"name", table.spec.name},
                      {"columns", as_json(table.spec.fields)},
                      {"records", hexadecimal(table.records)}});
  }
  return tables;
}

// A number that is what it claims to be: JSON's own conversions wrap and cut.
template <class Integer>
Integer whole_number(const Json& json, const char* what, const std::string& path) {
  if (json.is_number_unsigned() && std::in_range<Integer>(json.get<std::uint64_t>())) {
    return static_cast<Integer>(json.get<std::uint64_t>());
  }
  if (json.is_number_integer() && !json.is_number_unsigned() &&
      std::in_range<Integer>(json.get<std::int64_t>())) {
    return static_cast<Integer>(json.get<std::int64_t>());
  }
  throw InputError(fmt::format("{}: {} is not a number in range", path, what));
}

// Environments come from the system, which knows no character set.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <class Read>
auto parsed(std::span<const char> text, const std::string& path, const Read& read) {
  try {
    return read(Json::parse(text.begin(), text.end()));
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: unreadable description: {}", path, error.what()));
  }
}

}  // namespace

std::span<const char> pack_row(const RowFormat& format, const char* record,
                               std::vector<char>& buffer) {
  const std::vector<Field>& fields = format.rows.fields;
  buffer.resize(format.record_size() + fields.size() * sizeof(std::uint16_t));  // the most
  char* to = buffer.data();
  const auto append = [&to](const void* from, std::size_t count) {
    std::memcpy(to, from, count);
    to += count;
  };
  for (const Field& field : fields) {
    const char* from = record + field.offset;
    if (field.type != FieldType::text) {
      append(from, sizeof(std::uint64_t));
      continue;
    }
    const auto length = static_cast<std::uint16_t>(strnlen(from, field.size));
    append(&length, sizeof(length));
    append(from, length);
  }
  return {buffer.data(), to};
}

void unpack_row(const RowFormat& format, std::span<const char> packed, char* record) {
  for (const Field& field : format.rows.fields) {
    char* to = record + field.offset;
    if (field.type != FieldType::text) {
      std::memcpy(to, take(packed, field.size).data(), field.size);
      continue;
    }
    std::uint16_t length = 0;
    std::memcpy(&length, take(packed, sizeof(length)).data(), sizeof(length));
    if (length > field.size) throw InputError("a row of the journal holds too long a text");
    std::memset(to, 0, field.size);
    std::memcpy(to, take(packed, length).data(), length);
  }
  if (!packed.empty()) throw InputError("a row of the journal is too long");
}

RowKey packed_row_key(const RowFormat& format, std::span<const char> packed) {
  expect(format.key == 0, "a row begins with its key");
  take(packed, sizeof(std::uint16_t));
  const std::size_t size = format.rows.fields.front().size;
  return parse_row_key({take(packed, size).data(), size});
}

std::string identity_text(const StudyIdentity& identity, const RowFormat& format) {
  return dumped({{"study_id", identity.study_id},
                 {"spec", identity.spec},
                 {"spec_hash", identity.spec_hash},
                 {"source_hash", identity.source_hash},
                 {"dirty", identity.dirty},
                 {"dirty_hash", identity.dirty_hash},
                 {"created", identity.created},
                 {"shard", {identity.shard.index, identity.shard.count}},
                 {"planned_rows", identity.planned_rows},
                 {"tables", tables_as_json(identity)},
                 {"columns", as_json(format.rows.fields)}});
}

namespace {

Shard parse_shard(const Json& json, const std::string& path) {
  const Shard shard{whole_number<std::uint32_t>(json.at(0), "the shard", path),
                    whole_number<std::uint32_t>(json.at(1), "the shard", path)};
  if (!is_shard(shard)) {
    throw InputError(fmt::format("{}: {}/{} is no shard", path, shard.index, shard.count));
  }
  return shard;
}

std::vector<StoredTable> parse_tables(const Json& json, const RowFormat& format,
                                      const std::string& path) {
  std::vector<StoredTable> tables;
  for (const Json& entry : json) {
    for (const TableSpec& spec : format.tables) {
      if (entry.at("name") != spec.name || entry.at("columns") != as_json(spec.fields)) continue;
      tables.push_back({spec, parse_hexadecimal(entry.at("records").get<std::string>(), path)});
      if (tables.back().records.size() % record_size(spec.fields) != 0) {
        throw InputError(fmt::format("{}: the table {} ends within a record", path, spec.name));
      }
    }
  }
  if (tables.size() != json.size()) {
    throw InputError(fmt::format("{}: it has tables that this program does not know", path));
  }
  return tables;
}

void require_columns(const Json& json, const RowFormat& format, const std::string& path) {
  if (json.at("columns") == as_json(format.rows.fields)) return;
  throw InputError(
      fmt::format("{}: its rows have other columns; it was written by the program of source {}",
                  path, json.at("source_hash").get<std::string>()));
}

}  // namespace

StudyIdentity parse_identity(std::span<const char> text, const RowFormat& format,
                             const std::string& path) {
  return parsed(text, path, [&](const Json& json) {
    require_columns(json, format, path);
    StudyIdentity identity;
    json.at("study_id").get_to(identity.study_id);
    json.at("spec").get_to(identity.spec);
    json.at("spec_hash").get_to(identity.spec_hash);
    json.at("source_hash").get_to(identity.source_hash);
    json.at("dirty").get_to(identity.dirty);
    json.at("dirty_hash").get_to(identity.dirty_hash);
    json.at("created").get_to(identity.created);
    identity.shard = parse_shard(json.at("shard"), path);
    identity.planned_rows =
        whole_number<std::int64_t>(json.at("planned_rows"), "planned_rows", path);
    identity.tables = parse_tables(json.at("tables"), format, path);
    return identity;
  });
}

std::string session_text(const std::vector<EnvironmentEntry>& environment) {
  Json json = Json::array();
  for (const EnvironmentEntry& entry : environment) json.push_back({entry.name, entry.value});
  return dumped(json);
}

std::vector<EnvironmentEntry> parse_session(std::span<const char> text, const std::string& path) {
  return parsed(text, path, [](const Json& json) {
    std::vector<EnvironmentEntry> environment;
    for (const Json& entry : json) {
      environment.push_back({entry.at(0).get<std::string>(), entry.at(1).get<std::string>()});
    }
    return environment;
  });
}

}  // namespace ar3d
