#include <cstdio>

#include "ar3d/algorithms/catalog.h"
#include "ar3d/verify/certificate.h"

int main() {
  const ar3d::Graph k5(
      5, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}});
  const ar3d::Algorithm& diamond = ar3d::find_algorithm("diamond");
  const ar3d::Drawing drawing = ar3d::draw(diamond, k5);
  const ar3d::Certificate certificate = ar3d::certify(k5, drawing, diamond.guarantee);
  std::printf("K5: %zu violations\n", certificate.violations.size());
  return certificate.valid() ? 0 : 1;
}
