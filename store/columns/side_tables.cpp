// The small tables that stand beside the rows: what holds for all rows of an algorithm, the files
// whose graphs were drawn, and the sessions. One function names the columns of each (RecordPass).
#include "ar3d/store/columns/side_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/number.h"

namespace ar3d {
namespace {

constexpr std::size_t kSkippedFileBytes = 96;

std::string encoded(const std::string& path) {
  std::string text;
  for (const char c : path) {
    const bool is_plain = c > ' ' && c <= '~' && c != '%';
    text += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return text;
}

// What is no code stays as it is.
std::string decoded(const std::string& text) {
  std::string path;
  for (const char *at = text.data(), *end = at + text.size(); at != end; ++at) {
    unsigned char code = 0;
    const bool is_code =
        *at == '%' && end - at > 2 && std::from_chars(at + 1, at + 3, code, 16).ptr == at + 3;
    path += is_code ? static_cast<char>(code) : *at;
    if (is_code) at += 2;
  }
  return path;
}

// Holds %XX for bytes that are no printable ASCII.
void path_column(RecordPass& c, const char* name, std::size_t size, std::string& path,
                 const char* meaning) {
  std::string code = encoded(path);
  c.text(name, size, code, meaning);
  path = decoded(code);
}

// A bound that is missing is one of missing values.
void bound_columns(RecordPass& c, const std::string& whose, std::optional<SizeBound>& bound) {
  constexpr unsigned kLargestHalfPower = 18;  // of AxisBound
  constexpr const char* kMeaning = "extent <= numerator / denominator * n^exponent + constant";
  SizeBound now = bound.value_or(SizeBound());
  std::string formula = bound ? now.formula() : "";
  c.text(whose + "_name", 48, now.name, "whose bound it is");
  c.text(whose + "_source", 96, now.source, "where it is proved or stands");
  c.text(whose + "_formula", 256, formula, "the bound by axis, for people");
  bool is_there = true;
  for (std::size_t i = 0; i < 3; ++i) {
    AxisBound& axis = now.axes[i];
    if (!bound) axis = {-1, -1, 0, -1};
    double exponent = bound ? axis.half_power / 2.0 : kMissing;
    const char letter = "xyz"[i];
    c.number(fmt::format("{}_numerator_{}", whose, letter), "1", axis.numerator, kMeaning);
    c.number(fmt::format("{}_denominator_{}", whose, letter), "1", axis.denominator, kMeaning);
    c.number(fmt::format("{}_exponent_{}", whose, letter), "1", exponent, kMeaning);
    c.number(fmt::format("{}_constant_{}", whose, letter), "1", axis.constant, kMeaning);
    is_there = is_there && !std::isnan(exponent);
    if (!is_there) continue;
    axis.half_power = static_cast<unsigned>(std::clamp(2 * exponent, 0.0, 100.0));
    if (axis.denominator < 1 || axis.half_power / 2.0 != exponent ||
        axis.half_power > kLargestHalfPower) {
      throw InputError(fmt::format("/algorithms: {}/{} n^{} + {} is no bound", axis.numerator,
                                   axis.denominator, exponent, axis.constant));
    }
  }
  bound = is_there ? std::optional(now) : std::nullopt;
}

// False of a record without a theorem, which is none.
bool columns_of(RecordPass& c, AlgorithmRecord& record) {
  c.table("algorithms", "what follows from algorithm and options");
  c.next_are(ColumnKind::run, false);
  c.text("algorithm", 48, record.algorithm, "drawing algorithm");
  c.text("options", 96, record.options, "its options, complete, in catalogue order");
  double order = 0;  // follows from the bound
  for (const AxisBound& axis : record.theorem.axes) order += axis.half_power / 2.0;
  c.number("volume_order", "1", order, "exponent of n in the product of the theorem's bounds");
  std::optional<SizeBound> theorem = record.theorem;
  bound_columns(c, "theorem", theorem);
  bound_columns(c, "published", record.published);
  c.number("max_bends", "1", record.max_bends, "most bends of an edge that the theorem allows");
  if (theorem) record.theorem = *theorem;
  return theorem.has_value();
}

bool columns_of(RecordPass& c, GraphFileRecord& record) {
  c.table("graph_files", "files whose graphs are instances");
  c.text("name", 48, record.name, "family of its rows");
  c.number("entry", "1", record.entry, "which entry of the specification's graphs, from 0");
  c.number("graphs", "1", record.graphs, "graphs in the file");
  c.text("hash", 32, record.hash, "XXH3-128 of its graphs in order");
  path_column(c, "path", 1024, record.path,
              "absolute path; %XX for bytes that are no printable ASCII");
  c.next_are(ColumnKind::run, false);
  path_column(c, "groups", 1024, record.groups,
              "absolute path of a collection's table of groups, as path");
  return true;
}

bool columns_of(RecordPass& c, SkippedFile& record) {
  c.table("skipped_files", "files of collections that could not be read");
  c.next_are(ColumnKind::run, false);
  c.text("name", 48, record.name, "of the collection");
  c.message("file", kSkippedFileBytes, record.file, "path within it");
  c.message("reason", 240, record.reason, "why it could not be read");
  return true;
}

bool columns_of(RecordPass& c, CollectedFile& record) {
  c.table("collected_files", "files whose graphs are instances, as they were read");
  c.text("name", 48, record.name, "family of their rows");
  c.next_are(ColumnKind::run, false);
  path_column(c, "file", 512, record.file, "path within the collection, %XX as in graph_files");
  c.text("group", 48, record.group, "in rows");
  c.next_are(ColumnKind::run, true);
  c.text("hash", 32, record.hash, "XXH3-128 of its graphs in order");
  c.number("first", "1", record.first, "index of its first graph");
  c.number("graphs", "1", record.graphs, "graphs in it");
  return true;
}

constexpr std::size_t kPieceBytes = 1000;

bool columns_of(RecordPass& c, std::string& piece) {
  c.table("graphs", "graphs of files, as one text in pieces");
  c.next_are(ColumnKind::run, false);
  c.text("text", kPieceBytes, piece,
         "words: #FAMILY, @PLACE, :SPARSE6, =NUMBER of an earlier :SPARSE6");
  return true;
}

// Its texts are as wide as the widest of them.
bool columns_of(RecordPass& c, EnvironmentEntry& entry) {
  c.table("environments", "machine, compiler, libraries and settings of every session");
  c.number("session", "1", entry.session, "which process of the study");
  c.message("name", 1, entry.name, "what is described");
  c.message("value", 1, entry.value, "its value");
  return true;
}

template <class Record>
StoredTable spec_of() {
  StoredTable spec;
  Record record;
  RecordPass pass(spec);
  columns_of(pass, record);
  pack_columns(spec.columns);
  return spec;
}

template <class Record>
StoredTable table_of(StoredTable table, const std::vector<Record>& records) {
  const std::size_t size = record_size(table.columns);
  table.records.resize(records.size() * size);
  for (std::size_t i = 0; i < records.size(); ++i) {
    Record record = records[i];
    RecordPass pass(table.columns, table.records.data() + i * size);
    columns_of(pass, record);
  }
  return table;
}

template <class Record>
std::vector<Record> records_of(const StoredTable& table) {
  std::vector<Record> records;
  for (std::size_t i = 0; i < table.size(); ++i) {
    RecordPass pass(table.columns, table.record(i));
    Record record;
    if (columns_of(pass, record)) records.push_back(std::move(record));
  }
  return records;
}

// Words between blanks, so that a text column holds them.
std::string text_of_graphs(const StoredGraphs& graphs) {
  std::string text;
  std::map<std::string_view, std::size_t> numbers;  // of texts that stand there
  for (const auto& [family, by_index] : graphs) {
    text += fmt::format("#{} ", family);
    std::uint64_t next = 0;
    for (const auto& [index, line] : by_index) {
      if (index != next) text += fmt::format("@{} ", index);
      next = std::uint64_t{index} + 1;
      const auto [known, is_new] = numbers.try_emplace(line, numbers.size());
      text += is_new ? line : fmt::format("={}", known->second);
      text += ' ';
    }
  }
  return text;
}

}  // namespace

const std::vector<StoredTable>& side_table_specs() {
  static const std::vector<StoredTable> specs = {spec_of<AlgorithmRecord>(),
                                                 spec_of<GraphFileRecord>(), spec_of<SkippedFile>(),
                                                 spec_of<CollectedFile>(), spec_of<std::string>()};
  return specs;
}

template <class Record>
StoredTable side_table(const std::vector<Record>& records) {
  return table_of(spec_of<Record>(), records);
}

template <class Record>
std::vector<Record> side_records(const StudyIdentity& identity) {
  const auto table = std::ranges::find(identity.tables, spec_of<Record>().name, &StoredTable::name);
  return table == identity.tables.end() ? std::vector<Record>() : records_of<Record>(*table);
}

template StoredTable side_table(const std::vector<AlgorithmRecord>&);
template StoredTable side_table(const std::vector<GraphFileRecord>&);
template StoredTable side_table(const std::vector<SkippedFile>&);
template StoredTable side_table(const std::vector<CollectedFile>&);
template std::vector<AlgorithmRecord> side_records(const StudyIdentity&);
template std::vector<GraphFileRecord> side_records(const StudyIdentity&);
template std::vector<SkippedFile> side_records(const StudyIdentity&);
template std::vector<CollectedFile> side_records(const StudyIdentity&);

StoredTable environments_spec(std::size_t name_bytes, std::size_t value_bytes) {
  StoredTable spec = spec_of<EnvironmentEntry>();
  spec.columns[1].size = std::max<std::size_t>(1, name_bytes);
  spec.columns[2].size = std::max<std::size_t>(1, value_bytes);
  pack_columns(spec.columns);
  return spec;
}

StoredTable environments_table(const std::vector<EnvironmentEntry>& environment) {
  std::size_t name = 0, value = 0;
  for (const EnvironmentEntry& entry : environment) {
    name = std::max(name, entry.name.size());
    value = std::max(value, entry.value.size());
  }
  return table_of(environments_spec(name, value), environment);
}

std::vector<EnvironmentEntry> environment_of(const StoredTable& table) {
  return records_of<EnvironmentEntry>(table);
}

const AlgorithmRecord* find_algorithm_record(const std::vector<AlgorithmRecord>& records,
                                             std::string_view algorithm, std::string_view options) {
  const auto at = std::find_if(records.begin(), records.end(), [&](const AlgorithmRecord& record) {
    return record.algorithm == algorithm && record.options == options;
  });
  return at == records.end() ? nullptr : &*at;
}

void set_bounds(const SizeBound* theorem, const SizeBound* published, RunRecord& run) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto value = [&](const SizeBound* bound) {
      if (bound == nullptr || run.n < 0) return kMissing;
      return bound->axes[axis].value(static_cast<std::uint64_t>(run.n));
    };
    const double proved = value(theorem);
    run.theorem_bound[axis] = proved > 0 || run.n == 0 ? proved : kMissing;
    run.published_bound[axis] = value(published);
  }
}

