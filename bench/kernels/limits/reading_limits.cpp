// GraphML from memory into a finished graph: one thread, CPU time, beside igraph.
#include <fmt/format.h>
#include <igraph/igraph.h>

#include <cstdio>
#include <stdexcept>
#include <string>

#include "../inputs.h"
#include "ar3d/bench/measure/one_thread.h"
#include "limit.h"
#include "turns.h"

namespace ar3d::limits {
namespace {

void read_ours(const std::string& text) {
  GraphReader reader(TextInput("memory", bytes_of(text)), {.format = "graphml"});
  if (!reader.next()) throw std::runtime_error("no graph in the text");
}

void read_igraph(std::string& text) {
  igraph_set_error_handler(igraph_error_handler_ignore);
  std::FILE* file = fmemopen(text.data(), text.size(), "r");
  if (file == nullptr) throw std::runtime_error("a text cannot be opened as a file");
  igraph_t graph;
  const auto error = igraph_read_graph_graphml(&graph, file, 0);
  std::fclose(file);
  if (error != IGRAPH_SUCCESS) throw NotMeasured("igraph does not read GraphML here");
  igraph_destroy(&graph);
}

void measure_graphml(const Scale& scale, std::vector<Limit>& limits) {
  const OneThread one_thread;
  const GraphFormat& format = find_graph_format("graphml");
  std::string text = kernels::text_of(format, find_family("random-cubic"), scale.n);
  Turns turns(
      {timed(Clock::cpu, [&] { read_ours(text); }), timed(Clock::cpu, [&] { read_igraph(text); })});
  turns.run(scale.repetitions, kSlowSeconds);
  const double megabytes = 1e-6 * static_cast<double>(text.size());
  limits[0].measured = megabytes / turns.median_of(0);
  limits[0].remark =
      fmt::format("{:.1f} MB, igraph {} {:.3g} MB/s{}", megabytes, IGRAPH_VERSION,
                  megabytes / turns.median_of(1), turns.rounds_remark(scale.repetitions));
}

}  // namespace

std::vector<Group> reading_groups() {
  return {{"read/graphml",
           300'000,
           {{"GraphML, random cubic", "none", {Goal::Kind::at_least, 100, " MB/s"}}},
           measure_graphml}};
}

}  // namespace ar3d::limits
