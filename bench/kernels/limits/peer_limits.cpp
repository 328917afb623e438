// Ours beside other programs, one thread, CPU time:
//   generate/PROGRAM/DEGREE/n:N   random regular graphs, each with a seed of its own. Peers begin
//                                 again until chance gives them a simple graph: genrang's times of
//                                 one n differ by a factor of forty, so means are compared.
//                                 igraph_k_regular_game promises no distribution.
//   read/graphml/PROGRAM/n:N      GraphML from memory into a finished graph
//   crossings/PROGRAM/n:N         CGAL's intersecting boxes with our exact test of every pair that
//                                 they name, and our whole certificate: the same verdict
#include <fmt/format.h>
#include <igraph/igraph.h>
#include <malloc.h>
#include <sys/resource.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/generators/random_graphs.h"
#include "ar3d/verify/certificate.h"
#include "ar3d/verify/crossings/contacts.h"
#include "limits.h"

#ifdef AR3D_HAVE_CGAL
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>
#endif

namespace ar3d::kernels {
namespace {

using benchmark::State;

// Each makes one graph of n vertices and degree d, and returns the CPU seconds.
using Generator = double (*)(std::uint64_t n, std::uint32_t d, std::uint32_t seed);

/// Edges and rows of the graph, as every user of the library pays for them.
double generate_ours(std::uint64_t n, std::uint32_t d, std::uint32_t seed) {
  const OneThread one_thread;
  const Stopwatch time(kCpuTime);
  benchmark::DoNotOptimize(random_regular(n, d, seed).num_edges());
  return time.seconds();
}

double seconds_of_children() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
}

/// Debian package nauty; writes sparse6 to /dev/null.
double generate_genrang(std::uint64_t n, std::uint32_t d, std::uint32_t seed) {
  const double before = seconds_of_children();
  const std::string command =
      fmt::format("exec nauty-genrang -q -r{} -S{} {} 1 >/dev/null 2>&1", d, seed, n);
  if (std::system(command.c_str()) != 0) throw std::runtime_error("missing: nauty-genrang (nauty)");
  return seconds_of_children() - before;
}

/// Ends igraph's graph and tells how long it took. @throws std::runtime_error on an error.
double finished(igraph_error_t error, igraph_t& graph, const Stopwatch& time) {
  const double seconds = time.seconds();
  if (error != IGRAPH_SUCCESS) throw std::runtime_error("igraph failed");
  igraph_destroy(&graph);
  return seconds;
}

double generate_igraph(std::uint64_t n, std::uint32_t d, std::uint32_t seed) {
  igraph_t graph;
  igraph_rng_seed(igraph_rng_default(), seed);
  const Stopwatch time(kCpuTime);
  return finished(igraph_k_regular_game(&graph, static_cast<igraph_integer_t>(n),
                                        static_cast<igraph_integer_t>(d), false, false),
                  graph, time);
}

/// igraph's uniform ones: the configuration model with full restart.
double generate_igraph_uniform(std::uint64_t n, std::uint32_t d, std::uint32_t seed) {
  igraph_t graph;
  igraph_vector_int_t degrees;
  igraph_rng_seed(igraph_rng_default(), seed);
  igraph_vector_int_init(&degrees, static_cast<igraph_integer_t>(n));
  igraph_vector_int_fill(&degrees, static_cast<igraph_integer_t>(d));
  const Stopwatch time(kCpuTime);
  const igraph_error_t error =
      igraph_degree_sequence_game(&graph, &degrees, nullptr, IGRAPH_DEGSEQ_CONFIGURATION_SIMPLE);
  igraph_vector_int_destroy(&degrees);
  return finished(error, graph, time);
}

void add_generator(const char* program, Generator generate) {
  for (const std::uint32_t degree : {3u, 4u}) {
    add_limit(
        fmt::format("generate/{}/{}", program, degree), {1'000, 1'000'000},
        [=, seed = 0u](State& state) mutable {
          for (auto _ : state) {
            malloc_trim(0);  // as a new process
            state.SetIterationTime(generate(size_of(state), degree, ++seed));
          }
          state.counters["vertices"] = static_cast<double>(size_of(state));
        },
        [](benchmark::internal::Benchmark* each) { each->UseManualTime(); });
  }
}

void read_ours(std::string& text) {
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
  if (error != IGRAPH_SUCCESS) throw std::runtime_error("missing: GraphML in igraph");
  igraph_destroy(&graph);
}

void add_reader(const std::string& program, void (*read)(std::string& text)) {
  add_limit("read/graphml/" + program, {1'000, 300'000}, [read](State& state) {
    const OneThread one_thread;
    std::string text =
        text_of(find_graph_format("graphml"), find_family("random-cubic"), size_of(state));
    for (auto _ : state) read(text);
    state.counters["bytes"] = static_cast<double>(text.size());
  });
}

bool valid_by_counting(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee) {
  return certify(graph, drawing, guarantee).valid();
}

#ifdef AR3D_HAVE_CGAL

using verify::SegmentId;

/// Exact, since coordinates of so small a drawing are below 2^53.
std::array<double, 3> as_doubles(Point p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

/// True if no two segments meet where they must not. Every vertex has an edge, so its place is an
/// end of a segment.
bool valid_by_boxes(const Graph&, const Drawing& drawing, const Guarantee&) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, SegmentId>;
  const verify::Segments segments(drawing);
  std::vector<Box> boxes;
  boxes.reserve(segments.size());
  for (SegmentId s = 0; s < segments.size(); ++s) {
    GrowingBox box;
    box.add(segments.from(s));
    box.add(segments.to(s));
    std::array<double, 3> low = as_doubles(box.low());
    std::array<double, 3> high = as_doubles(box.high());
    boxes.emplace_back(low.data(), high.data(), s);
  }
  verify::Findings findings(100);
  verify::Contacts contacts(segments, findings);
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    contacts.examine(std::min(a.info(), b.info()), std::max(a.info(), b.info()));
  });
  contacts.report();
  return findings.empty();
}

#else

bool valid_by_boxes(const Graph&, const Drawing&, const Guarantee&) {
  throw std::runtime_error("missing: CGAL when this was built (libcgal-dev)");
}

#endif

void add_judge(const std::string& program,
               bool (*valid)(const Graph&, const Drawing&, const Guarantee&)) {
  add_limit("crossings/" + program, {1'000, 10'000}, [valid](State& state) {
    const OneThread one_thread;
    const Algorithm& diamond = find_algorithm("diamond");
    const Graph& graph = graph_of(random_family(diamond), size_of(state));
    const Drawing& drawing = drawing_of(diamond, size_of(state));
    for (auto _ : state) {
      if (!valid(graph, drawing, diamond.guarantee)) throw std::runtime_error("not valid");
    }
  });
}

}  // namespace

void register_peers() {
  add_generator("ours", generate_ours);
  add_generator("nauty-genrang", generate_genrang);
  add_generator("igraph", generate_igraph_uniform);
  add_generator("igraph_k_regular_game", generate_igraph);
  add_reader("ours", read_ours);
  add_reader("igraph", read_igraph);
  add_judge("ours", valid_by_counting);
  add_judge("cgal", valid_by_boxes);
}

}  // namespace ar3d::kernels
