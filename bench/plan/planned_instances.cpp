// Seeds and keys of rows are hashes of what a row says of itself. They stay the same whatever else
// a study contains, so that rows of two studies can be compared.
#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <iterator>
#include <string_view>

#include "ar3d/base/error.h"
#include "ar3d/base/random.h"
#include "ar3d/bench/corpus/corpus.h"
#include "ar3d/bench/plan/corpora.h"
#include "ar3d/bench/plan/plan.h"
#include "ar3d/store/columns/study_identity.h"

namespace ar3d {
namespace {

// Not with one format string: this is done for every row, and costs a third so. Nor by letting the
// text grow step by step.
constexpr std::size_t kUsualText = 512;

void append_line(std::string& text, const char* name, std::string_view value) {
  text.append(name).append("=").append(value).append("\n");
}

template <std::integral T>
void append_line(std::string& text, const char* name, T value) {
  const fmt::format_int digits(value);
  append_line(text, name, std::string_view(digits.data(), digits.size()));
}

std::string instance_identity(const PlannedInstance& instance) {
  std::string text;
  text.reserve(kUsualText);
  std::uint32_t index = instance.index, copy = 0;
  if (const auto& corpus = instance.choice.corpus) {  // whatever the file is called
    const CollectedFile& file = corpus->graphs->file_at(index);
    append_line(text, "graphs", file.hash);
    copy = corpus->graphs->copy_at(index);
    index -= static_cast<std::uint32_t>(file.first);
  } else {
    append_line(text, "family", instance.choice.family->name);
  }
  append_line(text, "parameters", instance.parameters);
  append_line(text, "n", instance.n);
  append_line(text, "index", index);
  if (copy > 0) append_line(text, "copy", copy);
  return text;
}

std::uint64_t instance_seed(std::uint64_t study_seed, const std::string& identity) {
  return mix_seed(study_seed, XXH3_64bits(identity.data(), identity.size()));
}

// What stands before the repetition tells the phases apart; the metrics phase has nothing there.
std::string row_key(const std::string& prefix, const PlannedRun& run) {
  std::string text;
  text.reserve(kUsualText);
  text += prefix;
  append_line(text, "algorithm", run.choice.algorithm->name);
  append_line(text, "options", run.options);
  if (run.choice.level != Level::extents) append_line(text, "level", to_string(run.choice.level));
  const CertificateMode mode = run.choice.certificate;
  if (mode == CertificateMode::none) append_line(text, "certificate", to_string(mode));
  if (run.phase != RunPhase::metrics) append_line(text, "phase", to_string(run.phase));
  if (run.scale >= 0) append_line(text, "scale", run.scale);
  append_line(text, "repetition", run.repetition);
  return content_hash(text);
}

// The last part that begins at `wanted` or before; the parts stand in order.
template <class Parts, class First>
const auto& last_from(const Parts& parts, std::size_t wanted, const First& first) {
  return *std::prev(
      std::upper_bound(parts.begin(), parts.end(), wanted,
                       [&](std::size_t at, const auto& part) { return at < first(part); }));
}

}  // namespace

Graph graph_of(const PlannedInstance& instance) {
  const FamilyChoice& choice = instance.choice;
  if (!choice.corpus) {
    return generate(*choice.family, instance.requested_n, instance.seed, choice.parameters);
  }
  Graph graph = corpus_graph(choice, instance.index, instance.seed);
  if (instance.requested_n >= graph.num_vertices()) return graph;
  return breadth_first_piece(graph, instance.requested_n);
}

void set_seed_and_keys(std::uint64_t study_seed, PlannedInstance& instance) {
  const std::string identity = instance_identity(instance);
  instance.seed = instance_seed(study_seed, identity);
  std::string prefix;
  prefix.reserve(kUsualText);
  append_line(prefix, "study_seed", study_seed);
  prefix += identity;
  for (PlannedRun& run : instance.runs) run.row_key = row_key(prefix, run);
}

std::size_t required_runs(const PlannedInstance& instance) {
  return static_cast<std::size_t>(
      std::count_if(instance.runs.begin(), instance.runs.end(),
                    [](const PlannedRun& run) { return !run.optional; }));
}

PlannedInstance PlannedInstances::operator[](std::size_t place) const {
  const PlannedBlock& block = block_of_place(place);
  const std::size_t within = place - block.first_place;
  PlannedInstance instance = block.first;
  std::size_t row = block.first_row + within * instance.runs.size();
  for (PlannedRun& run : instance.runs) run.row = row++;
  if (block.is_explicit) return instance;
  if (const auto& corpus = instance.choice.corpus) {
    const std::size_t at = block.first_in_corpus + within * block.step;
    instance.index = corpus->graphs->place(block.taken ? (*block.taken)[at] : at);
  } else {
    instance.index += static_cast<std::uint32_t>(within * block.step);  // at most 10^7 instances
  }
  set_seed_and_keys(study_seed_, instance);
  return instance;
}

const PlannedBlock& PlannedInstances::block_of_place(std::size_t place) const {
  expect(place < size_, "a plan has that instance");
  return last_from(blocks_, place, [](const PlannedBlock& block) { return block.first_place; });
}

const PlannedBlock& PlannedInstances::block_of_row(std::size_t row) const {
  expect(row < rows_, "a plan has that row");
  return last_from(blocks_, row, [](const PlannedBlock& block) { return block.first_row; });
}

void PlannedInstances::append(PlannedBlock block) {
  expect(block.count > 0 && !block.first.runs.empty(), "a block of a plan has rows");
  block.first_place = size_;
  block.first_row = rows_;
  size_ += block.count;
  rows_ += block.count * block.first.runs.size();
  blocks_.push_back(std::move(block));
}

// @param skipped  how many instances stand before the first that is taken.
void PlannedInstances::append_every_nth(PlannedBlock block, std::size_t skipped, std::size_t n) {
  if (skipped >= block.count) return;
  block.first.index += static_cast<std::uint32_t>(skipped * block.step);
  block.first_in_corpus += skipped * block.step;
  block.count = (block.count - skipped - 1) / n + 1;
  block.step *= n;
  append(std::move(block));
}

PlannedInstances PlannedInstances::every_nth(std::size_t first, std::size_t n) const {
  PlannedInstances part(study_seed_);
  for (const PlannedBlock& block : blocks_) {
    part.append_every_nth(block, (first + n - block.first_place % n) % n, n);
  }
  return part;
}

PlannedInstances PlannedInstances::part_of(std::size_t part, std::size_t n) const {
  PlannedInstances instances(study_seed_);
  std::size_t dealt = 0;  // of families
  for (PlannedBlock block : blocks_) {
    const auto& corpus = block.first.choice.corpus;
    if (!corpus) {
      instances.append_every_nth(block, (part + n - dealt % n) % n, n);
      dealt += block.count;
      continue;
    }
    auto taken = std::make_shared<std::vector<std::uint32_t>>();
    for (std::size_t i = 0; i < block.count; ++i) {
      const std::size_t at = block.first_in_corpus + i * block.step;
      const std::uint32_t place = corpus->graphs->place(at);
      const CollectedFile& file = corpus->graphs->file_at(place);
      const std::uint64_t number = place - static_cast<std::uint64_t>(file.first);
      const std::uint64_t of_file = XXH3_64bits(file.hash.data(), file.hash.size()) % n;
      if ((of_file + number) % n == part) taken->push_back(static_cast<std::uint32_t>(at));
    }
    if (taken->empty()) continue;
    block.count = taken->size();
    block.first_in_corpus = 0;
    block.step = 1;
    block.taken = std::move(taken);
    instances.append(std::move(block));
  }
  return instances;
}

void PlannedInstances::push_back(PlannedInstance instance) {
  PlannedBlock block;
  block.first = std::move(instance);
  block.is_explicit = true;
  append(std::move(block));
}

bool has_run(const PlannedInstance& instance, const std::function<bool(RunPhase)>& is_meant) {
  return std::any_of(instance.runs.begin(), instance.runs.end(),
                     [&](const PlannedRun& run) { return is_meant(run.phase); });
}

bool has_run(const StudyPlan& plan, const std::function<bool(RunPhase)>& is_meant) {
  const std::vector<PlannedBlock>& blocks = plan.instances.blocks();
  return std::any_of(blocks.begin(), blocks.end(),
                     [&](const PlannedBlock& block) { return has_run(block.first, is_meant); });
}

// Drawing is linear in n; certifying, which takes most of the time, sorts. The constant is what a
// row of no vertices takes.
double work_of_row(const PlannedInstance& instance) {
  const auto n = static_cast<double>(instance.n);
  return 200 + n * std::log2(n + 1);
}

double work_of_instance(const PlannedInstance& instance) {
  return work_of_row(instance) * static_cast<double>(instance.runs.size());
}

std::vector<std::uint32_t> largest_first(const StudyPlan& plan) {
  std::vector<const PlannedBlock*> blocks;
  for (const PlannedBlock& block : plan.instances.blocks()) blocks.push_back(&block);
  std::ranges::stable_sort(blocks, std::greater(), [](const PlannedBlock* block) {
    return work_of_instance(block->first);
  });
  std::vector<std::uint32_t> places;
  places.reserve(plan.instances.size());
  for (const PlannedBlock* block : blocks) {
    for (std::size_t i = 0; i < block->count; ++i) {
      places.push_back(static_cast<std::uint32_t>(block->first_place + i));  // at most 10^7
    }
  }
  return places;
}

}  // namespace ar3d
