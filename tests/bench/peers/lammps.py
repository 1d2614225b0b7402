"""LAMMPS: pair_style gran/hooke, which keeps the attractive last part of a contact, as the paper does."""

import re

import column

NAME = "LAMMPS gran/hooke"
PROGRAM = "lmp"
STEPS = (50, 100, 200, 500)

# The dashpot of a contact is gamma_n times its reduced mass: 1/2 for a pair, 1 at the wall.
COLLISION = """
clear
units lj
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
region box block -1000 1000 -1000 1000 -1000 {height:.17g}
create_box 1 box
{atoms}
set group all diameter {diameter} density {density:.17g}
neighbor {skin} bin
pair_style gran/hooke {K:.17g} 0 {gamma_pair:.17g} 0 0 0
pair_coeff * *
fix wall all wall/gran hooke {K:.17g} 0 {gamma_wall:.17g} 0 0 0 zplane 0 NULL
fix move all nve/sphere
velocity all set 0 0 -1
timestep {step:.17g}
thermo {steps}
run {steps}
print "velocities {velocities}"
"""


def command(script):
    return [PROGRAM, "-in", script, "-log", "none"]


def script(tuples, steps_per_tc):
    """An input that computes one tuple after the other."""
    step = 1.0 / steps_per_tc
    return "".join(COLLISION.format(
        height=column.height(t), diameter=column.DIAMETER, density=column.DENSITY, skin=0.3 * column.DIAMETER,
        atoms="\n".join(f"create_atoms 1 single 0 0 {z:.17g}" for z in column.centres(t, step)),
        K=column.SPRING, gamma_pair=2.0 * column.DASHPOT, gamma_wall=column.DASHPOT, step=step,
        steps=column.steps_of(t, steps_per_tc),
        velocities=" ".join(f"$(vz[{i + 1}]:%.17g)" for i in range(column.BEADS))) for t in tuples)


def results(output):
    """(eps_eff, seconds of the loop) of each tuple."""
    loops = [float(seconds) for seconds in re.findall(r"^Loop time of (\S+)", output, re.M)]
    lines = re.findall(r"^velocities (.*)", output, re.M)
    return list(zip((column.eps_eff([float(v) for v in line.split()]) for line in lines), loops, strict=True))
