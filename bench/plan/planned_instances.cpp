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
#include "ar3d/bench/plan/plan.h"
#include "ar3d/generators/random_graphs.h"
#include "ar3d/store/columns/study_identity.h"

namespace ar3d {
namespace {

constexpr std::uint64_t kShuffleStream = 0x73687566666c65;  // "shuffle", as the families have it

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
    const CollectedFile& file = corpus->file_at(index);
    append_line(text, "graphs", file.hash);
    copy = corpus->copy_at(index);
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
  if (run.workers >= 0) append_line(text, "scale", run.workers);
  append_line(text, "repetition", run.repetition);
  return content_hash(text);
}

}  // namespace

Graph graph_of(const PlannedInstance& instance) {
  const FamilyChoice& choice = instance.choice;
  if (!choice.corpus) {
    return generate(*choice.family, instance.requested_n, instance.seed, choice.parameters);
  }
  Graph graph = choice.corpus->graph(instance.index);
  if (std::ranges::count(choice.parameters, "shuffle", &Setting::name) > 0) {
    RandomStream random(instance.seed, kShuffleStream);
    graph = shuffled_labels(graph, random);
  }
  if (instance.requested_n >= graph.num_vertices()) return graph;
  return breadth_first_piece(graph, instance.requested_n);
}

void set_seed_and_keys(std::uint64_t study_seed, PlannedInstance& instance) {
  const std::string identity = instance_identity(instance);
  instance.seed = mix_seed(study_seed, XXH3_64bits(identity.data(), identity.size()));
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

PlannedInstance PlannedInstances::operator[](std::size_t i) const {
  expect(i < size(), "a plan has that instance");
  const PlannedBlock& block =
      *std::prev(std::ranges::upper_bound(blocks_, i, {}, &PlannedBlock::first_index));
  PlannedInstance instance = block.first;
  std::size_t row = block.first_row + (i - block.first_index) * instance.runs.size();
  for (PlannedRun& run : instance.runs) run.row = row++;
  instance.index = indices_[i];
  if (instance.runs.front().row_key.empty()) set_seed_and_keys(study_seed_, instance);
  return instance;
}

void PlannedInstances::push_back(PlannedInstance first) {
  expect(!first.runs.empty(), "a block of a plan has rows");
  const std::uint32_t index = first.index;
  blocks_.push_back({std::move(first), 0, size(), rows_});
  add(index);
}

void PlannedInstances::add(std::uint32_t index) {
  ++blocks_.back().count;
  indices_.push_back(index);
  rows_ += blocks_.back().first.runs.size();
}

PlannedInstances PlannedInstances::those(
    const std::function<bool(const PlannedBlock& block, std::size_t i)>& is_taken) const {
  PlannedInstances part(study_seed_);
  for (const PlannedBlock& block : blocks_) {
    bool has_begun = false;
    for (std::size_t i = block.first_index; i < block.first_index + block.count; ++i) {
      if (!is_taken(block, i)) continue;
      if (has_begun) {
        part.add(indices_[i]);
        continue;
      }
      part.push_back(block.first);
      part.blocks_.back().first.index = part.indices_.back() = indices_[i];
      has_begun = true;
    }
  }
  return part;
}

PlannedInstances PlannedInstances::every_nth(std::size_t first, std::size_t n) const {
  return those([=](const PlannedBlock&, std::size_t i) { return i % n == first; });
}

PlannedInstances PlannedInstances::part_of(std::size_t part, std::size_t n) const {
  std::size_t dealt = 0;  // of families
  return those([&, this](const PlannedBlock& block, std::size_t i) {
    const auto& corpus = block.first.choice.corpus;
    if (!corpus) return dealt++ % n == part;
    const CollectedFile& file = corpus->file_at(indices_[i]);
    const std::uint64_t number = indices_[i] - static_cast<std::uint64_t>(file.first);
    return (XXH3_64bits(file.hash.data(), file.hash.size()) % n + number) % n == part;
  });
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
double work_of_row(std::uint64_t n) {
  return 200 + static_cast<double>(n) * std::log2(static_cast<double>(n) + 1);
}

std::vector<std::uint32_t> largest_first(const StudyPlan& plan) {
  std::vector<const PlannedBlock*> blocks;
  for (const PlannedBlock& block : plan.instances.blocks()) blocks.push_back(&block);
  std::ranges::stable_sort(blocks, std::greater(), [](const PlannedBlock* block) {
    return work_of_row(block->first.n) * static_cast<double>(block->first.runs.size());
  });
  std::vector<std::uint32_t> indices;
  indices.reserve(plan.instances.size());
  for (const PlannedBlock* block : blocks) {
    for (std::size_t i = 0; i < block->count; ++i) {
      indices.push_back(static_cast<std::uint32_t>(block->first_index + i));  // at most 10^7
    }
  }
  return indices;
}

}  // namespace ar3d
