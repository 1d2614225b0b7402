"""Lattices from the spec to the table. What is computed is tested elsewhere; here it must arrive."""

import json
import pathlib
import subprocess
import sys
import unittest

import h5py

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import PROGRAM, Sweep  # noqa: E402

LATTICE = "--geometry lattice --rows 2 --columns 3 --v0 0.05 --tc 2e-5 --s0 1e-7 --epsilon 0.9".split()
SPEC = """
[sweep]
geometry   = ["lattice", "column"]
rows       = [2, 3]
columns    = 4
N          = [2, 3]
zip        = [["rows", "N"]]
side_walls = ["periodic", "fixed"]
epsilon    = 0.9
v0         = 0.05
tc         = 2e-5
s0         = 1e-7
tolerance  = 1e-6
where      = "geometry == lattice || side_walls == periodic"
"""


def sigmasweep(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, **options)


class One(unittest.TestCase):
    def test_json(self):
        ended = sigmasweep("one", *LATTICE, "--side-walls", "fixed", "--D-t", "100", "--json")
        self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
        row = json.loads(ended.stdout)
        self.assertEqual([row[name] for name in ("geometry", "rows", "columns", "N", "side_walls", "D_t", "status")],
                         ["lattice", 2, 3, 6, "fixed", 100.0, "ok"])
        self.assertNotIn("predicted_growth", row)
        for name in ("eps_eff", "eps_eff_error", "Er_Ef", "Er_Ef_error", "Er_E0", "v_cm", "t_k", "x_max", "contacts", "end"):
            self.assertIn(name, row)

    def test_refusals(self):
        for more, words in ((["--N", "6"], "N: no tuple uses it"), (["--method", "ed"], "hard spheres"),
                            (["--alpha", "2"], "'vibrated-lattice'"), (["--side-walls", "open"], "periodic")):
            with self.subTest(more):
                ended = sigmasweep("one", *LATTICE, *more)
                self.assertEqual((ended.returncode, ended.stdout), (64, ""), ended)
                self.assertIn(words, ended.stderr)
        ended = sigmasweep("one", *LATTICE[:2], *LATTICE[4:])
        self.assertEqual(ended.returncode, 64, ended)
        self.assertIn("'rows' is missing", ended.stderr)


class Table(unittest.TestCase):
    def test_members_and_rows(self):
        sweep = Sweep(SPEC)
        plan = json.loads(sigmasweep("plan", sweep.spec, "--json").stdout)
        self.assertEqual(plan["tuples"], 6)
        self.assertGreater(plan["core_seconds"], 0)
        ended = sigmasweep("run", sweep.spec, "-o", sweep.table)
        self.assertEqual(ended.returncode, 0, ended)
        with h5py.File(sweep.table) as file:
            results = file["results"]
            for name in ("geometry", "side_walls"):
                self.assertEqual(h5py.check_enum_dtype(results.dtype[name]),
                                 {"geometry": {"column": 0, "vibrated-column": 1, "lattice": 2, "vibrated-lattice": 3},
                                  "side_walls": {"periodic": 0, "fixed": 1}}[name])
            self.assertEqual(results["N"].tolist(), [8, 8, 12, 12, 2, 3])
            self.assertEqual(results["rows"].tolist(), [2, 2, 3, 3, 2, 3])
            self.assertEqual(results["columns"].tolist(), [4] * 6)
            self.assertEqual(results["side_walls"].tolist(), [0, 1, 0, 1, 0, 0])
        shown = json.loads(sigmasweep("show", sweep.table, "--json", "--where", "side_walls == fixed").stdout)
        self.assertEqual([row["N"] for row in shown["results"]], [8, 12])

    def test_studies(self):
        lattice = ("[sweep]\ngeometry = \"lattice\"\nrows = 2\ncolumns = 3\nepsilon = 0.1\nv0 = 1\ntc = 1e-5\nsigma = 0\n"
                   "d = 0.1\n")
        sweep = Sweep(lattice + "integrator = \"gear5\"\nsteps_per_tc = [4, 10, 100]\n")
        ended = sigmasweep("stability", sweep.spec, cwd=sweep.path)
        self.assertEqual(ended.returncode, 0, ended)
        self.assertIn("0 unstable, but predicted to be stable", ended.stdout)
        self.assertIn("predicted to be unstable", sigmasweep("plan", sweep.spec).stderr)
        study = Sweep(lattice + "[precision]\nsteps_per_tc = [100]\ntolerances = [1e-7]\ntuples = 4\nchecks = 2\n")
        ended = sigmasweep("precision", study.spec, cwd=study.path)
        self.assertEqual(ended.returncode, 0, ended)
        self.assertIn("errors of eps_eff; references: 1; 1 checked by the same method at another accuracy", ended.stdout)

    def test_tolerance_chooses_steps(self):
        ended = sigmasweep("one", *LATTICE, "--integrator", "verlet", "--tolerance", "1e-4", "--json")
        row = json.loads(ended.stdout)
        self.assertEqual(row["status"], "ok", ended)
        self.assertLessEqual(row["eps_eff_error"], 1e-4)


if __name__ == "__main__":
    unittest.main(verbosity=2)
