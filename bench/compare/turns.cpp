// Two versions of something become settings of one study, whose timing phase draws them in turns.
// The study is made as the text of a specification, so that its results say what was run.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>

#include "ar3d/base/error.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/compare/interleave.h"
#include "ar3d/bench/spec/toml_table.h"

namespace ar3d {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 2> kSuffixes = {".A", ".B"};

/// Those of one sweep that are compared, each once.
std::vector<CurveKey> settings_of(const Sweep& sweep, const CurveKey* only) {
  std::vector<CurveKey> settings;
  for (const AlgorithmChoice& choice : sweep.algorithms) {
    const CurveKey key = {choice.algorithm->name, settings_text(choice.options), {}, {}};
    if ((only == nullptr || *only == key) && std::ranges::count(settings, key) == 0) {
      settings.push_back(key);
    }
  }
  return settings;
}

template <class T>
void add_once(std::vector<T>& list, const T& value) {
  if (std::ranges::count(list, value) == 0) list.push_back(value);
}

/// Throws unless the two differ in names, programs and the algorithms of sweeps only.
void require_alike(toml::table base, toml::table now) {
  std::set<std::string> keys;
  for (toml::table* const side : {&base, &now}) {
    for (const char* key : {"study", "algorithm"}) side->erase(key);
    for_each_table(*side, "sweep", [](toml::table& sweep) { sweep.erase("algorithms"); });
    for (const auto& [key, value] : *side) keys.insert(std::string(key.str()));
  }
  for (const std::string& key : keys) {
    const auto text = [&](const toml::table& side) {
      return side.contains(key) ? toml_text_of(*side.get(key)) : std::string();
    };
    if (text(base) == text(now)) continue;
    throw InputError(fmt::format("the two specifications differ in '{}'", printable(key)));
  }
}

bool is_program(const std::vector<Study>& sides, const std::string& algorithm) {
  return std::ranges::any_of(
      sides, [&](const Study& side) { return find_program(side.spec, algorithm) != nullptr; });
}

/// What is said of a program holds of both its versions.
void say_of_both(const std::vector<Study>& sides, toml::table& most) {
  const toml::table said = most;
  for (const auto& [name, n] : said) {
    if (!is_program(sides, std::string(name.str()))) continue;
    for (const char* suffix : kSuffixes) most.insert(std::string(name.str()) + suffix, n);
    most.erase(name.str());
  }
}

void say_of_both(const std::vector<Study>& sides, toml::table& sweep, const char* key) {
  toml::array patterns;
  for_each_table(sweep, key, [&](toml::table& pattern) {
    const std::string name = pattern["algorithm"].value_or(std::string());
    if (!is_program(sides, name)) return patterns.push_back(pattern);
    for (const char* suffix : kSuffixes) {
      pattern.insert_or_assign("algorithm", name + suffix);
      patterns.push_back(pattern);
    }
  });
  if (!patterns.empty()) sweep.insert_or_assign(key, patterns);
}

/// The algorithms of one sweep of both sides; none: it has no setting of one of them.
/// @param pairs, remarks  get what turns_of returns.
toml::array algorithms_of(const std::vector<Study>& sides, const std::vector<CurveKey>& only,
                          std::size_t sweep, std::vector<SettingPair>& pairs,
                          std::vector<std::string>& remarks) {
  std::array<std::vector<CurveKey>, 2> settings;
  for (const std::size_t side : {0U, 1U}) {
    settings[side] =
        settings_of(sides[side].spec.sweeps[sweep], only.empty() ? nullptr : &only[side]);
    if (settings[side].empty()) return {};
  }
  const std::size_t count = settings[0].size();
  if (count != settings[1].size()) {
    throw InputError(fmt::format("sweep {} has {} settings on one side and {} on the other",
                                 sweep + 1, count, settings[1].size()));
  }
  std::vector<CurveKey> compared;
  for (std::size_t i = 0; i < count; ++i) {
    SettingPair pair = {"", settings[0][i], settings[1][i]};
    const bool is_same = pair.base == pair.now;
    pair.name = algorithm_label(pair.base);
    if (is_same && !is_program(sides, pair.base.algorithm)) {
      add_once(remarks, pair.name + " is the same on both sides: not compared");
      continue;
    }
    if (!is_same) pair.name += " -> " + algorithm_label(pair.now);
    if (is_program(sides, pair.base.algorithm)) pair.base.algorithm += kSuffixes[0];
    if (is_program(sides, pair.now.algorithm)) pair.now.algorithm += kSuffixes[1];
    add_once(pairs, pair);
    add_once(compared, pair.base);
    add_once(compared, pair.now);
  }
  toml::array algorithms;
  for (const CurveKey& key : compared) {
    toml::table& entry = algorithms.emplace_back<toml::table>();
    entry.insert("algorithm", key.algorithm);
    for (const auto& [name, value] : parse_settings(key.options)) entry.insert(name, value);
  }
  return algorithms;
}

/// Gives every program of a study another command.
Study with_commands(const Study& study,
                    const std::function<toml::array(const ExternalAlgorithm&)>& command_of) {
  toml::table text = parse_toml(movable_text(study), study.spec.name);
  auto program = study.spec.programs.begin();
  for_each_table(text, "algorithm", [&](toml::table& table) {
    table.insert_or_assign("command", command_of(**program++));
  });
  return parse_study(toml_text_of(text), study.spec.name);
}

}  // namespace

