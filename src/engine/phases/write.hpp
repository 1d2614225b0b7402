#pragma once

#include "engine/phases/open.hpp"

namespace sigmasweep {

/// Fifth phase: writes the table from the journals, all ranks together. Throws as write_table().
void write_rows(const World& world, const OpenSweep& open);

}  // namespace sigmasweep
