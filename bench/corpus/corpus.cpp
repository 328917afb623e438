// Graphs of files are read once and kept in a temporary file in few bytes, because a study visits
// them in another order than the file has, from several threads and processes. A sample keeps only
// graphs that can still be in it.
#include "ar3d/bench/corpus/corpus.h"

#include <cerrno>
#include <filesystem>
#include <numeric>
#include <queue>
#include <set>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/base/random.h"
#include "ar3d/base/system_calls.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/formats/graphs/graph6.h"

namespace ar3d {
namespace {

constexpr std::size_t kBufferBytes = std::size_t{1} << 20;
constexpr std::size_t kHeadBytes = sizeof(std::uint64_t);  // how many bytes follow

// Of a line of sparse6. @param source  where it stands, for messages. @param most  vertices.
Graph graph_of_line(std::string line, const std::string& source, std::uint64_t most) {
  GraphReader reader(TextInput(source, bytes_of(std::move(line))),
                     {.format = "sparse6", .free_vertices = most});
  return std::move(*reader.next());
}

void read_all(int file, std::span<char> to, std::uint64_t offset, const std::string& name) {
  if (read_whole(file, to, offset) == to.size()) return;
  throw InputError(fmt::format("cannot read {}: {}", name,
                               errno == 0 ? "it ends too early" : std::strerror(errno)));
}

constexpr std::uint64_t kMostGraphs = 10000000;  // a study has no more rows
constexpr std::uint64_t kMostHeldVertices = std::uint64_t{1} << 27;

void put_graph(HashStream& hash, const Graph& graph) {
  hash.put(graph.num_vertices());
  hash.put(graph.num_edges());
  for (const Edge edge : graph.edges()) {
    hash.put(edge.u);
    hash.put(edge.v);
  }
}

}  // namespace

Spool::Spool() : file_(new_temporary_file("ar3d-graphs", name_)) { unlink(name_.c_str()); }

std::uint64_t Spool::append(const Graph& graph) {
  const std::uint64_t offset = end_;
  const std::size_t head = buffer_.size();
  buffer_.resize(head + kHeadBytes);
  append_sparse6(buffer_, graph);
  const std::uint64_t length = buffer_.size() - head - kHeadBytes;
  std::memcpy(buffer_.data() + head, &length, kHeadBytes);
  end_ += kHeadBytes + length;
  if (buffer_.size() >= kBufferBytes) flush();
  return offset;
}

void Spool::flush() {
  if (write_whole(file_.get(), buffer_) < buffer_.size()) {
    throw InputError(
        fmt::format("cannot write {} (TMPDIR says where): {}", name_, std::strerror(errno)));
  }
  buffer_.clear();
}

Graph Spool::read(std::uint64_t offset) const {
  std::array<char, 4096> start;  // a small graph comes with one call
  const std::uint64_t there = end_ - offset;
  const std::size_t first = std::min<std::uint64_t>(start.size(), there);
  read_all(file_.get(), {start.data(), first}, offset, name_);
  std::uint64_t length = 0;
  std::memcpy(&length, start.data(), kHeadBytes);
  expect(length <= there - kHeadBytes, "a spooled graph stands in the file");
  std::string line(length, ' ');
  if (kHeadBytes + length <= first) {
    std::memcpy(line.data(), start.data() + kHeadBytes, length);
  } else {
    read_all(file_.get(), line, offset + kHeadBytes, name_);
  }
  return graph_of_line(std::move(line), name_, std::uint64_t{1} << 32);
}

// Takes the graphs of the files one after the other. A sample of k is the k indices of the smallest
// random numbers, a function of seed and index: a larger sample contains the smaller one, and only
// graphs that are among the k smallest so far are ever written.
class Corpus::Scan {
 public:
  Scan(Corpus& corpus, const GraphsEntry& taken) : corpus_(corpus), options_(taken) {}

