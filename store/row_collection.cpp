// The rows of one study from any number of files. Sessions and rows are sorted by what they say, so
// that the order of the files does not matter.
#include "ar3d/store/row_collection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <variant>

#include "ar3d/base/error.h"
#include "ar3d/store/columns/run_columns.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/journal/journal_reader.h"

namespace ar3d {
namespace {

using Session = std::vector<EnvironmentEntry>;
using RowFile = std::variant<JournalReader, RunReader>;

RowFile opened(const std::string& path) {
  std::array<char, kJournalStart.size()> start{};
  std::error_code error;
  if (std::filesystem::is_regular_file(path, error)) {  // a pipe has no end yet
    std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  }
  if (begins_as_journal({start.data(), start.size()})) return JournalReader(path);
  return RunReader(path);
}

}  // namespace

// A file with rows.
struct RowCollection::Source {
  explicit Source(const std::string& path_of_file) : path(path_of_file), file(opened(path)) {}

  // Returns what `use` makes of the reader.
  template <class Use>
  auto with(const Use& use) const {
    return std::visit(use, file);
  }

  std::string path;
  mutable RowFile file;
  std::vector<Session> sessions = std::visit([](auto& rows) { return rows.sessions(); }, file);
  std::vector<std::int64_t> session_numbers = {};  // in the collection, by number in the file
};

bool RowCollection::FiledRow::operator<(const FiledRow& other) const {
  return std::pair(source, row) < std::pair(other.source, other.row);
}

RowCollection::RowCollection() = default;
RowCollection::~RowCollection() = default;
RowCollection::RowCollection(RowCollection&&) noexcept = default;

void RowCollection::add(const std::string& path) {
  Source source(path);
  const auto other = source.with([](auto& reader) { return reader.identity(); });
  if (sources_.empty()) identity_ = other;
  const auto compare = [&](const char* what, const std::string& a, const std::string& b) {
    if (a != b) {
      throw InputError(fmt::format("{} and {} differ in their {}: {} and {}", sources_.front().path,
                                   path, what, a, b));
    }
  };
  compare("specification", identity_.spec_hash, other.spec_hash);
  compare("program's source", identity_.source(), other.source());
  identity_.created = std::min(identity_.created, other.created);
  shards_.push_back(other.shard);
  sources_.push_back(std::move(source));
}

void RowCollection::close() {
  std::sort(shards_.begin(), shards_.end(), [](const Shard& a, const Shard& b) {
    return std::pair(a.count, a.index) < std::pair(b.count, b.index);
  });
  shards_.erase(std::unique(shards_.begin(), shards_.end()), shards_.end());
  number_sessions();
  index_rows();
}

// Sessions are ordered by their text, which begins with the time. One that another one goes on from
// is the same, seen before its end was there: the longer one stands for both.
void RowCollection::number_sessions() {
  const auto text_of = [](const Session& session) {
    std::string text = session_text(session);
    text.pop_back();  // the end of the list
    return text;
  };
  std::vector<std::pair<std::string, const Session*>> all;
  for (const Source& source : sources_) {
    for (const Session& session : source.sessions) all.emplace_back(text_of(session), &session);
  }
  std::sort(all.begin(), all.end(), std::greater());
  const auto same = [](const auto& longer, const auto& other) {
    return longer.first == other.first ||
           (other.first.size() > 1 && longer.first.starts_with(other.first));
  };
  all.erase(std::unique(all.begin(), all.end(), same), all.end());
  std::reverse(all.begin(), all.end());
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (EnvironmentEntry entry : *all[i].second) {
      entry.session = static_cast<std::int64_t>(i);
      environment_.push_back(std::move(entry));
    }
  }
  for (Source& source : sources_) {
    for (const Session& session : source.sessions) {
      const auto at = std::lower_bound(all.begin(), all.end(), text_of(session),
                                       [](const auto& a, const auto& b) { return a.first < b; });
      source.session_numbers.push_back(at - all.begin());
    }
  }
}

void RowCollection::index_rows() {
  std::size_t count = 0;
  for (const Source& source : sources_) {
    count += source.with([](auto& reader) { return reader.size(); });
  }
  rows_.reserve(count);
  for (std::uint32_t i = 0; i < sources_.size(); ++i) {
    sources_[i].with([&](auto& reader) {
      for (std::uint32_t row = 0; row < reader.size(); ++row) {
        rows_.push_back({reader.key(row), i, row});
      }
    });
  }
  std::stable_sort(rows_.begin(), rows_.end(),
                   [](const FiledRow& a, const FiledRow& b) { return a.key < b.key; });
  std::vector<std::pair<FiledRow, FiledRow>> equal_keys;  // the row that is kept, one that is not
  const auto same = [&equal_keys](const FiledRow& a, const FiledRow& b) {
    if (a.key == b.key) equal_keys.emplace_back(a, b);
    return a.key == b.key;
  };
  rows_.erase(std::unique(rows_.begin(), rows_.end(), same), rows_.end());
  std::sort(equal_keys.begin(), equal_keys.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  for (const auto& [kept, other] : equal_keys) {
    if (kept.source == other.source) {
      throw InputError(fmt::format("{}: rows {} and {} have one key, {}",
                                   sources_[kept.source].path, kept.row, other.row,
                                   to_string(kept.key)));
    }
    require_equal(kept, other);
  }
}

void RowCollection::require_equal(const FiledRow& a, const FiledRow& b) const {
  std::vector<char> left(run_record_size()), right(run_record_size());
  read(a, left.data());
  read(b, right.data());
  for (const Column& column : run_columns()) {
    if (std::memcmp(left.data() + column.offset, right.data() + column.offset, column.size) == 0) {
      continue;
    }
    throw InputError(fmt::format("row {} is in {} and in {} and differs in its {}",
                                 to_string(a.key), sources_[a.source].path, sources_[b.source].path,
                                 column.name));
  }
}

void RowCollection::read(const FiledRow& row, char* record) const {
  static const Column& session = run_column("session");
  const Source& source = sources_[row.source];
  source.with([&](auto& reader) { reader.read(row.row, record); });
  std::int64_t number = -1;
  std::memcpy(&number, record + session.offset, sizeof(number));
  const auto place = static_cast<std::size_t>(number);
  if (number < 0 || place >= source.session_numbers.size()) {
    throw InputError(fmt::format("{}: row {} is of no session", source.path, to_string(row.key)));
  }
  number = source.session_numbers[place];
  std::memcpy(record + session.offset, &number, sizeof(number));
}

const std::string& RowCollection::path(std::size_t place) const {
  return sources_[rows_[place].source].path;
}

std::optional<std::size_t> RowCollection::find(const RowKey& key) const {
  const auto at = std::lower_bound(rows_.begin(), rows_.end(), key,
                                   [](const FiledRow& a, const RowKey& b) { return a.key < b; });
  if (at == rows_.end() || at->key != key) return std::nullopt;
  return static_cast<std::size_t>(at - rows_.begin());
}

void RowCollection::visit(const std::function<void(const char* record)>& visitor) const {
  std::vector<FiledRow> order = rows_;
  std::sort(order.begin(), order.end());
  std::vector<char> record(run_record_size());
  for (const FiledRow& row : order) {
    read(row, record.data());
    visitor(record.data());
  }
}

}  // namespace ar3d
