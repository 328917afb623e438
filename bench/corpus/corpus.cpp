#include "ar3d/bench/corpus/corpus.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <queue>
#include <utility>

#include "ar3d/base/error.h"
#include "ar3d/base/hash_stream.h"
#include "ar3d/base/random.h"
#include "ar3d/bench/corpus/subgraphs.h"
#include "ar3d/formats/catalog.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kMostGraphs = 10000000;  // a study has no more rows

void put_graph(HashStream& hash, const Graph& graph) {
  hash.put(graph.num_vertices());
  hash.put(graph.num_edges());
  for (const Edge edge : graph.edges()) {
    hash.put(edge.u);
    hash.put(edge.v);
  }
}

}  // namespace

std::string CorpusOptions::text() const {
  return fmt::format(
      "format={};base={};first_line={};simple={};component={};sample={};sample_seed={}",
      reading.format, reading.base, static_cast<int>(reading.first_line), reading.simplify,
      largest_component, sample, sample_seed);
}

// Takes the graphs of a file one after the other. A sample of k is the k places of the smallest
// random numbers, a function of seed and place: a larger sample contains the smaller one, and only
// graphs that are among the k smallest so far are ever written.
class Corpus::Scan {
 public:
  Scan(Corpus& corpus, const CorpusOptions& options) : corpus_(corpus), options_(options) {}

  void take(const Graph& graph) {
    put_graph(hash_, graph);
    const std::uint64_t place = corpus_.graphs_in_file_++;
    if (options_.sample == 0) {
      if (place == kMostGraphs) {
        throw InputError(fmt::format("{}: more than {} graphs; a sample of them can be taken",
                                     corpus_.path_, kMostGraphs));
      }
    } else if (!is_drawn(place)) {
      return;
    }
    const Graph taken = options_.largest_component ? largest_component(graph) : graph;
    corpus_.entries_.push_back(
        {corpus_.spool_.append(taken), taken.num_vertices(), static_cast<std::uint32_t>(place)});
    // Those that later ones have replaced go when they are as many as those that stay.
    if (options_.sample > 0 && corpus_.entries_.size() >= 2 * options_.sample) drop_replaced();
  }

  void finish() {
    if (options_.sample > 0) drop_replaced();
    corpus_.spool_.flush();
    corpus_.hash_ = hash_.digest();
    corpus_.order_.resize(corpus_.entries_.size());
    std::iota(corpus_.order_.begin(), corpus_.order_.end(), 0u);
    const std::vector<Entry>& entries = corpus_.entries_;
    std::stable_sort(corpus_.order_.begin(), corpus_.order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return entries[a].n < entries[b].n; });
  }

 private:
  using Ticket = std::pair<std::uint64_t, std::uint64_t>;  // random number, place

  std::uint64_t number_of(std::uint64_t place) const {
    return mix_seed(options_.sample_seed, place);
  }
  bool is_drawn(std::uint64_t place) {
    if (place > std::numeric_limits<std::uint32_t>::max()) {
      throw InputError(fmt::format("{}: more than 2^32 graphs", corpus_.path_));
    }
    const Ticket ticket(number_of(place), place);
    if (drawn_.size() == options_.sample) {
      if (drawn_.top() < ticket) return false;
      drawn_.pop();
    }
    drawn_.push(ticket);
    return true;
  }
  void drop_replaced() {
    if (drawn_.empty()) return;
    std::erase_if(corpus_.entries_, [&](const Entry& entry) {
      return drawn_.top() < Ticket(number_of(entry.place), entry.place);
    });
  }

  Corpus& corpus_;
  const CorpusOptions& options_;
  HashStream hash_;
  std::priority_queue<Ticket> drawn_;  // the smallest ones so far, the largest of them on top
};

Corpus::Corpus(const std::string& path, const CorpusOptions& options) : path_(path) {
  Scan scan(*this, options);
  GraphReader reader(path, options.reading);
  while (const std::optional<Graph> graph = reader.next()) scan.take(*graph);
  scan.finish();
}

std::size_t Corpus::first_of_size(std::uint64_t wanted) const {
  const auto at = std::lower_bound(
      order_.begin(), order_.end(), wanted,
      [this](std::uint32_t entry, std::uint64_t n) { return entries_[entry].n < n; });
  return static_cast<std::size_t>(std::min(at, order_.end() - 1) - order_.begin());
}

Graph Corpus::graph(std::uint32_t place) const {
  const auto at = std::lower_bound(
      entries_.begin(), entries_.end(), place,
      [](const Entry& entry, std::uint32_t wanted) { return entry.place < wanted; });
  if (at == entries_.end() || at->place != place) {
    throw InputError(fmt::format("{}: no graph is taken from place {} of its {} graphs", path_,
                                 place, graphs_in_file_));
  }
  return spool_.read(at->offset);
}

std::shared_ptr<const NamedCorpus> named_corpus(const std::string& name,
                                                std::shared_ptr<const Corpus> graphs) {
  Family family{name,
                "The graphs of a file",
                std::numeric_limits<std::uint32_t>::max(),
                false,
                {},
                [](std::uint64_t n, const Settings&) { return n; }};
  return std::make_shared<const NamedCorpus>(NamedCorpus{std::move(family), std::move(graphs)});
}

std::shared_ptr<const Corpus> CorpusShelf::get(const std::string& path,
                                               const CorpusOptions& options) {
  std::shared_ptr<const Corpus>& corpus = corpora_[path + '\n' + options.text()];
  if (!corpus) corpus = std::make_shared<const Corpus>(path, options);
  return corpus;
}

}  // namespace ar3d