  void read(const CorpusFile& file) {
    corpus_.path_ = file.path;
    if (file.held) return take_held(file);
    const std::size_t taken_before = corpus_.entries_.size();
    graphs_before_ = corpus_.graphs_in_file_;
    const auto first = static_cast<std::int64_t>(graphs_before_);
    CollectedFile read{"", file.file, file.group, "", first};
    HashStream hash;
    std::string problem;
    std::optional<GraphReader> reader;
    while (const std::optional<Graph> graph = next_graph(file, reader, problem)) take(*graph, hash);
    read.graphs = static_cast<std::int64_t>(corpus_.graphs_in_file_) - first;
    if (reader) std::ranges::move(reader->take_notes(), std::back_inserter(corpus_.notes_));
    if (!problem.empty()) {
      if (read.graphs > 0) problem += fmt::format(" (the {} graphs before are taken)", read.graphs);
      const std::size_t path = file.file.empty() ? std::string::npos : problem.find(file.path);
      if (path != std::string::npos) problem.replace(path, file.path.size(), file.file);
      corpus_.skipped_.push_back({"", file.file.empty() ? file.path : file.file, problem});
    }
    there_.insert(file.file);
    if (read.graphs == 0) return;
    read.hash = hash.digest();
    const auto known = held_.find(file.file);
    if (known != held_.end() && known->second.contains(read.hash)) {
      corpus_.entries_.resize(taken_before);  // what the spool has more is never asked for
      corpus_.graphs_in_file_ = graphs_before_;
      return;
    }
    const std::string& shown = file.file.empty() ? file.path : file.file;
    if (known != held_.end()) corpus_.growth_[1].push_back(shown);
    if (known == held_.end() && !held_.empty()) corpus_.growth_[0].push_back(shown);
    add(file.name, std::move(read));
  }

  void finish(bool has_looked) {
    for (const auto& [file, hashes] : held_) {
      if (has_looked && !there_.contains(file)) corpus_.growth_[2].push_back(file);
    }
    if (options_.sample > 0) drop_replaced();
    corpus_.spool_.flush();
    corpus_.hash_ = hash_of_files();
    corpus_.order_.resize(corpus_.entries_.size());
    std::iota(corpus_.order_.begin(), corpus_.order_.end(), 0u);
    const std::vector<TakenGraph>& entries = corpus_.entries_;
    std::stable_sort(corpus_.order_.begin(), corpus_.order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return entries[a].n < entries[b].n; });
  }

 private:
  void add(const std::string& name, CollectedFile file) {
    corpus_.names_.push_back(name);
    corpus_.copies_.push_back(copies_[file.hash]++);
    corpus_.files_.push_back(std::move(file));
  }

  /// Its graphs keep the indices that they had.
  void take_held(const CorpusFile& file) {
    const CollectedFile& record = *file.held;
    const auto first = static_cast<std::uint64_t>(record.first);
    const auto graphs = static_cast<std::uint64_t>(record.graphs);
    if (first < corpus_.graphs_in_file_) {
      throw InputError(fmt::format("/collected_files: {} graphs from {} on are none of {}",
                                   record.graphs, record.first, printable(record.file)));
    }
    for (const auto& [index, line] : file.lines) {
      keep(graph_of_line(line + "\n", "/graphs", kMostHeldVertices), index);
    }
    corpus_.graphs_in_file_ = first + graphs;
    held_[record.file].insert(record.hash);
    add(file.name, {"", record.file, file.group, record.hash, record.first, record.graphs});
  }

  void keep(const Graph& graph, std::uint64_t index) {
    corpus_.entries_.push_back({corpus_.spool_.append(graph), graph.num_vertices(),
                                static_cast<std::uint32_t>(index), graph.max_degree()});
  }

  using Ticket = std::pair<std::uint64_t, std::uint64_t>;  // random number, index

  // Nothing at the file's end, and where it cannot be read further and files may be skipped.
  std::optional<Graph> next_graph(const CorpusFile& file, std::optional<GraphReader>& reader,
                                  std::string& problem) const {
    try {
      if (!file.problem.empty()) throw InputError(file.problem);
      std::error_code ignored;
      const std::filesystem::file_status status = std::filesystem::status(file.path, ignored);
      if (!file.name.empty() && !is_regular_file(status) && !is_directory(status)) {
        throw InputError(file.path + ": it is no regular file");
      }
      if (!reader) reader.emplace(file.path, options_.reading);
      return reader->next();
    } catch (const InputError& error) {
      const bool holds_none = corpus_.graphs_in_file_ == graphs_before_;
      if (!options_.skip && !(options_.rescan && holds_none)) throw;
      problem = error.what();
      return std::nullopt;
    }
  }

  void take(const Graph& graph, HashStream& hash) {
    put_graph(hash, graph);
    const std::uint64_t index = corpus_.graphs_in_file_++;
    if (options_.sample == 0) {
      if (index == kMostGraphs) {
        throw InputError(fmt::format("{}: more than {} graphs; a sample of them can be taken",
                                     corpus_.path_, kMostGraphs));
      }
    } else if (!is_drawn(index)) {
      return;
    }
    keep(options_.largest_component ? induced(graph, in_largest_component(graph)) : graph, index);
    // Graphs that fell out of the sample since are dropped once they are as many as it holds.
    if (options_.sample > 0 && corpus_.entries_.size() >= 2 * options_.sample) drop_replaced();
  }

