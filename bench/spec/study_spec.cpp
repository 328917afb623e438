// Reads a specification, key by key; every error names file, line and value.
#include "ar3d/bench/spec/study_spec.h"

#include <fmt/ranges.h>

#include <cerrno>
#include <filesystem>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/bench/spec/toml_table.h"

namespace ar3d {
namespace {

constexpr std::int64_t kMaxN = 4294967294, kMaxCount = 1000000;  // a graph has n < 2^32 - 1

class SpecReader {
 public:
  explicit SpecReader(const std::string& file) : file_(file) {}

  StudySpec read(const std::string& text) {
    const toml::table root = parse_toml(text, file_);
    TomlTable table(file_, root, "the study");
    table.refuse_all_but({"study", "description", "seed", "timing", "budget", "accept_unproved",
                          "count", "certificate", "keep_drawings", "graphs_bytes", "algorithm",
                          "max_n", "sweep"});
    StudySpec spec;
    spec.text = text;
    if (table.has("graphs_bytes")) spec.graphs_bytes = table.number("graphs_bytes", 0, 1e12);
    spec.name = study_name(table);
    spec.description = table.text("description", "");
    spec.seed = static_cast<std::uint64_t>(
        table.integer("seed", 0, std::numeric_limits<std::int64_t>::max(), 0));
    if (const toml::node* rules = table.find("timing")) {
      spec.timing = read_timing_rules(file_, *rules);
    }
    if (const toml::node* budget = table.find("budget")) spec.budget = read_budget(file_, *budget);
    spec.accept_unproved = table.boolean("accept_unproved", false);
    spec.count = table.boolean("count", false);
    if (const toml::node* mode = table.find("certificate")) {
      spec.certificate = toml_parsed(file_, *mode, "certificate", parse_certificate_mode);
    }
    if (const toml::node* kept = table.find("keep_drawings")) {
      spec.keep_drawings = toml_parsed(file_, *kept, "keep_drawings", parse_kept_drawings);
    }
    if (const toml::node* programs = table.find("algorithm")) {
      for (const toml::node* program : list(*programs, "algorithm")) add_program(*program);
    }
    for (const ProgramEntry& entry : programs_) spec.programs.push_back(entry.program);
    if (const toml::node* limits = table.find("max_n")) spec.max_n = size_limits(*limits);
    for (const toml::node* sweep : list(table.get("sweep"), "sweep")) {
      spec.sweeps.push_back(read_sweep(*sweep, spec.certificate));
    }
    return spec;
  }

 private:
  void add_program(const toml::node& node) {
    ProgramEntry entry = read_program(file_, node);
    if (find_program(entry.program->row.name) != nullptr) {
      refuse_toml(file_, node, fmt::format("a second algorithm '{}'", entry.program->row.name));
    }
    programs_.push_back(std::move(entry));
  }
  const ProgramEntry* find_program(const std::string& name) const {
    for (const ProgramEntry& entry : programs_) {
      if (entry.program->row.name == name) return &entry;
    }
    return nullptr;
  }
  void require_algorithm(const std::string& name) const {
    if (find_program(name) == nullptr) catalogue_algorithm(name);
  }
  const Algorithm& catalogue_algorithm(const std::string& name) const {
    std::vector<std::string_view> known;
    for (const ProgramEntry& entry : programs_) known.push_back(entry.program->row.name);
    for (const Algorithm& algorithm : algorithms()) {
      if (algorithm.name == name || programs_.empty()) return find_algorithm(name);
      known.push_back(algorithm.name);
    }
    throw InputError(fmt::format("unknown algorithm '{}'{} (known: {})", printable(name),
                                 did_you_mean(name, known), fmt::join(known, ", ")));
  }

  // The name becomes part of file names.
  std::string study_name(TomlTable& table) {
    std::string name = table.text("study");
    const bool plain = !name.empty() && name.size() <= 64 && name[0] != '-' &&
                       std::all_of(name.begin(), name.end(), [](char c) {
                         return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                                (c >= '0' && c <= '9') || c == '-' || c == '_';
                       });
    if (!plain) {
      refuse_toml(file_, table.get("study"),
                  fmt::format("study name '{}' is not 1 to 64 letters, digits, '-' or '_'", name));
    }
    return name;
  }

