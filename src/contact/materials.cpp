#include "sigmasweep/contact/materials.hpp"

#include <array>
#include <cstddef>

namespace sigmasweep {

const Bead& bead(Material material) {
  // Sec. III B; epsilon as the paper uses it for these materials.
  static constexpr std::array<Bead, 3> beads{
      {{}, {1.5e-3, 1.38e-5, 2.06e11, 0.28, 0.9}, {1.5e-3, 0.479e-5, 0.71e11, 0.34, 0.6}}};
  return beads[static_cast<std::size_t>(material)];
}

double elastic_constant(const Bead& bead) { return bead.young / (3.0 * (1.0 - bead.poisson * bead.poisson)); }

}  // namespace sigmasweep
