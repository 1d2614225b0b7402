"""LIGGGHTS: hooke/stiffness, LAMMPS' granular fork."""

import column
import lammps

NAME = "LIGGGHTS hooke/stiffness"
PROGRAM = "liggghts"
STEPS = lammps.STEPS

# Atoms of type 1, the wall of type 2. The dashpot of a contact is gamman times its reduced mass.
COLLISION = """
clear
units lj
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region box block -1000 1000 -1000 1000 -1000 {height:.17g} units box
create_box 2 box
neighbor {skin} bin
neigh_modify delay 0
fix kn all property/global kn peratomtypepair 2 {K:.17g} {K:.17g} {K:.17g} {K:.17g}
fix kt all property/global kt peratomtypepair 2 0 0 0 0
fix gamman all property/global gamman peratomtypepair 2 {gamma_pair:.17g} {gamma_wall:.17g} {gamma_wall:.17g} 0
fix gammat all property/global gammat peratomtypepair 2 0 0 0 0
fix friction all property/global coefficientFriction peratomtypepair 2 0 0 0 0
pair_style gran model hooke/stiffness tangential off
pair_coeff * *
fix wall all wall/gran model hooke/stiffness tangential off primitive type 2 zplane 0
{atoms}
set group all diameter {diameter} density {density:.17g}
fix move all nve/sphere
velocity all set 0 0 -1 units box
timestep {step:.17g}
thermo {steps}
run {steps}
{variables}
print "velocities {velocities}"
"""


def command(script):
    return [PROGRAM, "-in", script, "-log", "none"]


def script(tuples, steps_per_tc):
    """An input that computes one tuple after the other."""
    step = 1.0 / steps_per_tc
    beads = range(1, column.BEADS + 1)
    return "".join(COLLISION.format(
        height=column.height(t), diameter=column.DIAMETER, density=column.DENSITY, skin=0.3 * column.DIAMETER,
        atoms="\n".join(f"create_atoms 1 single 0 0 {z:.17g} units box" for z in column.centres(t, step)),
        K=column.SPRING, gamma_pair=2.0 * column.DASHPOT, gamma_wall=column.DASHPOT, step=step,
        steps=column.steps_of(t, steps_per_tc), variables="\n".join(f"variable v{i} equal vz[{i}]" for i in beads),
        velocities=" ".join(f"${{v{i}}}" for i in beads)) for t in tuples)


results = lammps.results
