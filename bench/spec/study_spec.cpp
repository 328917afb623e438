// Reads a specification, key by key; every error names file, line and value.
#include "ar3d/bench/spec/study_spec.h"

#include <fmt/ranges.h>

#include <cerrno>
#include <filesystem>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/new_file.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/spec/read_parts.h"
#include "ar3d/bench/spec/toml_table.h"
#include "ar3d/generators/catalog.h"

namespace ar3d {
std::shared_ptr<const ExternalAlgorithm> find_program(const StudySpec& spec,
                                                      const std::string& name) {
  const auto at =
      std::ranges::find(spec.programs, name, [](const auto& program) { return program->row.name; });
  return at == spec.programs.end() ? nullptr : *at;
}

namespace {

constexpr std::int64_t kMaxN = 4294967294, kMaxCount = 1000000;  // a graph has n < 2^32 - 1

void add_program(const toml::node& node, StudySpec& spec) {
  std::shared_ptr<const ExternalAlgorithm> program = read_program(node);
  if (find_program(spec, program->row.name)) {
    refuse_toml(node, fmt::format("a second algorithm '{}'", program->row.name));
  }
  spec.programs.push_back(std::move(program));
}

// The algorithm of that name, without options. @throws InputError naming those that are known.
AlgorithmChoice named_algorithm(const StudySpec& spec, const std::string& name) {
  if (const auto program = find_program(spec, name)) return {&program->row, {}, program};
  if (spec.programs.empty()) return {&find_algorithm(name), {}};
  std::vector<std::string_view> known;
  for (const auto& program : spec.programs) known.push_back(program->row.name);
  for (const Algorithm& algorithm : algorithms()) {
    if (algorithm.name == name) return {&algorithm, {}};
    known.push_back(algorithm.name);
  }
  throw InputError(fmt::format("unknown algorithm '{}'{} (known: {})", printable(name),
                               did_you_mean(name, known), fmt::join(known, ", ")));
}

// The name becomes part of file names.
std::string study_name(const std::string& name) {
  const bool plain = !name.empty() && name.size() <= 64 && name[0] != '-' &&
                     std::all_of(name.begin(), name.end(), [](char c) {
                       return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                              (c >= '0' && c <= '9') || c == '-' || c == '_';
                     });
  if (plain) return name;
  throw InputError(fmt::format("study name '{}' is not 1 to 64 letters, digits, '-' or '_'", name));
}

// Every choice with every value that the key lists.
template <class Value, class Parse>
TomlReader values_into(std::vector<AlgorithmChoice>& choices, Parse parse,
                       Value AlgorithmChoice::*member) {
  return [&choices, parse, member](const toml::node& node, const std::string& key) {
    std::vector<Value> values;
    for (const toml::node* entry : toml_list(node, key)) {
      parsed_into(values.emplace_back(), parse)(*entry, key);
    }
    std::vector<AlgorithmChoice> with_values;
    for (const AlgorithmChoice& choice : choices) {
      for (const Value& value : values) with_values.emplace_back(choice).*member = value;
    }
    choices = std::move(with_values);
  };
}

// "name", or { <key> = "name", setting = value or list, ... }: the name and the settings in order
// of name.
std::string name_and_settings(const toml::node& node, const std::string& key,
                              std::vector<SettingChoices>& settings) {
  if (node.is_string()) return toml_text(node, key);
  std::string name;
  read_toml_table(node, key, {{key, into(name), true}},
                  [&](const toml::node& given, const std::string& setting) {
                    settings.push_back({setting, {}});
                    for (const toml::node* value : toml_list(given, setting)) {
                      into(settings.back().second.emplace_back(),
                           std::numeric_limits<std::int64_t>::min(),
                           std::numeric_limits<std::int64_t>::max())(*value, setting);
                    }
                  });
  return name;
}

std::vector<FamilyChoice> family_choices(const toml::node& node) {
  std::vector<FamilyChoice> choices;
  for (const toml::node* entry : toml_list(node, "families")) {
    std::vector<SettingChoices> settings;
    const std::string name = name_and_settings(*entry, "family", settings);
    const auto add = [&](const Family& family) {
      for (const Settings& values : combinations(settings)) {
        choices.push_back({&family, complete_parameters(family, values)});
      }
    };
    with_location(*entry, [&] {
      if (name == "all") {
        for (const Family& family : families()) add(family);
      } else {
        add(find_family(name));
      }
    });
  }
  return choices;
}

// Options that the entry does not name take the values of a program's own table.
void add_choices(AlgorithmChoice choice, std::vector<SettingChoices> settings,
                 std::vector<AlgorithmChoice>& choices) {
  if (choice.program) {
    for (const SettingChoices& option : choice.program->choices) {
      const auto given = std::ranges::find(settings, option.first, &SettingChoices::first);
      if (given == settings.end()) settings.push_back(option);
    }
  }
  for (const Settings& values : combinations(settings)) {
    choice.options = complete_options(*choice.algorithm, values);
    choices.push_back(choice);
  }
}

std::vector<AlgorithmChoice> algorithm_choices(const toml::node& node, const StudySpec& spec) {
  std::vector<AlgorithmChoice> choices;
  for (const toml::node* entry : toml_list(node, "algorithms")) {
    std::vector<SettingChoices> settings;
    const std::string name = name_and_settings(*entry, "algorithm", settings);
    if (name == "all" && settings.empty()) {
      for (const Algorithm* algorithm : proved_algorithms()) {
        choices.push_back({algorithm, complete_options(*algorithm, {})});
      }
      continue;
    }
    with_location(*entry, [&] { add_choices(named_algorithm(spec, name), settings, choices); });
  }
  return choices;
}

// from, from * step, from * step^2, ... up to `to`, rounded to integers; step is `factor`, or
// 10^(1/per_decade).
void add_ladder(const toml::node& node, std::vector<std::uint64_t>& sizes) {
  const bool by_factor = has_toml_key(node, "factor");
  std::int64_t from = 0, to = 0, per_decade = 1;
  double base = 10;
  const TomlReader read_to = [&](const toml::node& last, const std::string& key) {
    into(to, from, kMaxN)(last, key);
  };
  read_toml_table(node, "sizes",
                  {{"from", into(from, 1, kMaxN), true},
                   {"to", read_to, true},
                   by_factor ? TomlKey{"factor", number_into(base, 1.001, 1e6), true}
                             : TomlKey{"per_decade", into(per_decade, 1, 1000), true}});
  for (std::int64_t step = 0;; ++step) {
    const double power = static_cast<double>(step) / static_cast<double>(per_decade);
    const double size = std::round(static_cast<double>(from) * std::pow(base, power));
    if (size > static_cast<double>(to)) return;
    sizes.push_back(static_cast<std::uint64_t>(size));
  }
}

std::vector<std::uint64_t> read_sizes(const toml::node& node) {
  std::vector<std::uint64_t> sizes;
  for (const toml::node* entry : toml_list(node, "sizes")) {
    if (entry->is_table()) {
      add_ladder(*entry, sizes);
    } else {
      into(sizes.emplace_back(), 0, kMaxN)(*entry, "size");
    }
  }
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  return sizes;
}

// Where graphs come from files, planning looks up the names that no family has.
std::vector<CellPattern> read_patterns(const toml::node& node, bool has_graphs,
                                       const StudySpec& spec) {
  std::vector<CellPattern> patterns;
  for (const toml::node* entry : one_or_many(node)) {
    CellPattern& pattern = patterns.emplace_back();
    pattern.to = kMaxN;
    pattern.location = toml_location(*entry);
    read_toml_table(*entry, "include or exclude",
                    {{"family", into(pattern.family)},
                     {"algorithm", into(pattern.algorithm)},
                     {"from", into(pattern.from, 0, kMaxN)},
                     {"to", into(pattern.to, 0, kMaxN)}});
    with_location(*entry, [&] {
      if (!pattern.family.empty() && !has_graphs) find_family(pattern.family);
      if (!pattern.algorithm.empty()) named_algorithm(spec, pattern.algorithm);
    });
  }
  return patterns;
}

Sweep read_sweep(const toml::node& node, const StudySpec& spec) {
  Sweep sweep;
  using Node = const toml::node&;
  using Key = const std::string&;
  const bool has_graphs = has_toml_key(node, "graphs");
  const bool has_families = !has_graphs || has_toml_key(node, "families");
  const auto batches_of = [&](RunPhase phase) {
    return [&sweep, phase](Node rules, Key key) {
      sweep.batches[phase] = read_batches(rules, key, is_over_ranks(phase) ? "ranks" : "threads");
    };
  };
  const auto read_algorithms = [&](Node algorithms, Key) {
    sweep.algorithms = algorithm_choices(algorithms, spec);
    for (AlgorithmChoice& choice : sweep.algorithms) choice.certificate = spec.certificate;
  };
  std::vector<TomlKey> keys = {
      {"graphs", [&](Node graphs, Key) { sweep.graphs = read_graphs(graphs); }},
      {"families", [&](Node families, Key) { sweep.families = family_choices(families); },
       has_families},
      {"algorithms", read_algorithms, true},
      {"level", values_into(sweep.algorithms, parse_level, &AlgorithmChoice::level)},
      {"certificate",
       values_into(sweep.algorithms, parse_certificate_mode, &AlgorithmChoice::certificate)},
      {"instances", into(sweep.instances, 1, kMaxCount)},
      {"repetitions", into(sweep.repetitions, 1, kMaxCount)},
      {"timed_repetitions", [&](Node timed, Key) { read_timed_repetitions(timed, sweep); }},
      {"strong", batches_of(RunPhase::strong)},
      {"weak", batches_of(RunPhase::weak)},
      {"strong_ranks", batches_of(RunPhase::strong_ranks)},
      {"weak_ranks", batches_of(RunPhase::weak_ranks)},
      {"include",
       [&](Node include, Key key) {
         toml_list(include, key);  // an empty one would match no cell, or all of them
         sweep.include = read_patterns(include, has_graphs, spec);
       }},
      {"exclude",
       [&](Node exclude, Key) { sweep.exclude = read_patterns(exclude, has_graphs, spec); }}};
  if (has_families) {
    keys.insert(keys.begin() + 2,
                {"sizes", [&](Node given, Key) { sweep.sizes = read_sizes(given); }, true});
  }
  read_toml_table(node, "sweep", keys);
  refuse_bad_batches(node, sweep);
  return sweep;
}

}  // namespace

bool CellPattern::matches(const std::string& family_name, const std::string& algorithm_name,
                          std::uint64_t n) const {
  return (family.empty() || family == family_name) &&
         (algorithm.empty() || algorithm == algorithm_name) && from <= n && n <= to;
}

StudySpec parse_study(const std::string& text, const std::string& file) {
  const toml::table root = parse_toml(text, file);
  StudySpec spec;
  spec.text = text;
  using Node = const toml::node&;
  using Key = const std::string&;
  read_toml_table(root, "the study",
                  {{"graphs_bytes", number_into(spec.graphs_bytes, 0, 1e12)},
                   {"study", parsed_into(spec.name, study_name), true},
                   {"description", into(spec.description)},
                   {"seed", into(spec.seed, 0, std::numeric_limits<std::int64_t>::max())},
                   {"timing", [&](Node rules, Key) { spec.timing = read_timing_rules(rules); }},
                   {"budget", [&](Node budget, Key) { spec.budget = read_budget(budget); }},
                   {"accept_unproved", into(spec.accept_unproved)},
                   {"count", into(spec.count)},
                   {"certificate", parsed_into(spec.certificate, parse_certificate_mode)},
                   {"keep_drawings", parsed_into(spec.keep_drawings, parse_kept_drawings)},
                   {"algorithm",
                    [&](Node programs, Key key) {
                      for (const toml::node* program : toml_list(programs, key))
                        add_program(*program, spec);
                    }},
                   {"max_n",
                    [&](Node limits, Key key) {
                      read_toml_table(limits, key, {}, [&](Node limit, Key name) {
                        with_location(limit, [&] { named_algorithm(spec, name); });
                        into(spec.max_n[name], 0, kMaxN)(limit, name);
                      });
                    }},
                   {"sweep",
                    [&](Node sweeps, Key key) {
                      for (const toml::node* sweep : toml_list(sweeps, key)) {
                        spec.sweeps.push_back(read_sweep(*sweep, spec));
                      }
                    },
                    true}});
  return spec;
}

bool accepts_unproved(const std::string& text) {
  try {
    return parse_toml(text, "")["accept_unproved"].value_or(false);
  } catch (const InputError&) {
    return false;
  }
}

Study load_study(const std::string& name_or_path) {
  if (const NamedStudy* study = find_named_study(name_or_path)) {
    return parse_study(std::string(study->toml), std::string(study->name) + ".toml");
  }
  std::error_code error;
  const auto status = std::filesystem::status(name_or_path, error);
  if (std::filesystem::is_directory(status)) {
    refuse_reading(name_or_path, EISDIR);
  }
  if (!std::filesystem::exists(status)) {
    const auto known = names_of(named_studies());
    throw InputError(fmt::format("'{}' is neither a file nor a named study{} (named: {})",
                                 printable(name_or_path), did_you_mean(name_or_path, known),
                                 fmt::join(known, ", ")));
  }
  return {parse_study(read_file(name_or_path), name_or_path),
          std::filesystem::path(name_or_path).parent_path().string()};
}

AlgorithmChoice algorithm_choice(const StudySpec& spec, const std::string& name,
                                 const Settings& options) {
  AlgorithmChoice choice = named_algorithm(spec, name);
  choice.options = complete_options(*choice.algorithm, options);
  choice.certificate = spec.certificate;
  return choice;
}

Study recorded_study(const StudyIdentity& identity, const std::string& file) {
  Study study = parse_study(identity.spec, file + " (its specification)");
  for (Sweep& sweep : study.spec.sweeps) {  // what has become of them since is not a line's fault
    for (GraphsEntry& entry : sweep.graphs) entry.location = file + ": ";
  }
  study.begun_with = side_records<GraphFileRecord>(identity);
  study.collected = side_records<CollectedFile>(identity);
  study.skipped = side_records<SkippedFile>(identity);
  study.stored_graphs = std::make_shared<const StoredGraphs>(stored_graphs(identity));
  return study;
}

std::string default_results_path(const StudySpec& spec) { return "ar3d-" + spec.name + ".h5"; }

}  // namespace ar3d
