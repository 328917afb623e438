#include "ar3d/results/journal/journal_format.h"

#include <fmt/format.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "ar3d/model/error.h"
#include "ar3d/results/columns.h"

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

Json columns_as_json() {
  Json columns = Json::array();
  for (const Column& column : run_columns()) {
    columns.push_back({column.name, static_cast<int>(column.type), column.size});
  }
  return columns;
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

std::span<const char> pack_row(const char* record, std::vector<char>& buffer) {
  buffer.resize(run_record_size() + run_columns().size() * sizeof(std::uint16_t));  // the most
  char* to = buffer.data();
  const auto append = [&to](const void* from, std::size_t count) {
    std::memcpy(to, from, count);
    to += count;
  };
  for (const Column& column : run_columns()) {
    const char* field = record + column.offset;
    if (column.type != FieldType::text) {
      append(field, column.size);
      continue;
    }
    const auto length = static_cast<std::uint16_t>(strnlen(field, column.size));
    append(&length, sizeof(length));
    append(field, length);
  }
  return {buffer.data(), to};
}

void unpack_row(std::span<const char> packed, char* record) {
  for (const Column& column : run_columns()) {
    char* field = record + column.offset;
    if (column.type != FieldType::text) {
      std::memcpy(field, take(packed, column.size).data(), column.size);
      continue;
    }
    std::uint16_t length = 0;
    std::memcpy(&length, take(packed, sizeof(length)).data(), sizeof(length));
    if (length > column.size) throw InputError("a row of the journal holds too long a text");
    std::memset(field, 0, column.size);
    std::memcpy(field, take(packed, length).data(), length);
  }
  if (!packed.empty()) throw InputError("a row of the journal is too long");
}

RowKey packed_row_key(std::span<const char> packed) {
  const Column& first = run_columns().front();
  expect(first.name == "row_key", "a row begins with its key");
  take(packed, sizeof(std::uint16_t));
  return parse_row_key({take(packed, first.size).data(), first.size});
}

std::string identity_text(const StudyIdentity& identity) {
  return dumped({{"study_id", identity.study_id},
                 {"spec", identity.spec},
                 {"spec_sha256", identity.spec_sha256},
                 {"source_hash", identity.source_hash},
                 {"dirty", identity.dirty},
                 {"dirty_hash", identity.dirty_hash},
                 {"created", identity.created},
                 {"shard", {identity.shard.index, identity.shard.count}},
                 {"planned_rows", identity.planned_rows},
                 {"columns", columns_as_json()}});
}

StudyIdentity parse_identity(std::span<const char> text, const std::string& path) {
  return parsed(text, path, [&](const Json& json) {
    if (json.at("columns") != columns_as_json()) {
      throw InputError(
          fmt::format("{}: its rows have other columns; it was written by the program of source {}",
                      path, json.at("source_hash").get<std::string>()));
    }
    StudyIdentity identity;
    json.at("study_id").get_to(identity.study_id);
    json.at("spec").get_to(identity.spec);
    json.at("spec_sha256").get_to(identity.spec_sha256);
    json.at("source_hash").get_to(identity.source_hash);
    json.at("dirty").get_to(identity.dirty);
    identity.dirty_hash = json.value("dirty_hash", "");  // journals of older programs lack it
    json.at("created").get_to(identity.created);
    json.at("shard").at(0).get_to(identity.shard.index);
    json.at("shard").at(1).get_to(identity.shard.count);
    json.at("planned_rows").get_to(identity.planned_rows);
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
