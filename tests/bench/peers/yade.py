"""Yade: ViscElMat with Law2_ScGeom_ViscElPhys_Basic, which leaves out the attractive last part of a contact."""

import json
import re

import column

NAME = "Yade ViscEl"
PROGRAM = "yade"
STEPS = (50, 100, 200)

# Two materials in contact act like springs and dashpots in series, so that each has twice those of the contact.
SCRIPT = """
import json, time
def collision(given):
    O.reset()
    material = O.materials.append(ViscElMat(density={density!r}, kn={kn!r}, ks=0.0, cn={cn!r}, cs=0.0, frictionAngle=0.0))
    O.bodies.append(utils.wall(0.0, axis=2, material=material))
    for z in given["centres"]:
        bead = utils.sphere((0.0, 0.0, z), {radius!r}, material=material)
        bead.state.vel = (0.0, 0.0, -1.0)
        O.bodies.append(bead)
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist={skin!r}),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
                        [Law2_ScGeom_ViscElPhys_Basic()]),
        NewtonIntegrator(damping=0.0, gravity=(0.0, 0.0, 0.0))]
    O.dt = {step!r}
    start = time.process_time()
    O.run(given["steps"], True)
    seconds = time.process_time() - start
    velocities = [b.state.vel[2] for b in O.bodies if isinstance(b.shape, Sphere)]
    print("collision", json.dumps({{"seconds": seconds, "velocities": velocities}}), flush=True)
for given in json.loads({tuples!r}):
    collision(given)
"""


def command(script):
    return [PROGRAM, "-n", "-x", "-j1", script]


def script(tuples, steps_per_tc):
    """A script that computes one tuple after the other."""
    step = 1.0 / steps_per_tc
    given = [{"centres": column.centres(t, step), "steps": column.steps_of(t, steps_per_tc)} for t in tuples]
    return SCRIPT.format(density=column.DENSITY, kn=2.0 * column.SPRING, cn=2.0 * column.DASHPOT,
                         radius=0.5 * column.DIAMETER, skin=0.05 * column.DIAMETER, step=step, tuples=json.dumps(given))


def results(output):
    """(eps_eff, CPU seconds of the loop) of each tuple."""
    found = [json.loads(line) for line in re.findall(r"collision (\{.*\})", output)]
    return [(column.eps_eff(each["velocities"]), each["seconds"]) for each in found]
