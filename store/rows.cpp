// The rows of one study from wherever they are. Of several files sessions and rows are sorted by
// what they say, so that the order of the files does not matter.
#include "ar3d/store/rows.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <numeric>

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
struct Rows::Source {
  Source(const std::string& path_of_file, RowFile opened)
      : path(path_of_file), file(std::move(opened)) {}

  // Returns what `use` makes of the reader.
  template <class Use>
  auto with(const Use& use) const {
    return std::visit(use, file);
  }

  std::string path;
  mutable RowFile file;
  std::vector<Session> sessions = {};
  std::vector<std::int64_t> session_numbers = {};  // among all, by number in the file
};

Rows::~Rows() = default;
Rows::Rows(Rows&&) noexcept = default;
Rows& Rows::operator=(Rows&&) noexcept = default;

Rows::Rows(const Results& results)
    : identity_(results),
      environment_(results.environment),
      size_(results.runs.size()),
      in_hand_(&results) {}

Rows::Rows(const std::string& results) : file(results) {
  RunReader reader(results);
  identity_ = reader.identity();
  environment_ = reader.environment();
  size_ = reader.size();
  algorithms_ = side_records<AlgorithmRecord>(identity_);
  sources_.emplace_back(results, std::move(reader));
}

Rows::Rows(const std::vector<std::string>& files) {
  for (const std::string& path : files) add(path);
  std::sort(shards_.begin(), shards_.end(), [](const Shard& a, const Shard& b) {
    return std::pair(a.count, a.index) < std::pair(b.count, b.index);
  });
  shards_.erase(std::unique(shards_.begin(), shards_.end()), shards_.end());
  number_sessions();
  index_rows();
  algorithms_ = side_records<AlgorithmRecord>(identity_);
}

void Rows::add(const std::string& path) {
  Source source(path, opened(path));
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
  files_differ_ = unite_files(identity_, other) || files_differ_;
  identity_.created = std::min(identity_.created, other.created);
  shards_.push_back(other.shard);
  source.sessions = source.with([](auto& reader) { return reader.sessions(); });
  sources_.push_back(std::move(source));
}

// Sessions are ordered by their text, which begins with the time. One that another one goes on from
// is the same, seen before its end was there: the longer one stands for both.
void Rows::number_sessions() {
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

void Rows::index_rows() {
  for (const Source& source : sources_) {
    size_ += source.with([](auto& reader) { return reader.size(); });
  }
  index_.reserve(size_);
  for (std::uint32_t i = 0; i < sources_.size(); ++i) {
    sources_[i].with([&](auto& reader) {
      for (std::uint32_t row = 0; row < reader.size(); ++row) {
        index_.push_back({reader.key(row), i, row});
      }
      if constexpr (requires { reader.drop_keys(); }) reader.drop_keys();
    });
  }
  std::stable_sort(index_.begin(), index_.end(),
                   [](const FiledRow& a, const FiledRow& b) { return a.key < b.key; });
  std::vector<std::pair<std::size_t, std::size_t>>
      equal_keys;  // the row that is kept, one that is not
  for (std::size_t i = 1, kept = 0; i < size_; ++i) {
    if (index_[i].key != index_[kept].key) {
      kept = i;
    } else {
      equal_keys.emplace_back(kept, i);
    }
  }
  std::ranges::sort(equal_keys, {},
                    [this](const auto& rows) { return index_[rows.second].in_files(); });
  for (const auto& [kept, other] : equal_keys) require_equal(kept, other);
  const auto same = [](const FiledRow& a, const FiledRow& b) { return a.key == b.key; };
  index_.erase(std::unique(index_.begin(), index_.end(), same), index_.end());
  size_ = index_.size();
}

void Rows::require_equal(std::size_t a, std::size_t b) const {
  const std::string key = to_string(index_[a].key);
  if (index_[a].source == index_[b].source) {
    throw InputError(fmt::format("{}: rows {} and {} have one key, {}", path(a), index_[a].row,
                                 index_[b].row, key));
  }
  std::vector<char> left(run_record_size()), right(run_record_size());
  read(a, left.data());
  read(b, right.data());
  for (const Column& column : run_columns()) {
    if (std::memcmp(&left[column.offset], &right[column.offset], column.size) == 0) continue;
    throw InputError(fmt::format("row {} is in {} and in {} and differs in its {}", key, path(a),
                                 path(b), column.name));
  }
}

void Rows::read(std::size_t row, char* record) const {
  static const Column& session = run_column("session");
  if (in_hand_ != nullptr) return store_record(in_hand_->runs[row], record);
  expect(row < size_, "there is that row");
  const bool is_one_file = index_.empty();  // its rows stand in its order, with its session numbers
  const Source& source = sources_[is_one_file ? 0 : index_[row].source];
  source.with([&](auto& reader) { reader.read(is_one_file ? row : index_[row].row, record); });
  if (is_one_file) return;
  std::int64_t number = -1;
  std::memcpy(&number, record + session.offset, sizeof(number));
  const auto index = static_cast<std::size_t>(number);
  if (number < 0 || index >= source.session_numbers.size()) {
    throw InputError(
        fmt::format("{}: row {} is of no session", source.path, to_string(index_[row].key)));
  }
  number = source.session_numbers[index];
  std::memcpy(record + session.offset, &number, sizeof(number));
}

const RunRecord& Rows::run(std::size_t row) const {
  if (in_hand_ != nullptr) return in_hand_->runs[row];
  record_.resize(run_record_size());
  read(row, record_.data());
  try {
    run_ = load_record(record_.data());
    if (!run_.row_key.empty()) parse_row_key(run_.row_key);
    const auto* of = find_algorithm_record(algorithms_, run_.algorithm, run_.options);
    set_bounds(of ? &of->theorem : nullptr, of && of->published ? &*of->published : nullptr, run_);
    return run_;
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: row {}: {}", path(row),
                                 index_.empty() ? row : index_[row].row, error.what()));
  }
}

const std::string& Rows::path(std::size_t row) const {
  return sources_[index_.empty() ? 0 : index_[row].source].path;
}

std::optional<std::size_t> Rows::find(const RowKey& key) const {
  const auto at = std::ranges::lower_bound(index_, key, {}, &FiledRow::key);
  if (at == index_.end() || at->key != key) return std::nullopt;
  return static_cast<std::size_t>(at - index_.begin());
}

void Rows::arrange(const std::vector<std::uint32_t>& rows) {
  std::vector<FiledRow> arranged;
  arranged.reserve(rows.size());
  for (const std::uint32_t row : rows) arranged.push_back(index_[row]);
  index_ = std::move(arranged);
  size_ = index_.size();
}

void Rows::visit(const std::function<void(const char* record)>& visitor) const {
  std::vector<std::size_t> order(size_);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [this](std::size_t row) { return index_[row].in_files(); });
  std::vector<char> record(run_record_size());
  for (const std::size_t row : order) {
    read(row, record.data());
    visitor(record.data());
  }
}

void write_results(const Rows& rows, const std::string& path) {
  write_results(
      rows.identity(), rows.environment(), rows.size(),
      [&rows](std::size_t row, char* record) { rows.read(row, record); }, path);
}

Results read_results(const std::string& path) { return in_memory(Rows(path)); }

Results in_memory(const Rows& rows) {
  Results results;
  static_cast<StudyIdentity&>(results) = rows.identity();
  results.environment = rows.environment();
  results.runs.reserve(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) results.runs.push_back(rows.run(row));
  return results;
}

}  // namespace ar3d
