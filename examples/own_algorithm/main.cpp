#include "ar3d/algorithms/catalog.h"
#include "ar3d/apps/program.h"
#include "ar3d/generators/catalog.h"
#include "ar3d/verify/metrics/metrics.h"
#include "spokes.h"

int main(int argc, char** argv) {
  ar3d::register_algorithm(spokes::algorithm());
  ar3d::register_family(spokes::family());
  ar3d::register_metric(spokes::metric());
  return ar3d::run_program(argc, argv);
}
