#include "plot/films/panel.hpp"

#include <fmt/format.h>

#include "sigmasweep/base/errors.hpp"
#include "sigmasweep/model/fields.hpp"
#include "sigmasweep/model/relevance.hpp"

namespace sigmasweep {

bool has_plate(const Panel& panel) {
  static const Field& frequency = *find_field("frequency");
  return applies_to(frequency, panel.row.parameters);
}

void require_room_for(std::size_t panels) {
  if (panels == 0) throw UsageError("plot: there are no trajectories to draw");
  if (panels <= max_panels) return;
  throw UsageError(fmt::format(
      "plot: {} trajectories, but a picture has room for {}: choose rows with 'where' in [plot]", panels, max_panels));
}

}  // namespace sigmasweep
