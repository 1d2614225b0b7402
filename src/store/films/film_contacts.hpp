#pragma once

#include <cstddef>
#include <vector>

#include "assembly/column.hpp"
#include "sigmasweep/model/parameters.hpp"
#include "sigmasweep/model/trajectory.hpp"
#include "store/films/film.hpp"

namespace sigmasweep {

/// The closed contacts of soft spheres at a sample, from their positions and velocities. `contact_laws` are the
/// si_column() of the parameters. Columns count them from the bottom, lattices by bead.
std::vector<FilmContact> column_contacts(const Parameters& parameters, const Column<double>& contact_laws,
                                         const Trajectory& motion, std::size_t sample);
std::vector<FilmContact> lattice_contacts(const Parameters& parameters, const Column<double>& contact_laws,
                                          const Trajectory& motion, std::size_t sample);

}  // namespace sigmasweep
