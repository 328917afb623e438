// Every stage on random graphs whose vertices are in random order, on one thread, CPU time:
//   draw/ALGORITHM/FAMILY/effort:E/n:N  a drawing, no bend read
//   draw/search/FAMILY/n:N              the yardstick: a plain breadth-first search
//   draw/boost_search/FAMILY/n:N        Boost.Graph's search of the same graph
//   certify/ALGORITHM/n:N               the proof of that drawing
//   measure/ALGORITHM/n:N               its metrics and hash
//   closest/ALGORITHM/n:N               its closest pair of vertices
//   bisect/FAMILY/n:N                   the cut of a graph for volume_at_least, n up to 16,384
//   memory/WORK/ALGORITHM/n:N           bytes at their highest beyond those before the work
#include <fmt/format.h>
#include <malloc.h>

#include <boost/graph/breadth_first_search.hpp>
#include <functional>
#include <map>
#include <mutex>
#include <stdexcept>
#include <utility>
#include <vector>

#include "ar3d/bench/measure/cores.h"
#include "ar3d/bench/measure/instruments.h"
#include "ar3d/model/boost_graph.h"
#include "ar3d/verify/examination.h"
#include "ar3d/verify/metrics/summary_pass.h"
#include "ar3d/verify/metrics/volume_bound.h"
#include "limits.h"

