#include "studies/precision/cases/scene_kind.hpp"

#include "sigmasweep/model/geometry.hpp"
#include "studies/precision/cases/column.hpp"
#include "studies/precision/cases/lattice.hpp"
#include "studies/precision/cases/vibrated.hpp"

namespace sigmasweep {

const SceneKind& scene_kind(const Parameters& scene) {
  static constexpr SceneKind column{"eps_eff", true, true, column_case};
  static constexpr SceneKind lattice{"eps_eff", true, true, lattice_case};
  static constexpr SceneKind vibrated_column{"h_cm/A0", false, false, vibrated_column_case};
  static constexpr SceneKind vibrated_lattice{"h_cm/A0", false, false, vibrated_lattice_case};
  if (is_lattice(scene)) return is_vibrated(scene) ? vibrated_lattice : lattice;
  return is_vibrated(scene) ? vibrated_column : column;
}

}  // namespace sigmasweep