std::pair<std::size_t, std::size_t> file_counts(const StudyIdentity& identity) {
  std::set<std::pair<std::string, std::string>> read, given;
  for (const CollectedFile& file : side_records<CollectedFile>(identity)) {
    if (!file.file.empty()) read.emplace(file.name, fitted_text(file.file, kSkippedFileBytes));
  }
  given = read;
  for (const SkippedFile& file : side_records<SkippedFile>(identity)) {
    given.emplace(file.name, file.file);
  }
  return {read.size(), given.size()};
}

StoredTable graphs_table(const StoredGraphs& graphs) {
  const std::string text = text_of_graphs(graphs);
  std::vector<std::string> pieces;
  for (std::size_t at = 0; at < text.size(); at += kPieceBytes) {
    pieces.push_back(text.substr(at, kPieceBytes));
  }
  return side_table(pieces);
}

StoredGraphs stored_graphs(const StudyIdentity& identity) {
  std::string text;
  for (const std::string& piece : side_records<std::string>(identity)) text += piece;
  StoredGraphs graphs;
  std::map<std::uint32_t, std::string>* family = nullptr;
  std::vector<std::string> lines;
  std::uint32_t index = 0;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end + 1) {
    end = std::min(text.find(' ', at), text.size());
    const std::string_view word(text.data() + at, end - at);
    const char kind = word.empty() ? ' ' : word[0];
    const auto number = integer_of<std::uint32_t>(word.empty() ? word : word.substr(1));
    const bool is_graph = kind == ':' || (kind == '=' && number && *number < lines.size());
    if (kind == '#') {
      family = &graphs[std::string(word.substr(1))];
      index = 0;
    } else if (kind == '@' && number) {
      index = *number;
    } else if (is_graph && family != nullptr) {
      if (kind == ':') lines.emplace_back(word);
      family->emplace(index++, kind == ':' ? lines.back() : lines[*number]);
    } else {
      throw InputError(fmt::format("/graphs: '{}' is no word of it", word.substr(0, 40)));
    }
  }
  return graphs;
}