namespace ar3d::kernels {

const Drawing& drawing_of(const Algorithm& algorithm, std::uint64_t n) {
  static std::mutex mutex;
  static std::map<std::pair<std::string, std::uint64_t>, Drawing> kept;
  const std::lock_guard lock(mutex);
  const std::pair wanted(algorithm.name, n);
  if (const auto found = kept.find(wanted); found != kept.end()) return found->second;
  std::erase_if(kept, [](const auto& entry) { return entry.first.second > 1'000'000; });
  return kept.emplace(wanted, draw(algorithm, graph_of(random_family(algorithm), n))).first->second;
}

namespace {

using benchmark::State;

void count(State& state, const Graph& graph) {
  state.counters["vertices"] = graph.num_vertices();
  state.counters["bytes"] = static_cast<double>(bytes_of_graph(graph));
}

void draw_limit(State& state, const Algorithm& algorithm, const Settings& options) {
  const OneThread one_thread;
  const Graph& graph = graph_of(random_family(algorithm), size_of(state));
  for (auto _ : state) {
    benchmark::DoNotOptimize(draw(algorithm, graph, options).num_edges());
  }
  count(state, graph);
}

void search_limit(State& state, const Family& family) {
  const Graph& graph = graph_of(family, size_of(state));
  for (auto _ : state) benchmark::DoNotOptimize(search_breadth_first(graph).data());
  count(state, graph);
}

/// Boost's search visits one component: the first by breadth_first_search, which clears all
/// colours, the others by its breadth_first_visit.
void boost_search_limit(State& state, const Family& family) {
  const Graph& graph = graph_of(family, size_of(state));
  for (auto _ : state) {
    std::vector<boost::default_color_type> colours(graph.num_vertices());
    const auto colour =
        boost::make_iterator_property_map(colours.begin(), get(boost::vertex_index, graph));
    boost::breadth_first_search(graph, Vertex{0}, boost::color_map(colour));
    for (Vertex start = 1; start < graph.num_vertices(); ++start) {
      if (colours[start] != boost::white_color) continue;
      boost::breadth_first_visit(graph, start, boost::color_map(colour));
    }
    benchmark::DoNotOptimize(colours.data());
  }
  count(state, graph);
}

void certify_limit(State& state, const Algorithm& algorithm) {
  const OneThread one_thread;
  const Graph& graph = graph_of(random_family(algorithm), size_of(state));
  const Drawing& drawing = drawing_of(algorithm, size_of(state));
  std::uint64_t segments = 0;
  for (auto _ : state) {
    const Certificate certificate = certify(graph, drawing, algorithm.guarantee);
    if (!certificate.valid()) throw std::runtime_error("a drawing is not valid");
    segments = certificate.segments;
  }
  count(state, graph);
  state.counters["segments"] = static_cast<double>(segments);
}

constexpr ExaminationParts kMeasured{.certificate = false, .metrics = true, .hash = true};

void measure_limit(State& state, const Algorithm& algorithm) {
  const OneThread one_thread;
  const Graph& graph = graph_of(random_family(algorithm), size_of(state));
  const Drawing& drawing = drawing_of(algorithm, size_of(state));
  for (auto _ : state) {
    benchmark::DoNotOptimize(examine(graph, drawing, algorithm.guarantee, kMeasured));
  }
  count(state, graph);
}

void closest_limit(State& state, const Algorithm& algorithm) {
  const Graph& graph = graph_of(random_family(algorithm), size_of(state));
  const Drawing& drawing = drawing_of(algorithm, size_of(state));
  for (auto _ : state) benchmark::DoNotOptimize(verify::closest_pair(drawing));
  count(state, graph);
}

void bisect_limit(State& state, const Family& family) {
  const Graph& graph = graph_of(family, size_of(state));
  for (auto _ : state) {
    GraphNeeds needs = needs_of(graph);
    seek_bisection(graph, find_algorithm("compact").guarantee, needs);
    state.counters["bisection"] = static_cast<double>(needs.bisection);
  }
  count(state, graph);
}

/// Sets the counter `bytes` to what `work` takes at its highest beyond what is there before.
void measure_bytes(State& state, const std::function<void()>& work) {
  const OneThread one_thread;
  for (auto _ : state) {
    malloc_trim(0);
    RowMemory memory(MemoryScope::row);
    const std::int64_t before = memory.begin_row();
    if (memory.scope() == MemoryScope::process) {
      throw std::runtime_error("missing: the right to reset the kernel's mark of memory");
    }
    work();
    const auto bytes = static_cast<double>(memory.peak_bytes() - before);
    if (bytes <= 0) throw std::runtime_error("missing: enough memory for the kernel's mark");
    state.counters["bytes"] = bytes;
  }
}

void add_memory_of_drawing(const Algorithm& diamond) {
  const auto draw_and_measure = [&diamond](const Graph& graph) {
    const Drawing drawing = draw(diamond, graph);
    benchmark::DoNotOptimize(examine(graph, drawing, diamond.guarantee, kMeasured));
  };
  const auto add = [&](const std::string& name, auto work) {
    add_limit(name, {1'000, 1'000'000, 10'000'000}, [&diamond, work](State& state) {
      const Graph& graph = graph_of(random_family(diamond), size_of(state));
      measure_bytes(state, [&] { work(graph); });
      state.counters["vertices"] = graph.num_vertices();
    });
  };
  add("memory/draw/diamond",
      [&](const Graph& graph) { benchmark::DoNotOptimize(draw(diamond, graph).num_edges()); });
  add("memory/draw_and_measure/diamond", draw_and_measure);
  add_limit("memory/whole/diamond", {1'000, 10'000'000, 100'000'000}, [=, &diamond](State& state) {
    measure_bytes(state, [&] {
      draw_and_measure(generate(random_family(diamond), size_of(state), kSeed, {{"shuffle", 1}}));
    });
    state.counters["vertices"] = static_cast<double>(size_of(state));
  });
}

void certificate_memory(State& state, const Algorithm& algorithm) {
  const Graph& graph = graph_of(random_family(algorithm), size_of(state));
  const Drawing& drawing = drawing_of(algorithm, size_of(state));
  std::uint64_t segments = 0;
  measure_bytes(state, [&] { segments = certify(graph, drawing, algorithm.guarantee).segments; });
  state.counters["segments"] = static_cast<double>(segments);
}

/// Registers the kernel for all sizes at which one drawing takes seconds.
template <class Kernel>
void add_sizes(const std::string& name, const Algorithm& algorithm, Kernel kernel) {
  const auto with_algorithm = [kernel, &algorithm](State& state) { kernel(state, algorithm); };
  if (algorithm.name == "two-bend-109") {  // near n^1.4 to draw, more to certify
    const auto once = [](benchmark::internal::Benchmark* each) { each->Iterations(1); };
    add_limit(name, {1'000, 10'000, 25'000, 100'000}, with_algorithm, once);
    if (name.starts_with("draw/")) add_limit(name, {1'000'000}, with_algorithm, once);
  } else {
    add_limit(name, {1'000, 100'000, 1'000'000, 10'000'000}, with_algorithm);
  }
}

}  // namespace

void register_stages() {
  add_memory_of_drawing(find_algorithm("diamond"));
  for (const char* name : {"random-4-regular", "random-cubic"}) {
    const Family& family = find_family(name);
    const auto add = [&](const char* what, auto kernel) {
      add_limit(fmt::format("draw/{}/{}", what, name), {1'000, 100'000, 1'000'000, 10'000'000},
                [kernel, &family](State& state) { kernel(state, family); });
    };
    add("search", search_limit);
    add("boost_search", boost_search_limit);
    add_limit(fmt::format("bisect/{}", name), {1'000, 10'000},
              [&family](State& state) { bisect_limit(state, family); });
  }
  const Algorithm& two_bend = find_algorithm("two-bend-120");  // it has no efforts
  add_limit("draw/two-bend-120/random-cubic", {1'000, 100'000},
            [&two_bend](State& state) { draw_limit(state, two_bend, {}); });
  add_limit("certify/two-bend-120", {1'000, 100'000},
            [&two_bend](State& state) { certify_limit(state, two_bend); });
  for (const Algorithm* row : proved_algorithms()) {
    const Algorithm& algorithm = *row;
    const std::string& name = algorithm.name;
    for (const int effort : {0, 1}) {
      add_sizes(fmt::format("draw/{}/{}/effort:{}", name, random_family(algorithm).name, effort),
                algorithm, [effort](State& state, const Algorithm& a) {
                  draw_limit(state, a, {{"effort", effort}});
                });
    }
    add_sizes("certify/" + name, algorithm, certify_limit);
    add_sizes("measure/" + name, algorithm, measure_limit);
    add_sizes("closest/" + name, algorithm, closest_limit);
    add_sizes("memory/certify/" + name, algorithm, certificate_memory);
  }
}

}  // namespace ar3d::kernels
