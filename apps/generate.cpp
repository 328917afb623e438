#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ar3d/formats/catalog.h"
#include "ar3d/formats/text/output.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/model/assignments.h"
#include "commands.h"

namespace ar3d {
namespace {

struct GenerateArguments {
  std::string family;
  std::uint64_t n = 0;
  std::uint64_t seed = 1;
  std::uint64_t count = 1;
  std::vector<std::string> parameters;
  std::string format;
  std::string output = "-";
};

const GraphFormat& output_format(const GenerateArguments& arguments) {
  if (!arguments.format.empty()) return find_graph_format(arguments.format);
  const GraphFormat* by_path = graph_format_of_path(arguments.output);
  return by_path != nullptr ? *by_path : find_graph_format("sparse6");
}

void generate_graphs(const GenerateArguments& arguments) {
  const Family& family = find_family(arguments.family);
  const auto parameters =
      complete_parameters(family, parse_assignments<ParameterValue>(arguments.parameters));
  const GraphFormat& format = output_format(arguments);
  OutputFile file(arguments.output);
  const std::unique_ptr<GraphWriter> writer = format.writer(file, {});
  for (std::uint64_t i = 0; i < arguments.count; ++i) {
    writer->write(generate(family, arguments.n, arguments.seed + i, parameters));
    file.flush_if_full();
  }
  writer->finish();
  file.commit();
}

}  // namespace

void add_generate(CLI::App& app, int&) {
  CLI::App* verb = app.add_subcommand("generate", "Writes graphs of a family");
  const auto arguments = std::make_shared<GenerateArguments>();
  verb->add_option("FAMILY", arguments->family, "a family of `ar3d list families`")->required();
  verb->add_option("-n", arguments->n, "wanted number of vertices; the nearest valid one is taken")
      ->required();
  verb->add_option("--seed", arguments->seed, "seed of the first graph; each further one adds 1");
  verb->add_option("--count", arguments->count, "number of graphs");
  verb->add_option("--set", arguments->parameters,
                   "a parameter of the family, name=integer; may be repeated")
      ->type_size(1)
      ->allow_extra_args(false);
  verb->add_option("--format", arguments->format,
                   "graph format; by the file's ending, else sparse6");
  verb->add_option("-o,--output", arguments->output, "file, or - for standard output");
  verb->footer("Example: ar3d generate generalised-petersen -n 100 --set k=7 -o gp.s6");
  verb->callback([arguments] { generate_graphs(*arguments); });
}

}  // namespace ar3d
