// Certificates are the same on any number of threads: verdicts, counts, boxes, metrics and hashes.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/base/parallel.h"
#include "ar3d/bench/measure/cores.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/counting/counting_proof.h"
#include "ar3d/verify/examination.h"
#include "verify/counted_pairs.h"
#include "verify/draft.h"

namespace ar3d::testing {
namespace {

using verify::CountingProof;
using verify::CountingSizes;

Drawing drawing_of(const Algorithm& algorithm, const Graph& graph) {
  omp_set_num_threads(1);
  return draw(algorithm, graph);
}

Graph graph_for(const Algorithm& algorithm, std::uint64_t n) {
  const char* family = algorithm.guarantee.max_degree == 4 ? "random-4-regular" : "random-cubic";
  return generate(find_family(family), n, 7);
}

CountingOutcome count(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                      const CountingSizes& sizes) {
  CountingProof proof(graph, drawing, guarantee, sizes);
  constexpr EdgeId kEdges = 100;
  const EdgeId edges = drawing.num_edges();
  for_each_in_threads(sizes.threads, edges / kEdges + 1, [&](std::uint32_t thread, std::size_t i) {
    const auto begin = static_cast<EdgeId>(i * kEdges);
    for_each_polyline(drawing, begin, std::min(edges, begin + kEdges),
                      [&](EdgeId e, const std::vector<Point>& points) {
                        proof.add(drawing.edge(e), points, thread);
                      });
  });
  const bool proved = proof.holds(measure(drawing));
  return {proved, proof.counts()};
}

void expect_same_counts(const Graph& graph, const Drawing& drawing, const Guarantee& guarantee,
                        bool proved) {
  const CountingOutcome alone = count(graph, drawing, guarantee, {});
  EXPECT_EQ(alone.proved, proved);
  const std::uint64_t little = 20 * graph.num_vertices();
  for (const std::uint32_t threads : {1u, 2u, 3u, 4u}) {
    EXPECT_TRUE(count(graph, drawing, guarantee, {.threads = threads}) == alone) << threads;
    EXPECT_TRUE(count(graph, drawing, guarantee, {.memory = little, .threads = threads}) == alone)
        << threads << " with little memory";
  }
}

/// The drawing with one vertex moved.
Drawing damaged(const Drawing& drawing) {
  Draft draft = draft_of(drawing);
  draft.vertices[draft.vertices.size() / 2].x += 2;
  return draft.drawing();
}

TEST(CertifyThreads, CountTheSame) {
  for (const char* name : {"diamond", "grid", "compact", "compact-120"}) {
    SCOPED_TRACE(name);
    const Algorithm& algorithm = find_algorithm(name);
    const Graph graph = graph_for(algorithm, 3000);
    const Drawing drawing = drawing_of(algorithm, graph);
    expect_same_counts(graph, drawing, algorithm.guarantee, true);
    const Drawing wrong = damaged(drawing);  // what is counted until that is seen may differ
    for (const std::uint32_t threads : {1u, 2u, 3u}) {
      EXPECT_FALSE(count(graph, wrong, algorithm.guarantee, {.threads = threads}).proved);
    }
  }
}

/// Two copies of a drawing, the second one moved until they cross: right angles, wrong counts.
TEST(CertifyThreads, CountTheSameCrossings) {
  const Algorithm& algorithm = find_algorithm("diamond");
  const Graph half = graph_for(algorithm, 1000);
  const Drawing drawing = drawing_of(algorithm, half);
  Draft draft = draft_of(drawing);
  const auto first = static_cast<Vertex>(drawing.num_vertices());
  Draft second = draft_of(drawing, {2, 2, 0});
  draft.vertices.insert(draft.vertices.end(), second.vertices.begin(), second.vertices.end());
  for (auto& [ends, bends] : second.edges) {
    draft.edges.push_back({{first + ends.u, first + ends.v}, std::move(bends)});
  }
  const Graph graph = draft.graph();
  const Drawing both = draft.drawing();
  const CountingOutcome alone = count(graph, both, algorithm.guarantee, {});
  EXPECT_GT(alone.counts.found.crossing, alone.counts.crossing_neighbours);
  expect_same_counts(graph, both, algorithm.guarantee, false);
}

/// Large enough that examine() shares its pass among threads.
TEST(CertifyThreads, ExaminationsAreTheSame) {
  const OneThread restore_afterwards;
  const Algorithm& algorithm = find_algorithm("diamond");
  const Graph graph = graph_for(algorithm, 66000);
  const Drawing drawing = drawing_of(algorithm, graph);
  const Drawing wrong = damaged(drawing);
  for (const Drawing* d : {&drawing, &wrong}) {
    omp_set_num_threads(1);
    const Examination alone = examine(graph, *d, algorithm.guarantee);
    EXPECT_EQ(alone.certificate.valid(), d == &drawing);
    for (const int threads : {2, 3}) {
      if (d == &wrong && threads == 3) continue;  // naming what is wrong takes long
      omp_set_num_threads(threads);
      for (const bool all : {true, false}) {
        const ExaminationParts parts{.certificate = true, .metrics = all, .hash = all};
        const Examination shared = examine(graph, *d, algorithm.guarantee, parts);
        EXPECT_EQ(shared.certificate.valid(), alone.certificate.valid());
        EXPECT_EQ(shared.certificate.violations.size(), alone.certificate.violations.size());
        EXPECT_EQ(shared.certificate.box, alone.certificate.box);
        EXPECT_EQ(shared.certificate.bend_histogram, alone.certificate.bend_histogram);
        EXPECT_EQ(shared.certificate.segments, alone.certificate.segments);
        EXPECT_EQ(shared.drawing_hash, all ? alone.drawing_hash : "");
        if (!all) continue;
        EXPECT_EQ(shared.summary.total_edge_length, alone.summary.total_edge_length);
        EXPECT_EQ(shared.summary.smallest_vertex_distance, alone.summary.smallest_vertex_distance);
      }
    }
  }
}

/// Vertices are shared among threads, too: one without edges makes the box larger, or lies on a
/// bend of the last edge.
TEST(CertifyThreads, VerticesWithoutEdgesAreSeen) {
  const OneThread restore_afterwards;
  const Algorithm& algorithm = find_algorithm("diamond");
  const Drawing drawing = drawing_of(algorithm, graph_for(algorithm, 66000));
  const Draft right = draft_of(drawing);
  const std::int64_t far = measure(drawing).box.high.x + 1;
  for (const bool is_far : {true, false}) {
    Draft draft = right;
    draft.vertices.push_back(is_far ? Point{far, 0, 0} : draft.edges.back().bends.front());
    const Graph graph = draft.graph();
    const Drawing drawn = draft.drawing();
    for (const int threads : {1, 2, 3}) {
      if (!is_far && threads == 3) continue;  // naming what is wrong takes long
      omp_set_num_threads(threads);
      const ExaminationParts parts{.certificate = true, .metrics = false, .hash = false};
      const Examination found = examine(graph, drawn, algorithm.guarantee, parts);
      EXPECT_EQ(found.certificate.valid(), is_far) << threads;
      if (is_far) {
        EXPECT_EQ(found.certificate.box.high.x, far) << threads;
      }
    }
  }
}

TEST(Parallel, WhatAThreadThrowsArrives) {
  for (const std::uint32_t thrower : {0u, 2u}) {
    const auto work = [&](std::uint32_t i) {
      EXPECT_EQ(available_threads(), 1u);
      if (i == thrower) throw std::bad_alloc();
    };
    EXPECT_THROW(in_threads(3, work), std::bad_alloc);
  }
  for (const std::uint32_t threads : {1u, 3u}) {
    std::vector<int> taken(50);
    const auto work = [&](std::uint32_t, std::size_t i) {
      taken[i] = 1;
      if (i == 20) throw std::bad_alloc();
    };
    EXPECT_THROW(for_each_in_threads(threads, 50, work), std::bad_alloc);
    EXPECT_EQ(taken[20], 1);
  }
}

}  // namespace
}  // namespace ar3d::testing
