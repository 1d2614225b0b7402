#pragma once

#include <cstddef>
#include <string>

#include "sigmasweep/model/row.hpp"
#include "sigmasweep/trajectory/trajectory.hpp"

/// Trajectories as H5MD 1.1 files, https://www.nongnu.org/h5md/releases/h5md-1.1.0.html, one simulation per file:
///
///     /h5md                       version [1, 1]; author, creator, modules/units (SI)
///     /particles/beads            box (dimension 3), mass (over the mean bead's), diameter (m)
///         position                (x, 0, h), m: h is the height of the centre above the bottom; x is 0 for a column
///         velocity                the same directions, m/s
///         reduced_height          z_i, Eq. (9), m; of a column only. It has the digits that d takes in position
///     /observables/kinetic_energy over that at the start
///     /parameters                 everything that defines the collision, as attributes
/// The box of a column has the boundary none in all directions, that of a lattice may be periodic in x. A lattice's box
/// has edges, an element that does not change: the container's width, the largest diameter, the largest height that a
/// bead reaches. Horizontal positions are those of any image, as H5MD allows.
/// All time-dependent elements share one step (the sample's number) and one time (s from the start). Their units are
/// attributes of the elements, `unit` and `time_unit`.
namespace sigmasweep {

/// Writes the trajectory of `tuple`. Made in memory, written to PATH.part, synced, renamed: PATH is complete or as it
/// was before. The bytes depend on the arguments, the program and the user only. Throws OutputError (cannot be created)
/// or IoError (disk full, a failed write), naming the file.
void write_h5md(const std::string& path, const Tuple& tuple, const Trajectory& trajectory);

/// Reads a file of write_h5md(). Throws InputNotFound, or IoError for a file that is anything else.
Trajectory read_h5md(const std::string& path);

/// Whether `path` holds the trajectory of these parameters, to the bit and in this program's physics, in so many
/// samples over that duration (NaN: over any). False for any other file. Throws std::bad_alloc only.
bool is_h5md_of(const std::string& path, const Parameters& parameters, std::size_t samples, double duration);

}  // namespace sigmasweep
