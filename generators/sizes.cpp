#include "ar3d/generators/sizes.h"

#include <fmt/format.h>

#include <algorithm>

#include "ar3d/base/error.h"
#include "ar3d/generators/named.h"

namespace ar3d {

Count count_of(const Settings& parameters, std::string_view name) {
  const std::int64_t value = value_of(parameters, name);
  expect(value >= 0, "a parameter read as a count is not negative");
  return static_cast<Count>(value);
}

Count root(Count n) {
  Count low = 0;
  Count high = Count{1} << 32;
  while (high - low > 1) {  // low^2 <= n < high^2 where high^2 fits 64 bits
    const Count middle = low + (high - low) / 2;
    (middle <= n / middle ? low : high) = middle;
  }
  return low;
}

Count torus_sizes(Count wanted, const Settings& parameters) {
  const Count rows = count_of(parameters, "rows");
  return nearest_step(wanted, 3 * rows, rows);
}

Count petersen_sizes(Count wanted, const Settings& parameters) {
  return nearest_step(wanted, std::max<Count>(6, 2 * (2 * count_of(parameters, "k") + 1)), 2);
}

Count star_sizes(Count wanted, const Settings& parameters) {
  const Count size = count_of(parameters, "leaves") + 1;
  return nearest_step(wanted, size, size);
}

Count caterpillar_sizes(Count wanted, const Settings& parameters) {
  const Count size = count_of(parameters, "legs") + 1;
  return nearest_step(wanted, size, size);
}

Count regular_sizes(Count wanted, const Settings& parameters) {
  const Count degree = count_of(parameters, "degree");
  return nearest_step(wanted, degree + 1, degree % 2 == 1 ? 2 : 1);
}

Count cubic_tree_sizes(Count wanted, const Settings& parameters) {
  const Count leaf = count_of(parameters, "leaf");
  return nearest_step(wanted, 2 * leaf, leaf + 1);
}

Count circulant_sizes(Count wanted, const Settings& parameters) {
  return std::max(wanted, 2 * count_of(parameters, "b") + 1);
}

Count hypercube_sizes(Count wanted, const Settings&) {
  Count n = 1;
  while (n < 16 && 2 * n <= wanted) n *= 2;
  return n;
}

Count truncation_sizes(Count wanted, const Settings&) {
  Count n = 4;
  while (n <= wanted / 3) n *= 3;
  return n;
}

Count nanotube_sizes(Count wanted, const Settings& parameters) {
  const Count ring = 2 * count_of(parameters, "around");
  return nearest_step(wanted, 2 * ring, ring);
}

Count fullerene_sizes(Count wanted, const Settings& parameters) {
  const Count b = count_of(parameters, "b");
  const auto size = [b](Count a) { return 20 * (a * a + a * b + b * b); };
  Count a = std::max<Count>(1, b);
  while (a < 8000 && size(a + 1) <= wanted) ++a;
  return size(a);
}

Count i_graph_sizes(Count wanted, const Settings& parameters) {
  const Count step = std::max(count_of(parameters, "j"), count_of(parameters, "k"));
  return nearest_step(wanted, 2 * (2 * step + 1), 2);
}

Count odd_graph_sizes(Count wanted, const Settings&) {
  return wanted >= 35 ? 35 : (wanted >= 10 ? 10 : 3);
}

Count named_sizes(Count, const Settings& parameters) {
  return named_graphs()[count_of(parameters, "index")].num_vertices;
}

Count bridges_sizes(Count wanted, const Settings& parameters) {
  return nearest_step(wanted, 6 * count_of(parameters, "bridges") + 4, 2);
}

Count cactus_sizes(Count wanted, const Settings& parameters) {
  const Count length = count_of(parameters, "length");
  return nearest_step(wanted, length, length - 1);
}

}  // namespace ar3d
