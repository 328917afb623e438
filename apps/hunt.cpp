#include "ar3d/bench/search/hunt.h"

#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "ar3d/base/error.h"
#include "ar3d/model/settings.h"
#include "commands.h"
#include "graph_input.h"
#include "numbers.h"
#include "subject_arguments.h"

namespace ar3d {
namespace {

struct HuntArguments {
  SubjectArguments subject;
  std::string family = "all";
  std::vector<std::string> parameters;
  std::string from;
  GraphInput reading;
  HuntOptions options;
};

std::vector<FamilyChoice> chosen_families(const HuntArguments& arguments,
                                          const Algorithm& algorithm) {
  if (!arguments.from.empty()) {
    CorpusOptions options;
    options.reading = arguments.reading.read_options();
    const auto graphs =
        named_corpus(arguments.from, std::make_shared<const Corpus>(arguments.from, options));
    return {{&graphs->family, {}, graphs}};
  }
  if (arguments.family == "all" && arguments.parameters.empty()) {
    return fitting_families(algorithm, arguments.options.n);
  }
  const Family& family = find_family(arguments.family);
  return {{&family, complete_parameters(family, parse_settings(arguments.parameters))}};
}

int hunt_and_show(HuntArguments arguments) {
  refuse_unsafe_exhibit(arguments.subject, arguments.from);
  const Subject subject = subject_of(arguments.subject);
  arguments.options.families = chosen_families(arguments, *subject.choice.algorithm);
  const HuntResult result =
      hunt(subject, rule_of(arguments.subject), arguments.options, [](const HuntResult& so_far) {
        fmt::print(stderr, "{:>8} graphs: {:.4f} from {}\n", so_far.evaluations, so_far.best.ratio,
                   so_far.start.family->name);
      });
  fmt::print("{} graphs drawn and certified, {} starts; the best one comes from {} {}\n",
             result.evaluations, result.starts, result.start.family->name,
             result.start.corpus ? fmt::format("graph {}", result.start_place)
                                 : fmt::format("with seed {}", result.start_seed));
  fmt::print("{}", trial_text(result.best, arguments.subject));
  if (!arguments.subject.output.empty()) {
    write_exhibit(subject, result.best, arguments.subject);
    fmt::print("{}\n", shrink_line(result.best, arguments.subject));
  }
  return result.best.failure.empty() ? kPass : kViolated;
}

}  // namespace

void add_hunt(CLI::App& app, int& exit_code) {
  CLI::App* verb = app.add_subcommand(
      "hunt", "Searches for the graph that comes closest to a bound, or breaks one");
  const auto arguments = std::make_shared<HuntArguments>();
  add_subject_options(*verb, arguments->subject);
  HuntOptions& options = arguments->options;
  verb->add_option("--family", arguments->family,
                   "where searches start: a family, or all that the algorithm draws");
  verb->add_option("--parameter", arguments->parameters,
                   "a parameter of the family, name=integer; may be repeated")
      ->type_size(1)
      ->allow_extra_args(false);
  verb->add_option("-n", options.n, "requested number of vertices")->check(whole_number(1, 100000));
  verb->add_option(
          "--from", arguments->from,
          "search from the graphs of this file instead, in any format, one after the other")
      ->excludes(verb->get_option("--family"))
      ->excludes(verb->get_option("--parameter"))
      ->excludes(verb->get_option("-n"));
  add_edge_list_options(*verb, arguments->reading);
  for (const char* name : {"--base", "--first-line"}) {
    verb->get_option(name)->needs(verb->get_option("--from"));
  }
  verb->add_option("--seed", options.seed, "seed of the search")->check(whole_number(0));
  verb->add_option("--evaluations", options.evaluations, "how many graphs to draw and certify")
      ->check(whole_number(1, 1000000000));
  verb->add_option("--seconds", options.seconds,
                   "stop after that time even so (the result then depends on the machine)")
      ->check(finite_number(true));
  verb->add_option("-o,--output", arguments->subject.output,
                   "prefix of the files that show the best one: .s6, .jsonl, .svg, .txt");
  verb->footer(
      "Exit code 4 if a drawing is violated.\n"
      "Example: ar3d hunt --algorithm diamond -n 40 --evaluations 5000 --measure z -o tall");
  verb->callback([arguments, &exit_code] { exit_code = hunt_and_show(*arguments); });
}

}  // namespace ar3d
