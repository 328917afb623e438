// `ar3d list`: the rows of every catalogue.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/error.h"
#include "ar3d/base/nearest_name.h"
#include "ar3d/base/printable.h"
#include "ar3d/bench/spec/study_spec.h"
#include "ar3d/formats/catalog.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/generators/families.h"
#include "ar3d/verify/metrics/metrics.h"
#include "commands.h"
#include "options.h"

namespace ar3d {
namespace {

double degrees(Cosine c) {
  return std::acos(static_cast<double>(c.numerator) / c.denominator) * 180 / std::numbers::pi;
}

std::string size_text(const SizeBound& bound) {
  return fmt::format("{} x {} x {}", bound.axes[0].formula(), bound.axes[1].formula(),
                     bound.axes[2].formula());
}

void print_algorithm(const Algorithm& row) {
  const Guarantee& g = row.guarantee;
  print("{}: {}\n", row.name, row.summary);
  print("    {}; degree <= {}, <= {} bends per edge, angles {} {:.2f} degrees\n", row.source,
        g.max_degree, g.max_bends, g.angle_rule == AngleRule::exactly ? "exactly" : "at least",
        degrees(g.cosine));
  if (g.claim == Claim::measured) {
    print("    in real arithmetic: what rounding makes of it is measured; no box ({})\n",
          g.bound.source);
  } else {
    print("    box <= {} ({})\n", size_text(g.bound), g.bound.source);
  }
  for (const SettingSpec& option : row.options) {
    print("    option {} = {}..{} (default {}): {}\n", option.name, option.low, option.high,
          option.default_value, option.description);
  }
}

void print_family(const Family& row) {
  print("{}: {} (degree <= {}{})\n", row.name, row.summary, row.max_degree,
        row.is_random ? ", random" : "");
  for (const SettingSpec& parameter : row.parameters) {
    print("    parameter {} = {}..{} (default {}): {}\n", parameter.name, parameter.low,
          parameter.high, parameter.default_value, parameter.description);
  }
}

nlohmann::ordered_json settings_json(const std::vector<SettingSpec>& settings) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SettingSpec& one : settings) {
    json.push_back({{"name", one.name},
                    {"low", one.low},
                    {"high", one.high},
                    {"default", one.default_value},
                    {"description", one.description}});
  }
  return json;
}

nlohmann::ordered_json algorithm_json(const Algorithm& row) {
  const Guarantee& g = row.guarantee;
  nlohmann::ordered_json json = {
      {"name", row.name},
      {"summary", row.summary},
      {"source", row.source},
      {"is_proved", g.claim == Claim::proved},
      {"max_degree", g.max_degree},
      {"max_bends", g.max_bends},
      {"angles", g.angle_rule == AngleRule::exactly ? "exactly" : "at least"},
      {"degrees", degrees(g.cosine)},
      {"options", settings_json(row.options)}};
  for (const AxisBound& axis : g.bound.axes) {
    if (g.claim == Claim::proved) json["box"].push_back(axis.formula());
  }
  return json;
}

/// Prints the catalogues, or of them only `what`.
void print_list(const std::string& what) {
  using Object = nlohmann::ordered_json;
  Object all;
  const auto show = [&](const char* name, const char* title, const auto& rows, const auto& object,
                        const auto& print_row) {
    if (what != "all" && what != name) return;
    if (is_json_output) all[name] = Object::array();
    if (what == "all" && !is_json_output) print("\n== {} ==\n", title);
    for (const auto& row : rows) {
      if (is_json_output) all[name].push_back(object(row));
      if (!is_json_output) print_row(row);
    }
  };
  const auto name_and_summary = [](const auto& row) {
    return Object{{"name", row.name}, {"summary", row.summary}};
  };
  const auto print_both = [](const auto& row) { print("{}: {}\n", row.name, row.summary); };
  show("algorithms", "algorithms", algorithms(), algorithm_json, print_algorithm);
  const auto family_json = [](const Family& row) {
    return Object{{"name", row.name},
                  {"summary", row.summary},
                  {"max_degree", row.max_degree},
                  {"is_random", row.is_random},
                  {"parameters", settings_json(row.parameters)}};
  };
  show("families", "families", families(), family_json, print_family);
  const auto named_json = [](const NamedGraph& row) {
    return Object{{"name", row.name}, {"n", row.num_vertices}, {"summary", row.summary}};
  };
  show("named-graphs", "named graphs (family `named`, --set index=NUMBER)", named_graphs(),
       named_json, [](const NamedGraph& row) {
         print("{:2} {} (n = {}): {}\n", &row - named_graphs().data(), row.name, row.num_vertices,
               row.summary);
       });
  show("formats", "formats", graph_formats(), name_and_summary, print_both);
  const auto metric_json = [](const Metric& row) {
    return Object{{"name", row.name}, {"summary", row.definition}, {"unit", row.unit}};
  };
  show("metrics", "metrics", metrics(), metric_json, [](const Metric& row) {
    print("{}: {} ({}, {})\n", row.name, row.definition, row.unit,
          row.type == MetricType::int64 ? "int64" : "float64");
  });
  show("studies", "studies", named_studies(), name_and_summary, print_both);
  if (is_json_output) print_json(all);
}

