"""'sigmasweep advise': its text, its JSON, and the lines for other codes, run by these codes where they are installed:
LAMMPS, LIGGGHTS and Yade find the same effective restitution."""

import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import PROGRAM  # noqa: E402

D, DENSITY, V0, TC, GAP, STEPS = 1e-3, 2500.0, 0.5, 2e-5, 2e-6, 100
BOX = "region box block" + 3 * " -0.02 0.02"


def ask(*arguments):
    return subprocess.run([PROGRAM, "advise", *map(str, arguments)], capture_output=True, text=True, timeout=60)


def advice(beads):
    ended = ask("--json", "--d", D, "--density", DENSITY, "--v0", V0, "--tc", TC, "--s0", GAP, "--N", beads, "--epsilon", 0.9,
                "--steps-per-tc", STEPS)
    assert ended.returncode == 0, ended
    return json.loads(ended.stdout)


def centres(beads):
    """Heights of the centres at the start, m."""
    return [D / 2 + GAP * (i + 1) + D * i for i in range(beads)]


def steps(beads):
    """Enough for all collisions that matter: forty contact times and the flights between."""
    return math.ceil((40 * TC * beads ** 0.5 + 20 * GAP / V0) / TC * STEPS)


def run(script, *command):
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory) / "in.py"
        path.write_text(script)
        ended = subprocess.run([*command, path], cwd=directory, capture_output=True, text=True, timeout=100)
    match = re.search(r"^velocities (.*)$", ended.stdout, re.M)
    assert match, ended.stdout[-2000:] + ended.stderr[-2000:]
    return [float(v) for v in match[1].split()]


def eps_eff(velocities):
    return math.sqrt(sum(v * v for v in velocities) / len(velocities)) / V0


def of_lammps(lines, beads):
    around = (f"atom_modify map array\nboundary f f f\nnewton off\n{BOX}\ncreate_box 1 box\n" + atoms(beads, "") +
              f"neighbor {0.3 * D} bin\n")
    return eps_eff(run(lines.replace("pair_style", around + "pair_style") + ending(beads, ""),
                       "lmp", "-log", "none", "-in"))


def of_liggghts(lines, beads):
    around = (f"atom_modify map array\nboundary f f f\nnewton off\n{BOX} units box\ncreate_box 2 box\n"
              f"neighbor {0.3 * D} bin\n")
    body = lines.replace("fix kn", around + "fix kn").replace("fix move", atoms(beads, " units box") + "fix move")
    return eps_eff(run(body + ending(beads, " units box"), "liggghts", "-log", "none", "-in"))


def ending(beads, units):
    variables = "".join(f"variable v{i} equal vz[{i}]\n" for i in range(1, beads + 1))
    values = " ".join(f"${{v{i}}}" for i in range(1, beads + 1))
    return (f"velocity all set 0 0 {-V0}{units}\nthermo 100000\nrun {steps(beads)}\n{variables}"
            f'print "velocities {values}"\n')


def atoms(beads, units):
    return ("".join(f"create_atoms 1 single 0 0 {z:.17g}{units}\n" for z in centres(beads)) +
            f"set group all diameter {D} density {DENSITY}\n")


def of_yade(lines, beads):
    script = (lines + f"""
O.materials.append(bead); O.materials.append(wall)
O.bodies.append(utils.wall(0.0, axis=2, material=wall))
for z in {centres(beads)!r}:
    O.bodies.append(utils.sphere((0.0, 0.0, z), {D / 2!r}, material=bead))
    O.bodies[-1].state.vel = (0.0, 0.0, -{V0!r})
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist={0.05 * D!r}),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
                    [Law2_ScGeom_ViscElPhys_Basic()]),
    NewtonIntegrator(damping=0.0, gravity=(0.0, 0.0, 0.0))]
O.run({steps(beads)}, True)
print("velocities", *(b.state.vel[2] for b in O.bodies if isinstance(b.shape, Sphere)), flush=True)
""")
    return eps_eff(run(script, "yade", "-n", "-x", "-j1"))


class OtherCodes(unittest.TestCase):
    def agree(self, code, compute, tolerance):
        for beads in (2, 10):
            given = advice(beads)
            with self.subTest(beads):
                self.assertAlmostEqual(compute(given["lines"][code], beads), given["eps_eff"], delta=tolerance)

    @unittest.skipUnless(shutil.which("lmp"), "LAMMPS is not installed")
    def test_lammps(self):
        self.agree("LAMMPS", of_lammps, 2e-3)

    @unittest.skipUnless(shutil.which("liggghts"), "LIGGGHTS is not installed")
    def test_liggghts(self):
        self.agree("LIGGGHTS", of_liggghts, 2e-3)

    @unittest.skipUnless(shutil.which("yade"), "Yade is not installed")
    def test_yade(self):
        self.agree("Yade", of_yade, 2e-3)


class Command(unittest.TestCase):
    def test_text(self):
        ended = ask("--d", D, "--v0", 1, "--tc", 2e-5, "--s0", 1e-6, "--N", 10, "--epsilon", ".9")
        self.assertEqual(ended.returncode, 0, ended)
        for words in ("too soft", "from sigma = 1.3392", "tc/100", "pair_style gran/hooke", "ViscElMat", "MercuryDPM"):
            self.assertIn(words, ended.stdout)

    def test_a_spring_instead_of_tc(self):
        given = advice(5)
        ended = ask("--json", "--d", D, "--density", DENSITY, "--v0", V0, "--stiffness", given["stiffness"], "--s0", GAP,
                    "--N", 5, "--epsilon", 0.9)
        self.assertAlmostEqual(json.loads(ended.stdout)["eps_eff"], given["eps_eff"], places=10)

    def test_mistakes(self):
        for arguments, words in ((["--tc", 1], "missing"), (["--mass", "x"], "missing"), (["--N", "a"], "not a number"),
                                 (["--stiffness", 1, "--tc", 1], "not both")):
            ended = ask(*arguments)
            self.assertEqual((ended.returncode, ended.stdout), (64, ""), ended)
            self.assertIn(words, ended.stderr)


if __name__ == "__main__":
    unittest.main()