std::vector<CurveKey> settings_of(const StudySpec& spec) {
  std::vector<CurveKey> settings;
  for (const Sweep& sweep : spec.sweeps) {
    for (const CurveKey& key : settings_of(sweep, nullptr)) add_once(settings, key);
  }
  return settings;
}

std::tuple<Study, std::vector<SettingPair>, std::vector<std::string>> turns_of(
    const std::vector<Study>& sides, const std::vector<CurveKey>& settings, std::size_t rounds,
    std::size_t otherwise) {
  std::array<toml::table, 2> texts;
  toml::array programs, sweeps;
  std::vector<SettingPair> pairs;
  std::vector<std::string> remarks;
  for (const std::size_t side : {0U, 1U}) {
    const Study& study = sides[side];
    texts[side] = parse_toml(movable_text(study), study.spec.name);
    for (const char* key : {"count", "keep_drawings", "description"}) texts[side].erase(key);
    for_each_table(texts[side], "algorithm", [&](toml::table& program) {
      const std::string name = program["name"].value_or(std::string());
      program.insert_or_assign("name", name + kSuffixes[side]);
      programs.push_back(program);
    });
  }
  require_alike(texts[0], texts[1]);
  toml::table& text = texts[0];
  for_each_table(text, "sweep", [&, number = std::size_t{0}](toml::table& sweep) mutable {
    const toml::array algorithms = algorithms_of(sides, settings, number++, pairs, remarks);
    if (algorithms.empty()) return;
    sweep.insert_or_assign("algorithms", algorithms);
    for (const char* key : {"strong", "weak", "strong_ranks", "weak_ranks"}) sweep.erase(key);
    if (rounds > 0 || !sweep.contains("timed_repetitions")) {
      const std::size_t timed = rounds > 0 ? rounds : otherwise;
      sweep.insert_or_assign("timed_repetitions", static_cast<std::int64_t>(timed));
    }
    for (const char* key : {"include", "exclude"}) say_of_both(sides, sweep, key);
    sweeps.push_back(sweep);
  });
  if (pairs.empty()) {
    throw InputError(fmt::format("nothing to compare: {}", fmt::join(remarks, "; ")));
  }
  if (!programs.empty()) text.insert_or_assign("algorithm", programs);
  text.insert_or_assign("sweep", sweeps);
  if (toml::table* const most = text["max_n"].as_table()) say_of_both(sides, *most);
  text.insert("timing", toml::table());  // unless it is there
  text["timing"].as_table()->insert_or_assign("restart", true);
  text.insert_or_assign("study", sides[0].spec.name + "-turns");
  return {parse_study(toml_text_of(text), "the study in turns"), std::move(pairs),
          std::move(remarks)};
}

Study with_command(const Study& study, const std::string& command) {
  if (study.spec.programs.size() != 1) {
    throw InputError(fmt::format(
        "'{}' is no setting of study '{}', which has {} programs whose command it could be",
        printable(command), study.spec.name, study.spec.programs.size()));
  }
  if (command.find_first_of("'\"\\") != std::string::npos) {
    throw InputError(fmt::format("'{}': a command in turns is words between blanks, without quotes",
                                 printable(command)));
  }
  std::istringstream in(command);
  toml::array words;
  for (std::string word; in >> word;) words.push_back(word);
  return with_commands(study, [&](const auto&) { return words; });
}

Study with_folder(const Study& study, const std::string& folder) {
  return with_commands(study, [&](const ExternalAlgorithm& program) {
    toml::array words{"env", "-C", folder};
    for (const std::string& word : program.command) {
      const bool is_path = words.size() > 3 || word.find('/') != std::string::npos;
      const fs::path there = fs::path(folder) / word;
      words.push_back(is_path && fs::is_regular_file(there) ? there.string() : word);
    }
    return words;
  });
}

}  // namespace ar3d