/// Prints the specification of a named study, byte for byte.
void print_study(const std::string& what, const std::string& name) {
  if (what != "studies") {
    throw InputError(fmt::format("'{}': only a study is shown by its name", printable(name)));
  }
  const NamedStudy* const study = find_named_study(name);
  if (study == nullptr) {
    throw InputError(fmt::format("'{}' is none of `ar3d list studies`{}", printable(name),
                                 did_you_mean(name, names_of(named_studies()))));
  }
  if (is_json_output) return print_json({{"name", study->name}, {"toml", study->toml}});
  print("{}", study->toml);
}

/// "8n", "16/3n", "12n^2", "726n^1/2+1800": an extent as a word that proof/promise.ml reads.
std::string size_word(const AxisBound& bound) {
  const unsigned half = bound.half_power;
  return fmt::format("{}{}n{}{}", bound.numerator,
                     bound.denominator == 1 ? "" : fmt::format("/{}", bound.denominator),
                     half == 2       ? ""
                     : half % 2 == 0 ? fmt::format("^{}", half / 2)
                                     : fmt::format("^{}/2", half),
                     bound.constant == 0 ? "" : fmt::format("{:+}", bound.constant));
}

std::string gram_word(const Lattice& lattice) {
  const auto& g = lattice.gram;
  std::string word = fmt::format("{},{},{}", g[0][0], g[1][1], g[2][2]);
  if (g[0][1] != 0 || g[0][2] != 0 || g[1][2] != 0)
    word += fmt::format(",{},{},{}", g[0][1], g[0][2], g[1][2]);
  return lattice.gram_denominator == 1 ? word
                                       : fmt::format("{}:{}", word, lattice.gram_denominator);
}

/// Prints what the guarantee promises, as the options of ar3d_proved.
void print_promise(const Algorithm& row) {
  const Guarantee& g = row.guarantee;
  if (g.claim == Claim::measured)
    throw InputError(row.name + ": its drawings are measured, no promise is kept exactly");
  print("--bends {} --cosine {}/{} {} --gram {}", g.max_bends, g.cosine.numerator,
        g.cosine.denominator, g.angle_rule == AngleRule::exactly ? "--exactly" : "--at-least",
        gram_word(g.lattice));
  for (std::size_t i = 0; i < g.directions.size(); ++i) {
    const Vector& d = g.directions[i];
    print("{}{},{},{}", i == 0 ? " --directions " : ":", d.x, d.y, d.z);
  }
  if (g.vertices_in_plane) print(" --plane z=0");
  print(" --box {},{},{}\n", size_word(g.bound.axes[0]), size_word(g.bound.axes[1]),
        size_word(g.bound.axes[2]));
}

}  // namespace

void add_list(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand(
      "list", "Shows algorithms with their guarantee, families, metrics, studies");
  const auto what = std::make_shared<std::string>("all");
  verb->add_option(
          "WHAT", *what,
          "algorithms, families, named-graphs, formats, metrics or studies; everything if left out")
      ->check(one_of(
          {"all", "algorithms", "families", "named-graphs", "formats", "metrics", "studies"}));
  const auto study = std::make_shared<std::string>();
  verb->add_option("NAME", *study, "with studies: prints the specification of this one, in TOML");
  const auto promise = std::make_shared<std::string>();
  verb->add_option("--promise", *promise,
                   "Only what this algorithm promises, as the options of ar3d_proved")
      ->excludes("WHAT")
      ->excludes("NAME");
  add_json(*verb)->excludes("--promise");
  verb->footer(
      "Example: ar3d list families\nExample: ar3d list studies quick >mine.toml; ar3d study run "
      "mine.toml");
  verb->callback([what, study, promise] {
    if (!study->empty()) return print_study(*what, *study);
    if (promise->empty()) return print_list(*what);
    print_promise(find_algorithm(*promise));
  });
}

}  // namespace ar3d
