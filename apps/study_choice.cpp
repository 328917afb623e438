#include "study_choice.h"

#include "ar3d/base/error.h"
#include "numbers.h"

namespace ar3d {
namespace {

// The text that the options are short for has lines that nobody saw: messages are to name none.
StudySpec parse_options(const GraphsStudy& graphs) {
  const std::string place = "--graphs:";
  try {
    return parse_study(graphs_study_text(graphs), "--graphs");
  } catch (const InputError& error) {
    std::string message = error.what();
    const std::size_t end = message.find_first_not_of("0123456789", place.size());
    if (message.starts_with(place) && end != std::string::npos && message[end] == ':') {
      message.erase(place.size() - 1, end - place.size() + 1);
    }
    throw InputError(message);
  }
}

}  // namespace

void add_study_choice(CLI::App& verb, StudyChoice& choice) {
  verb.add_option("STUDY", choice.study, "a TOML file or a study of `ar3d list studies`");
  GraphsStudy& graphs = choice.graphs;
  CLI::Option* const files =
      verb.add_option(
              "--graphs", graphs.files,
              "instead of STUDY: all graphs of this file, or of the files that a pattern in "
              "quotes matches; may be repeated")
          ->type_size(1)
          ->allow_extra_args(false);
  verb.add_option("--algorithm", graphs.algorithms,
                  "with --graphs: one to draw them with; may be repeated, all if left out")
      ->type_size(1)
      ->allow_extra_args(false)
      ->needs(files);
  verb.add_option("--from", choice.reading.options.format,
                  "with --graphs: their format; detected by content if left out")
      ->needs(files);
  add_edge_list_options(verb, choice.reading);
  for (const char* name : {"--base", "--first-line"}) verb.get_option(name)->needs(files);
  verb.add_option("--sample", graphs.sample, "with --graphs: so many graphs of each file")
      ->check(whole_number(1, 10000000))
      ->needs(files);
  verb.add_option("--seed", graphs.seed, "with --graphs: of sample and labels, default 0")
      ->check(whole_number(0, std::numeric_limits<std::int64_t>::max()))
      ->needs(files);
  verb.add_flag("--simple", graphs.simple,
                "with --graphs: loops and parallel edges are dropped; else they are refused")
      ->needs(files);
  verb.add_flag("--largest-component", graphs.largest_component,
                "with --graphs: of each graph only its largest component")
      ->needs(files);
  verb.add_flag("--shuffle", graphs.shuffle, "with --graphs: the labels permuted at random")
      ->needs(files);
}

StudySpec chosen_study(const StudyChoice& choice) {
  if (choice.study.empty() == choice.graphs.files.empty()) {
    throw InputError("either STUDY or --graphs says what to run; --help shows both");
  }
  if (!choice.study.empty()) return load_study(choice.study);
  GraphsStudy graphs = choice.graphs;
  graphs.reading = choice.reading.read_options();
  StudySpec spec = parse_options(graphs);
  for (Sweep& sweep : spec.sweeps) {
    for (GraphsEntry& entry : sweep.graphs) entry.place = "--graphs: ";
  }
  return spec;
}

}  // namespace ar3d
