#include "peer_generators.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <igraph/igraph.h>
#include <omp.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <limits>
#include <stdexcept>
#include <string>

#include "ar3d/generators/random_graphs.h"

namespace ar3d::kernels {
namespace {

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

}  // namespace

Cost cost_of(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child || status != 0) {
    throw std::runtime_error("a generator failed or is missing (Debian package nauty)");
  }
  return {seconds(usage.ru_utime) + seconds(usage.ru_stime),
          1024.0 * static_cast<double>(usage.ru_maxrss)};
}

void generate_ours(std::uint64_t n, std::uint32_t d, std::uint32_t seed) {
  omp_set_num_threads(1);
  if (random_regular(n, d, seed).num_vertices() != n) _exit(1);
}

void generate_genrang(std::uint64_t n, std::uint32_t d, std::uint32_t seed) {
  const std::string degree = fmt::format("-r{}", d);
  const std::string seed_option = fmt::format("-S{}", seed);
  const std::string size = std::to_string(n);
  dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
  execlp("nauty-genrang", "nauty-genrang", "-q", degree.c_str(), seed_option.c_str(), size.c_str(),
         "1", nullptr);
  _exit(1);
}

void generate_igraph(std::uint64_t n, std::uint32_t d, std::uint32_t seed) {
  igraph_t graph;
  igraph_rng_seed(igraph_rng_default(), seed);
  const auto error = igraph_k_regular_game(&graph, static_cast<igraph_integer_t>(n),
                                           static_cast<igraph_integer_t>(d), false, false);
  if (error != IGRAPH_SUCCESS) _exit(1);
}

void generate_igraph_uniform(std::uint64_t n, std::uint32_t d, std::uint32_t seed) {
  igraph_t graph;
  igraph_vector_int_t degrees;
  igraph_rng_seed(igraph_rng_default(), seed);
  igraph_vector_int_init(&degrees, static_cast<igraph_integer_t>(n));
  igraph_vector_int_fill(&degrees, static_cast<igraph_integer_t>(d));
  const auto error =
      igraph_degree_sequence_game(&graph, &degrees, nullptr, IGRAPH_DEGSEQ_CONFIGURATION_SIMPLE);
  if (error != IGRAPH_SUCCESS) _exit(1);
}

}  // namespace ar3d::kernels