bool unite_files(StudyIdentity& all, const StudyIdentity& other) {
  if (side_records<CollectedFile>(all) == side_records<CollectedFile>(other)) return false;
  using Lines = std::map<std::uint32_t, std::string>;
  std::map<std::array<std::string, 3>, std::pair<CollectedFile, Lines>> united;
  std::map<std::array<std::string, 2>, SkippedFile> skipped;
  for (const StudyIdentity* part : {static_cast<const StudyIdentity*>(&all), &other}) {
    const StoredGraphs held = stored_graphs(*part);
    for (const CollectedFile& file : side_records<CollectedFile>(*part)) {
      const auto lines = held.find(file.name);
      if (lines == held.end()) {
        throw InputError(
            fmt::format("the shards have different files of {}, and not their graphs", file.name));
      }
      const auto first = static_cast<std::uint32_t>(file.first);
      const auto end = static_cast<std::uint32_t>(file.first + file.graphs);
      Lines own;
      for (auto at = lines->second.lower_bound(first); at != lines->second.lower_bound(end); ++at) {
        own[at->first - first] = at->second;
      }
      united.try_emplace({file.name, file.file, file.hash}, file, std::move(own));
    }
    for (SkippedFile& file : side_records<SkippedFile>(*part)) {
      skipped.try_emplace({file.name, file.file}, file);
    }
  }
  StoredGraphs graphs;
  std::map<std::string, std::int64_t> indices;
  std::vector<CollectedFile> files;
  for (auto& [key, entry] : united) {
    auto& [file, lines] = entry;
    file.first = std::exchange(indices[file.name], indices[file.name] + file.graphs);
    for (auto& [index, line] : lines) {
      graphs[file.name][static_cast<std::uint32_t>(file.first) + index] = std::move(line);
    }
    skipped.erase({file.name, file.file});
    files.push_back(std::move(file));
  }
  const auto put = [&](StoredTable table) {
    std::erase_if(all.tables, [&](const StoredTable& old) { return old.name == table.name; });
    all.tables.push_back(std::move(table));
  };
  put(side_table<CollectedFile>(files));
  put(graphs_table(graphs));
  std::vector<SkippedFile> left_out;
  for (auto& [key, file] : skipped) left_out.push_back(std::move(file));
  if (!left_out.empty()) put(side_table<SkippedFile>(left_out));
  return true;
}

}  // namespace ar3d