  std::string hash_of_files() const {
    const std::vector<CollectedFile>& files = corpus_.files_;
    if (files.size() == 1 && corpus_.names_[0].empty()) return files[0].hash;
    std::string text;
    for (std::size_t i = 0; i < files.size(); ++i) {
      text += fmt::format("{}\n{}\n{}\n", corpus_.names_[i], files[i].group, files[i].hash);
    }
    return content_hash(text);
  }
  std::uint64_t number_of(std::uint64_t index) const {
    return mix_seed(options_.sample_seed, index);
  }
  bool is_drawn(std::uint64_t index) {
    if (index > std::numeric_limits<std::uint32_t>::max()) {
      throw InputError(fmt::format("{}: more than 2^32 graphs", corpus_.path_));
    }
    const Ticket ticket(number_of(index), index);
    if (drawn_.size() == options_.sample) {
      if (drawn_.top() < ticket) return false;
      drawn_.pop();
    }
    drawn_.push(ticket);
    return true;
  }
  void drop_replaced() {
    if (drawn_.empty()) return;
    std::erase_if(corpus_.entries_, [&](const TakenGraph& entry) {
      return drawn_.top() < Ticket(number_of(entry.index), entry.index);
    });
  }

  Corpus& corpus_;
  const GraphsEntry& options_;
  // By file the hashes of what a study has read of it before.
  std::map<std::string, std::set<std::string>> held_;
  std::set<std::string> there_;                  // files that were looked at
  std::uint64_t graphs_before_ = 0;              // the file being read
  std::map<std::string, std::uint32_t> copies_;  // of files, by the hash of their graphs
  std::priority_queue<Ticket> drawn_;  // the smallest ones so far, the largest of them on top
};

Corpus::Corpus(const std::vector<CorpusFile>& files, const GraphsEntry& taken,
               const std::string& name)
    : family_{name,
              "The graphs of files",
              std::numeric_limits<std::uint32_t>::max(),
              false,
              {},
              [](std::uint64_t n, const Settings&) { return n; }} {
  expect(!files.empty(), "a corpus has files");
  Scan scan(*this, taken);
  for (const CorpusFile& file : files) scan.read(file);
  path_ = files.front().path;
  if (entries_.empty()) {
    throw InputError(
        fmt::format("none of {} files holds a graph{}", files.size(),
                    skipped_.empty() ? "" : "; the first: " + skipped_.front().reason));
  }
  scan.finish(taken.rescan);
}

std::size_t Corpus::number_at(std::uint32_t index) const {
  const auto behind = std::upper_bound(
      files_.begin(), files_.end(), index,
      [](std::uint32_t wanted, const CollectedFile& file) { return wanted < file.first; });
  return static_cast<std::size_t>(behind - files_.begin()) - 1;
}

std::string Corpus::graph_name(std::uint32_t index) const {
  constexpr std::size_t kMost = 96;
  const std::size_t file = number_at(index);
  std::string name = names_[file];
  if (files_[file].graphs > 1) name += fmt::format("#{}", index - files_[file].first);
  if (name.size() <= kMost) return name;
  std::size_t begin = name.size() - (kMost - 3);
  while (begin < name.size() && (name[begin] & 0xc0) == 0x80) ++begin;  // between characters
  return "..." + name.substr(begin);
}

std::size_t Corpus::count_above(std::uint32_t max_degree) const {
  return static_cast<std::size_t>(std::count_if(
      entries_.begin(), entries_.end(),
      [max_degree](const TakenGraph& entry) { return entry.max_degree > max_degree; }));
}

std::size_t Corpus::first_of_size(std::uint64_t wanted, std::uint32_t max_degree) const {
  const auto at = std::lower_bound(
      order_.begin(), order_.end(), wanted,
      [this](std::uint32_t entry, std::uint64_t n) { return entries_[entry].n < n; });
  const auto fits = [&](std::uint32_t entry) { return entries_[entry].max_degree <= max_degree; };
  const auto behind = std::find_if(at, order_.end(), fits);
  if (behind != order_.end()) return static_cast<std::size_t>(behind - order_.begin());
  const auto before = std::find_if(std::reverse_iterator(at), order_.rend(), fits);
  const auto chosen = before != order_.rend() ? before.base() - 1 : std::min(at, order_.end() - 1);
  return static_cast<std::size_t>(chosen - order_.begin());
}

Graph Corpus::graph(std::uint32_t index) const {
  const auto at = std::lower_bound(
      entries_.begin(), entries_.end(), index,
      [](const TakenGraph& entry, std::uint32_t wanted) { return entry.index < wanted; });
  if (at == entries_.end() || at->index != index) {
    throw InputError(fmt::format("{}: no graph is taken at index {} of its {} graphs", path_, index,
                                 graphs_in_file_));
  }
  return spool_.read(at->offset);
}

}  // namespace ar3d