  std::vector<const toml::node*> list(const toml::node& node, const std::string& what) const {
    std::vector<const toml::node*> nodes = one_or_many(node);
    if (nodes.empty()) refuse_toml(file_, node, fmt::format("{} is empty", what));
    return nodes;
  }

  std::map<std::string, std::uint64_t> size_limits(const toml::node& node) const {
    TomlTable table(file_, node, "max_n");
    std::map<std::string, std::uint64_t> limits;
    for (const std::string& name : table.other_keys()) {
      with_place(file_, table.get(name), [&] { require_algorithm(name); });
      limits[name] = static_cast<std::uint64_t>(table.integer(name, 0, kMaxN));
    }
    return limits;
  }

  Sweep read_sweep(const toml::node& node, const CertificateMode& usual) const {
    TomlTable table(file_, node, "sweep");
    std::vector<std::string_view> keys = {
        "graphs",       "families",    "algorithms",        "level",  "certificate",
        "instances",    "repetitions", "timed_repetitions", "strong", "weak",
        "strong_ranks", "weak_ranks",  "include",           "exclude"};
    if (!table.has("graphs") || table.has("families")) keys.push_back("sizes");
    table.refuse_all_but(keys);
    Sweep sweep;
    if (const toml::node* graphs = table.find("graphs")) {
      sweep.graphs = read_graphs(file_, *graphs);
    }
    if (sweep.graphs.empty() || table.has("families")) {
      sweep.families = family_choices(table.get("families"));
      sweep.sizes = sizes(table.get("sizes"));
    }
    sweep.algorithms = algorithm_choices(table.get("algorithms"));
    if (const toml::node* level = table.find("level")) add_levels(*level, sweep.algorithms);
    for (AlgorithmChoice& choice : sweep.algorithms) choice.certificate = usual;
    const toml::node* modes = table.find("certificate");
    if (modes != nullptr) add_certificates(*modes, sweep.algorithms);
    sweep.instances = static_cast<std::uint32_t>(table.integer("instances", 1, kMaxCount, 1));
    sweep.repetitions = static_cast<std::uint32_t>(table.integer("repetitions", 1, kMaxCount, 1));
    if (const toml::node* timed = table.find("timed_repetitions")) {
      sweep.timed = read_timed_repetitions(file_, *timed);
    }
    const auto read = [&](const char* key, const char* sharers, BatchRules& batches) {
      const toml::node* found = table.find(key);
      if (found != nullptr) batches = read_batches(file_, *found, key, sharers);
    };
    read("strong", "threads", sweep.strong);
    read("weak", "threads", sweep.weak);
    read("strong_ranks", "ranks", sweep.strong_ranks);
    read("weak_ranks", "ranks", sweep.weak_ranks);
    if (const toml::node* include = table.find("include")) {
      list(*include, "include");  // an empty one would match no cell, or all of them
      sweep.include = patterns(*include, !sweep.graphs.empty());
    }
    if (const toml::node* exclude = table.find("exclude")) {
      sweep.exclude = patterns(*exclude, !sweep.graphs.empty());
    }
    refuse_bad_batches(file_, node, sweep);
    return sweep;
  }

  // Every choice with every value that the key lists.
  template <class Value, class Parse>
  void add_values(const toml::node& node, const char* key, Parse parse,
                  Value AlgorithmChoice::*member, std::vector<AlgorithmChoice>& choices) const {
    std::vector<Value> values;
    for (const toml::node* entry : list(node, key)) {
      values.push_back(toml_parsed(file_, *entry, key, parse));
    }
    std::vector<AlgorithmChoice> with_values;
    for (const AlgorithmChoice& choice : choices) {
      for (const Value& value : values) with_values.emplace_back(choice).*member = value;
    }
    choices = std::move(with_values);
  }
  void add_levels(const toml::node& node, std::vector<AlgorithmChoice>& choices) const {
    add_values(node, "level", parse_level, &AlgorithmChoice::level, choices);
  }
  void add_certificates(const toml::node& node, std::vector<AlgorithmChoice>& choices) const {
    add_values(node, "certificate", parse_certificate_mode, &AlgorithmChoice::certificate, choices);
  }

