#include "assembly/diameters.hpp"

#include <cmath>

#include "assembly/column.hpp"

namespace sigmasweep {

std::vector<double> diameters(const Parameters& p) {
  std::vector<double> all = reduced_column<double>(p).mass;  // over the mean bead's, as the cubes of the diameters
  for (double& each : all) each = p.d * std::cbrt(each);
  return all;
}

}  // namespace sigmasweep
