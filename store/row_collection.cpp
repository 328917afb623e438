// The rows of one study from any number of files. Sessions and rows are sorted by what they say, so
// that the order of the files does not matter.
#include "ar3d/store/row_collection.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "ar3d/base/error.h"
#include "ar3d/store/hdf5/results_file.h"
#include "ar3d/store/journal/journal_reader.h"

namespace ar3d {
namespace {

using Session = std::vector<EnvironmentEntry>;

// A file with rows.
struct Source {
  std::string path;
  StudyIdentity identity;
  std::vector<Session> sessions;
  std::size_t size = 0;
  std::function<RowKey(std::size_t)> key;
  std::function<void(std::size_t, char*)> read;
  std::vector<std::int64_t> session_numbers;  // in the collection, by number in the file
};

Source journal_source(const std::string& path, const RowFormat& format) {
  const auto reader = std::make_shared<JournalReader>(path, format);
  return {.path = path,
          .identity = reader->identity(),
          .sessions = reader->sessions(),
          .size = reader->size(),
          .key = [reader](std::size_t i) { return reader->key(i); },
          .read = [reader](std::size_t i, char* record) { reader->read(i, record); },
          .session_numbers = {}};
}

std::vector<Session> sessions_of(const std::vector<EnvironmentEntry>& environment,
                                 const std::string& path) {
  std::vector<Session> sessions;
  for (EnvironmentEntry entry : environment) {
    const auto number = static_cast<std::size_t>(entry.session);
    if (number > sessions.size()) {
      throw InputError(fmt::format("{}: /environments has no session {}", path, sessions.size()));
    }
    if (number == sessions.size()) sessions.emplace_back();
    entry.session = 0;
    sessions[number].push_back(std::move(entry));
  }
  return sessions;
}

RowKey key_in(const char* record, const RowFormat& format, const std::string& path,
              std::size_t row) {
  try {
    return key_of_record(format, record);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: row {}: {}", path, row, error.what()));
  }
}

Source results_source(const std::string& path, const RowFormat& format) {
  const auto reader = std::make_shared<ResultsReader>(path, format);
  return {.path = path,
          .identity = reader->identity(),
          .sessions = sessions_of(reader->environment(), path),
          .size = reader->size(),
          .key = [reader, &format,
                  path](std::size_t i) { return key_in(reader->read(i), format, path, i); },
          .read = [reader, &format](
                      std::size_t i,
                      char* to) { std::memcpy(to, reader->read(i), format.record_size()); },
          .session_numbers = {}};
}

bool is_journal(const std::string& path) {
  std::array<char, kJournalStart.size()> start{};
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;  // a pipe has no end yet
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  return begins_as_journal({start.data(), start.size()});
}

void require_same_study(const Source& first, const Source& other) {
  const auto compare = [&](const char* what, const std::string& a, const std::string& b) {
    if (a != b) {
      throw InputError(fmt::format("{} and {} differ in their {}: {} and {}", first.path,
                                   other.path, what, a, b));
    }
  };
  compare("specification", first.identity.spec_hash, other.identity.spec_hash);
  compare("program's source", first.identity.source(), other.identity.source());
}

}  // namespace

struct RowCollection::State {
  explicit State(const RowFormat& format_of_rows) : format(format_of_rows) {}

  struct FiledRow {
    RowKey key;
    std::uint32_t source = 0;
    std::uint32_t row = 0;
  };

  static bool in_file_order(const FiledRow& a, const FiledRow& b) {
    return std::pair(a.source, a.row) < std::pair(b.source, b.row);
  }

  void read(const FiledRow& row, char* record) const {
    const Source& source = sources[row.source];
    source.read(row.row, record);
    char* field = record + format.rows.fields[format.session].offset;
    std::int64_t number = -1;
    std::memcpy(&number, field, sizeof(number));
    const auto place = static_cast<std::size_t>(number);
    if (number < 0 || place >= source.session_numbers.size()) {
      throw InputError(fmt::format("{}: row {} is of no session", source.path, to_string(row.key)));
    }
    number = source.session_numbers[place];
    std::memcpy(field, &number, sizeof(number));
  }

  void number_sessions();
  void index_rows();
  void require_equal(const FiledRow& a, const FiledRow& b) const;

