#include "ar3d/store/columns/graph_file_table.h"

#include <fmt/format.h>

#include <cstring>

#include "ar3d/base/error.h"

namespace ar3d {
namespace {

constexpr std::size_t kName = 0;
constexpr std::size_t kEntry = 1;
constexpr std::size_t kGraphs = 2;
constexpr std::size_t kHash = 3;
constexpr std::size_t kPath = 4;

TableSpec make_spec() {
  TableSpec spec{"graph_files", "files whose graphs are instances", {}};
  spec.fields = {
      {"name", "", "family of its rows", FieldType::text, 48},
      {"entry", "1", "which entry of the specification's graphs, from 0", FieldType::int64, 8},
      {"graphs", "1", "graphs in the file", FieldType::int64, 8},
      {"hash", "", "XXH3-128 of its graphs in order", FieldType::text, 32},
      {"path", "", "absolute path; %XX for bytes that are no printable ASCII", FieldType::text,
       1024}};
  pack_fields(spec.fields);
  return spec;
}

std::string encoded(const std::string& path) {
  std::string text;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte > 32 && byte < 127 && c != '%') {
      text += c;
    } else {
      text += fmt::format("%{:02X}", byte);
    }
  }
  return text;
}

// What is no code stays as it is.
std::string decoded(const std::string& text) {
  const auto digit = [](char c) {
    const std::size_t at = std::string("0123456789ABCDEF").find(c);
    return at == std::string::npos ? 256 : static_cast<int>(at);
  };
  std::string path;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int code =
        text[i] == '%' && i + 2 < text.size() ? 16 * digit(text[i + 1]) + digit(text[i + 2]) : 256;
    path += code < 256 ? static_cast<char>(code) : text[i];
    if (code < 256) i += 2;
  }
  return path;
}

void put_text(const std::string& text, std::size_t field, char* record) {
  const Field& at = graph_files_spec().fields[field];
  if (text != fitted_text(text, at.size)) {
    throw InputError(fmt::format("the {} of a file of graphs is longer than {} bytes: {}", at.name,
                                 at.size, text));
  }
  text.copy(record + at.offset, text.size());
}

std::string take_text(std::size_t field, const char* record) {
  const Field& at = graph_files_spec().fields[field];
  return std::string(record + at.offset, strnlen(record + at.offset, at.size));
}

void put_number(std::int64_t number, std::size_t field, char* record) {
  std::memcpy(record + graph_files_spec().fields[field].offset, &number, sizeof(number));
}

std::int64_t take_number(std::size_t field, const char* record) {
  std::int64_t number = 0;
  std::memcpy(&number, record + graph_files_spec().fields[field].offset, sizeof(number));
  return number;
}

}  // namespace

const TableSpec& graph_files_spec() {
  static const TableSpec spec = make_spec();
  return spec;
}

StoredTable graph_file_table(const std::vector<GraphFileRecord>& records) {
  StoredTable table{graph_files_spec(), {}};
  for (const GraphFileRecord& record : records) {
    std::vector<char> bytes(record_size(table.spec.fields), '\0');
    put_text(record.name, kName, bytes.data());
    put_number(record.entry, kEntry, bytes.data());
    put_number(record.graphs, kGraphs, bytes.data());
    put_text(record.hash, kHash, bytes.data());
    put_text(encoded(record.path), kPath, bytes.data());
    table.records.insert(table.records.end(), bytes.begin(), bytes.end());
  }
  return table;
}

std::vector<GraphFileRecord> graph_file_records(const StudyIdentity& identity) {
  std::vector<GraphFileRecord> records;
  const StoredTable* table = find_table(identity, graph_files_spec().name);
  for (std::size_t i = 0; table != nullptr && i < table->size(); ++i) {
    const char* bytes = table->record(i);
    records.push_back({take_text(kName, bytes), take_number(kEntry, bytes),
                       take_number(kGraphs, bytes), take_text(kHash, bytes),
                       decoded(take_text(kPath, bytes))});
  }
  return records;
}

}  // namespace ar3d