  // "name", or { <key> = "name", setting = value or list, ... }: the name and the settings in order
  // of name.
  std::string name_and_settings(const toml::node& node, const std::string& key,
                                std::vector<SettingChoices>& settings) const {
    if (node.is_string()) return toml_text(file_, node, key);
    TomlTable table(file_, node, key);
    std::string name = table.text(key);
    for (const std::string& setting : table.other_keys()) {
      settings.push_back({setting, {}});
      for (const toml::node* value : list(table.get(setting), setting)) {
        settings.back().values.push_back(toml_integer(file_, *value, setting,
                                                      std::numeric_limits<std::int64_t>::min(),
                                                      std::numeric_limits<std::int64_t>::max()));
      }
    }
    return name;
  }

  std::vector<FamilyChoice> family_choices(const toml::node& node) const {
    std::vector<FamilyChoice> choices;
    for (const toml::node* entry : list(node, "families")) {
      std::vector<SettingChoices> settings;
      const std::string name = name_and_settings(*entry, "family", settings);
      const auto add = [&](const Family& family) {
        for (const Settings& values : combinations(settings)) {
          choices.push_back({&family, complete_parameters(family, values)});
        }
      };
      with_place(file_, *entry, [&] {
        if (name == "all") {
          for (const Family& family : families()) add(family);
        } else {
          add(find_family(name));
        }
      });
    }
    return choices;
  }

  std::vector<AlgorithmChoice> algorithm_choices(const toml::node& node) const {
    std::vector<AlgorithmChoice> choices;
    for (const toml::node* entry : list(node, "algorithms")) {
      std::vector<SettingChoices> settings;
      const std::string name = name_and_settings(*entry, "algorithm", settings);
      if (name == "all" && settings.empty()) {
        for (const Algorithm* algorithm : proved_algorithms()) {
          choices.push_back({algorithm, complete_options(*algorithm, {})});
        }
        continue;
      }
      if (const ProgramEntry* const program = find_program(name)) {
        with_place(file_, *entry, [&] { add_choices(*program, settings, choices); });
        continue;
      }
      with_place(file_, *entry, [&] {
        const Algorithm& algorithm = catalogue_algorithm(name);
        for (const Settings& values : combinations(settings)) {
          choices.push_back({&algorithm, complete_options(algorithm, values)});
        }
      });
    }
    return choices;
  }

  // Options that the entry does not name take the values of the program's own table.
  static void add_choices(const ProgramEntry& entry, std::vector<SettingChoices> settings,
                          std::vector<AlgorithmChoice>& choices) {
    for (const auto& option : entry.options) {
      const bool is_given =
          std::any_of(settings.begin(), settings.end(),
                      [&](const SettingChoices& setting) { return setting.name == option.first; });
      if (!is_given) settings.push_back({option.first, option.second});
    }
    const Algorithm& row = entry.program->row;
    for (const Settings& values : combinations(settings)) {
      choices.push_back({&row, complete_options(row, values), entry.program});
    }
  }

  std::vector<std::uint64_t> sizes(const toml::node& node) const {
    std::vector<std::uint64_t> sizes;
    for (const toml::node* entry : list(node, "sizes")) {
      if (entry->is_table()) {
        add_ladder(*entry, sizes);
      } else {
        sizes.push_back(static_cast<std::uint64_t>(toml_integer(file_, *entry, "size", 0, kMaxN)));
      }
    }
    std::sort(sizes.begin(), sizes.end());
    sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
    return sizes;
  }

  // from, from * step, from * step^2, ... up to `to`, rounded to integers; step is `factor`, or
  // 10^(1/per_decade).
  void add_ladder(const toml::node& node, std::vector<std::uint64_t>& sizes) const {
    TomlTable table(file_, node, "sizes");
    const bool by_factor = table.has("factor");
    table.refuse_all_but({"from", "to", by_factor ? "factor" : "per_decade"});
    const std::int64_t from = table.integer("from", 1, kMaxN);
    const std::int64_t to = table.integer("to", from, kMaxN);
    const double base = by_factor ? table.number("factor", 1.001, 1e6) : 10;
    const auto steps = static_cast<double>(by_factor ? 1 : table.integer("per_decade", 1, 1000));
    for (std::int64_t step = 0;; ++step) {
      const double power = static_cast<double>(step) / steps;
      const double size = std::round(static_cast<double>(from) * std::pow(base, power));
      if (size > static_cast<double>(to)) return;
      sizes.push_back(static_cast<std::uint64_t>(size));
    }
  }

