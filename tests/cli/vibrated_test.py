"""Vibrated columns from the spec to the pictures. What is computed is tested elsewhere; here it must arrive."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import h5py
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import PROGRAM, Sweep  # noqa: E402

PLATE = "--geometry vibrated-column --N 3 --epsilon 0.9 --alpha 4 --periods 12 --transient 4".split()
SPEC = """
title = "On a plate"
[sweep]
geometry  = "vibrated-column"
method    = ["md", "ed"]
N         = 3
epsilon   = 0.9
d         = 2e-3
tc        = 1e-4
frequency = 25
alpha     = [2, 4]
periods   = 40
transient = 8
[trajectory]
samples = 201
[[plot]]
series = ["method"]
guides = [{ y = "1e-4*x^2", label = "square" }]
[[plot]]
name = "phase"
kind = "trajectories"
x    = "phase"
"""
RESULTS = {"h_cm", "h_cm_error", "h_cm_excess", "separation", "separation_max", "E_r", "cm_period", "power_in",
           "power_lost", "imbalance", "contacts", "end", "status"}


def sigmasweep(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, **options)


# A plastic ball rests on the plate up to the phase asin(1/alpha), flies once a period, and stays where it lands.
PLASTIC_BALL = """
[sweep]
geometry  = "vibrated-column"
method    = "ed"
N         = 1
epsilon   = 1e-6
wall      = "matched"
alpha     = 2.0
frequency = 25
periods   = 60
transient = 20
[trajectory]
samples  = 660001
duration = 0.88
"""


class One(unittest.TestCase):
    def test_json(self):
        for method in (["--tc", "1e-4"], ["--method", "ed"]):
            with self.subTest(method):
                ended = sigmasweep("one", *PLATE, *method, "--json")
                self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
                row = json.loads(ended.stdout)
                self.assertLessEqual(RESULTS, row.keys())
                self.assertFalse({"eps_eff", "t_k", "v0", "sigma"} & row.keys(), row)
                self.assertEqual((row["status"], row["end"]), ("ok", "periods"))
                self.assertAlmostEqual(row["A0"], 4 * 9.81 / (40 * math.pi) ** 2, delta=1e-15)
                at_rest = 3 * 1e-3 / 2  # three beads of d = 1 mm
                self.assertAlmostEqual(row["h_cm"] - row["h_cm_excess"], at_rest, delta=1e-12)

    def test_for_people(self):
        ended = sigmasweep("one", *PLATE, "--tc", 1e-4)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
        for words in ("vibrated-column", "h_cm ", " +- ", "imbalance", "periods"):
            self.assertIn(words, ended.stdout)
        self.assertNotIn("eps_eff", ended.stdout)

    def test_wrong(self):
        for words, *arguments in (("alpha or A0, not both", *PLATE, "--tc", 1e-4, "--A0", 1e-3),
                                  ("sigma: no tuple uses it", *PLATE, "--tc", 1e-4, "--sigma", 1),
                                  ("'tc' is missing", *PLATE),
                                  ("frequency = 0 is not allowed", *PLATE, "--tc", 1e-4, "--frequency", 0)):
            ended = sigmasweep("one", *arguments)
            self.assertEqual((ended.returncode, ended.stdout), (64, ""), ended)
            self.assertIn(words, ended.stderr)


class Run(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sweep = Sweep(SPEC)
        cls.ended = cls.sweep.run(0)
        with h5py.File(cls.sweep.table) as file:
            cls.table = file["results"][()]

    def tool(self, *arguments):
        ended = sigmasweep(*arguments, cwd=self.sweep.path)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
        return ended.stdout

    def test_table(self):
        self.assertEqual(self.ended.code, 0, self.ended)
        self.assertLessEqual(RESULTS | {"alpha", "A0", "frequency", "periods", "tc", "x_max"},
                             set(self.table.dtype.names))
        self.assertFalse({"eps_eff", "v0", "sigma"} & set(self.table.dtype.names))
        self.assertEqual(self.table["alpha"].tolist(), [2, 4, 2, 4])
        self.assertTrue(numpy.isfinite(self.table["h_cm"]).all())

    def test_same_bits_for_any_number_of_ranks(self):
        other = Sweep(SPEC)
        self.assertEqual(other.run(2).code, 0)
        with h5py.File(other.table) as file:
            self.assertEqual(file["results"][()].tobytes(), self.table.tobytes())

    def test_show_and_export(self):
        shown = json.loads(self.tool("show", "table.h5", "--json"))["results"]
        self.assertEqual([row["h_cm"] for row in shown], self.table["h_cm"].tolist())
        self.assertIn("h_cm_excess", self.tool("export", "table.h5").splitlines()[0])

    def test_the_film_begins_at_rest_on_the_plate(self):
        """Ten periods, and the plate as an observable."""
        A0 = 4 * 9.81 / (50 * math.pi) ** 2
        for row in (1, 3):
            with h5py.File(self.sweep.path / "table.trajectories" / f"row-{row:06}.h5") as file:
                plate = file["observables/plate_height"]
                time = plate["time"][()]
                self.assertEqual(plate.attrs["unit"], b"m")
                numpy.testing.assert_allclose(time, numpy.linspace(0, 0.4, 201), rtol=1e-14, atol=0)
                expected = A0 * numpy.sin(50 * math.pi * time)
                numpy.testing.assert_allclose(plate["value"][()], expected, rtol=0, atol=1e-13 * A0)
                z = file["particles/beads/reduced_height/value"][()][:, :, 0]
                self.assertLess(abs(z[0]).max(), 1e-4)  # overlaps from the weight: g tc^2 and the like
                self.assertTrue((z[:, 0] - plate["value"][()] > -1e-3).all())
                h = file["particles/beads/position/value"][()][:, :, 2]
                numpy.testing.assert_allclose(h - z, numpy.tile([1e-3, 3e-3, 5e-3], (201, 1)), rtol=1e-12)

    def test_mean_height_of_a_plastic_ball(self):
        """It is the closed form, and the mean over the trajectory file; the error bar holds."""
        A0, start = 2 * 9.81 / (50 * math.pi) ** 2, math.asin(0.5)

        def above(phase):  # of the flight, over the plate, in units of g/omega^2
            return 1 + 2 * math.cos(start) * phase - phase**2 / 2 - 2 * math.sin(start + phase)

        low, high = 1.0, 2 * math.pi
        for _ in range(100):
            middle = (low + high) / 2
            low, high = (middle, high) if above(middle) > 0 else (low, middle)
        slope = 2 * math.cos(start)
        integral = low + slope * low**2 / 2 - low**3 / 6 + 2 * math.cos(start + low) - slope
        height = 0.5e-3 + integral / (2 * math.pi) * A0 / 2
        self.assertAlmostEqual(height, 0.865513646098e-3, delta=1e-15)
        sweep = Sweep(PLASTIC_BALL)
        self.assertEqual(sweep.run(0).code, 0)
        with h5py.File(sweep.table) as table:
            row = table["results"][0]
        self.assertLess(row["h_cm_error"], 1e-11 * A0)
        self.assertAlmostEqual(row["h_cm"], height, delta=row["h_cm_error"])
        with h5py.File(sweep.table.with_suffix(".trajectories") / "row-000000.h5") as film:
            reduced = film["particles/beads/reduced_height/value"][:].ravel()
        period = 30_000  # samples
        mean = 0.5e-3 + reduced[-period:].mean()
        self.assertAlmostEqual(row["h_cm"], mean, delta=1e-8 * A0)  # kinks: (2 pi/30000)^2/8 of a change of slope

    def test_pictures(self):
        with tempfile.TemporaryDirectory() as directory:
            name = pathlib.Path(directory) / "a.svg"
            self.tool("plot", "table.h5", "-o", name)
            self.assertIn("square", name.read_text())
            self.assertIn("phase", (name.parent / "a-phase.svg").read_text())

    def test_studies(self):
        plate = ("[sweep]\ngeometry = ['vibrated-column', 'vibrated-lattice']\nN = 3\nrows = 2\ncolumns = 2\n"
                 "epsilon = 0.6\ntc = 1e-3\nalpha = 2\nfrequency = 20\nperiods = 1\ntransient = 0\n")
        self.sweep.spec.with_name("p.toml").write_text(
            plate + "[precision]\nsteps_per_tc = [20, 200]\ntuples = 5\nchecks = 2\nrepeats = 1\n")
        ended = sigmasweep("precision", "p.toml", cwd=self.sweep.path)
        self.assertEqual(ended.returncode, 0, ended)
        self.assertEqual(ended.stdout.count("errors of h_cm/A0; references: 5; 2 checked by"), 2, ended.stdout)
        with h5py.File(self.sweep.spec.with_name("p.h5")) as file:
            rows = file["precision"][()]
            exact = rows["integrator"] == h5py.check_enum_dtype(rows.dtype["integrator"])["exact"]
        self.assertEqual(exact.sum(), 2)
        self.assertTrue(numpy.isnan(rows["setting"][exact]).all() and numpy.isnan(rows["velocity_max"]).all())
        self.assertEqual(rows["failures"].sum(), 0)
        self.assertLess(rows["error_max"][exact].max(), 1e-6)
        for steps, most in ((20, 0.1), (200, 0.01)):
            errors = rows["error_max"][rows["setting"] == steps]
            self.assertTrue(((errors > 1e-7) & (errors < most)).all(), errors)
        self.sweep.spec.with_name("s.toml").write_text(
            plate + "integrator = 'gear5'\nsteps_per_tc = [3, 5, 100]\n")
        ended = sigmasweep("stability", "s.toml", cwd=self.sweep.path)
        self.assertEqual(ended.returncode, 0, ended)
        self.assertIn("0 unstable, but predicted to be stable", ended.stdout)
        with h5py.File(self.sweep.spec.with_name("s.h5")) as file:
            self.assertTrue((file["results"]["predicted_growth"] > 0).all())


if __name__ == "__main__":
    unittest.main(verbosity=2)