  const RowFormat& format;
  StudyIdentity identity;
  std::vector<Shard> shards;
  std::vector<EnvironmentEntry> environment;
  std::vector<Source> sources;
  std::vector<FiledRow> rows;  // by key
};

RowCollection::RowCollection(const RowFormat& format) : state_(std::make_unique<State>(format)) {}
RowCollection::~RowCollection() = default;
RowCollection::RowCollection(RowCollection&&) noexcept = default;

void RowCollection::add(const std::string& path) {
  Source source = is_journal(path) ? journal_source(path, state_->format)
                                   : results_source(path, state_->format);
  if (state_->sources.empty()) {
    state_->identity = source.identity;
  } else {
    require_same_study(state_->sources.front(), source);
    StudyIdentity& identity = state_->identity;
    identity.created = std::min(identity.created, source.identity.created);
  }
  state_->shards.push_back(source.identity.shard);
  state_->sources.push_back(std::move(source));
}

void RowCollection::close() {
  const auto before = [](const Shard& a, const Shard& b) {
    return std::pair(a.count, a.index) < std::pair(b.count, b.index);
  };
  std::vector<Shard>& shards = state_->shards;
  std::sort(shards.begin(), shards.end(), before);
  shards.erase(std::unique(shards.begin(), shards.end()), shards.end());
  state_->number_sessions();
  state_->index_rows();
}

// Sessions are ordered by their text, which begins with the time. One that another one goes on from
// is the same, seen before its end was there: the longer one stands for both.
void RowCollection::State::number_sessions() {
  const auto text_of = [](const Session& session) {
    std::string text = session_text(session);
    text.pop_back();  // the end of the list
    return text;
  };
  std::vector<std::pair<std::string, const Session*>> all;
  for (const Source& source : sources) {
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
      environment.push_back(std::move(entry));
    }
  }
  for (Source& source : sources) {
    for (const Session& session : source.sessions) {
      const auto at = std::lower_bound(all.begin(), all.end(), text_of(session),
                                       [](const auto& a, const auto& b) { return a.first < b; });
      source.session_numbers.push_back(at - all.begin());
    }
  }
}

void RowCollection::State::index_rows() {
  std::size_t count = 0;
  for (const Source& source : sources) count += source.size;
  rows.reserve(count);
  for (std::uint32_t i = 0; i < sources.size(); ++i) {
    for (std::uint32_t row = 0; row < sources[i].size; ++row) {
      rows.push_back({sources[i].key(row), i, row});
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const FiledRow& a, const FiledRow& b) { return a.key < b.key; });
  std::vector<std::pair<FiledRow, FiledRow>> equal_keys;  // the row that is kept, one that is not
  const auto same = [&equal_keys](const FiledRow& a, const FiledRow& b) {
    if (a.key == b.key) equal_keys.emplace_back(a, b);
    return a.key == b.key;
  };
  rows.erase(std::unique(rows.begin(), rows.end(), same), rows.end());
  std::sort(equal_keys.begin(), equal_keys.end(),
            [](const auto& a, const auto& b) { return in_file_order(a.second, b.second); });
  for (const auto& [kept, other] : equal_keys) {
    if (kept.source == other.source) {
      throw InputError(fmt::format("{}: rows {} and {} have one key, {}", sources[kept.source].path,
                                   kept.row, other.row, to_string(kept.key)));
    }
    require_equal(kept, other);
  }
}

void RowCollection::State::require_equal(const FiledRow& a, const FiledRow& b) const {
  std::vector<char> left(format.record_size());
  std::vector<char> right(format.record_size());
  read(a, left.data());
  read(b, right.data());
  for (const Field& column : format.rows.fields) {
    if (std::memcmp(left.data() + column.offset, right.data() + column.offset, column.size) == 0) {
      continue;
    }
    throw InputError(fmt::format("row {} is in {} and in {} and differs in its {}",
                                 to_string(a.key), sources[a.source].path, sources[b.source].path,
                                 column.name));
  }
}

const StudyIdentity& RowCollection::identity() const { return state_->identity; }
const std::vector<Shard>& RowCollection::shards() const { return state_->shards; }
const std::vector<EnvironmentEntry>& RowCollection::environment() const {
  return state_->environment;
}
std::size_t RowCollection::size() const { return state_->rows.size(); }
const RowKey& RowCollection::key(std::size_t place) const { return state_->rows[place].key; }

const std::string& RowCollection::path(std::size_t place) const {
  return state_->sources[state_->rows[place].source].path;
}

std::optional<std::size_t> RowCollection::find(const RowKey& key) const {
  const auto& rows = state_->rows;
  const auto at =
      std::lower_bound(rows.begin(), rows.end(), key,
                       [](const State::FiledRow& a, const RowKey& b) { return a.key < b; });
  if (at == rows.end() || at->key != key) return std::nullopt;
  return static_cast<std::size_t>(at - rows.begin());
}

void RowCollection::read(std::size_t place, char* record) const {
  state_->read(state_->rows.at(place), record);
}

void RowCollection::visit(const std::function<void(const char* record)>& visitor) const {
  std::vector<State::FiledRow> order = state_->rows;
  std::sort(order.begin(), order.end(), State::in_file_order);
  std::vector<char> record(state_->format.record_size());
  for (const State::FiledRow& row : order) {
    state_->read(row, record.data());
    visitor(record.data());
  }
}

}  // namespace ar3d