  // Where graphs come from files, planning looks up the names that no family has.
  std::vector<CellPattern> patterns(const toml::node& node, bool has_graphs) const {
    std::vector<CellPattern> patterns;
    for (const toml::node* entry : one_or_many(node)) {
      TomlTable table(file_, *entry, "include or exclude");
      table.refuse_all_but({"family", "algorithm", "from", "to"});
      CellPattern pattern;
      pattern.family = table.text("family", "");
      pattern.algorithm = table.text("algorithm", "");
      pattern.from = static_cast<std::uint64_t>(table.integer("from", 0, kMaxN, 0));
      pattern.to = static_cast<std::uint64_t>(table.integer("to", 0, kMaxN, kMaxN));
      pattern.place = fmt::format("{}:{}: ", file_, entry->source().begin.line);
      with_place(file_, *entry, [&] {
        if (!pattern.family.empty() && !has_graphs) find_family(pattern.family);
        if (!pattern.algorithm.empty()) require_algorithm(pattern.algorithm);
      });
      patterns.push_back(std::move(pattern));
    }
    return patterns;
  }

  std::string file_;
  std::vector<ProgramEntry> programs_;
};

std::string read_text_file(const std::string& path) {
  const Descriptor file = open_input(path);
  std::string text, bytes(1 << 16, ' ');
  ssize_t got = file.get() < 0 ? -1 : 1;
  while (got > 0) {
    while ((got = read(file.get(), bytes.data(), bytes.size())) < 0 && errno == EINTR) continue;
    if (got > 0) text.append(bytes, 0, static_cast<std::size_t>(got));
  }
  if (got < 0) throw InputError(fmt::format("cannot read {}: {}", path, std::strerror(errno)));
  return text;
}

}  // namespace

bool CellPattern::matches(const std::string& family_name, const std::string& algorithm_name,
                          std::uint64_t n) const {
  return (family.empty() || family == family_name) &&
         (algorithm.empty() || algorithm == algorithm_name) && from <= n && n <= to;
}

StudySpec parse_study(const std::string& text, const std::string& file) {
  return SpecReader(file).read(text);
}

bool accepts_unproved(const std::string& text) {
  try {
    return parse_toml(text, "")["accept_unproved"].value_or(false);
  } catch (const InputError&) {
    return false;
  }
}

StudySpec load_study(const std::string& name_or_path) {
  if (const NamedStudy* study = find_named_study(name_or_path)) {
    return parse_study(std::string(study->toml), std::string(study->name) + ".toml");
  }
  std::error_code error;
  const auto status = std::filesystem::status(name_or_path, error);
  if (std::filesystem::is_directory(status)) {
    throw InputError(fmt::format("cannot read {}: {}", name_or_path, std::strerror(EISDIR)));
  }
  if (!std::filesystem::exists(status)) {
    const auto known = names_of(named_studies());
    throw InputError(fmt::format("'{}' is neither a file nor a named study{} (named: {})",
                                 printable(name_or_path), did_you_mean(name_or_path, known),
                                 fmt::join(known, ", ")));
  }
  StudySpec spec = parse_study(read_text_file(name_or_path), name_or_path);
  spec.folder = std::filesystem::path(name_or_path).parent_path().string();
  return spec;
}

AlgorithmChoice algorithm_choice(const StudySpec& spec, const std::string& name,
                                 const Settings& options) {
  for (const std::shared_ptr<const ExternalAlgorithm>& program : spec.programs) {
    if (program->row.name == name) {
      return {&program->row, complete_options(program->row, options), program, spec.certificate};
    }
  }
  const Algorithm& algorithm = find_algorithm(name);
  return {&algorithm, complete_options(algorithm, options), nullptr, spec.certificate};
}

StudySpec recorded_study(const StudyIdentity& identity, const std::string& file) {
  StudySpec spec = parse_study(identity.spec, file + " (its specification)");
  for (Sweep& sweep : spec.sweeps) {  // what has become of them since is not a line's fault
    for (GraphsEntry& entry : sweep.graphs) entry.place = file + ": ";
  }
  spec.graph_files = graph_file_records(identity);
  spec.collected = collected_file_records(identity);
  spec.skipped = skipped_file_records(identity);
  spec.held = std::make_shared<const HeldGraphs>(held_graphs(identity));
  return spec;
}

std::string default_results_path(const StudySpec& spec) { return "ar3d-" + spec.name + ".h5"; }

}  // namespace ar3d
