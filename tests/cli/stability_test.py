"""A small stability study, alone and under mpirun: text, table and pictures."""

import math
import os
import pathlib
import re
import shlex
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

import h5py

PROGRAM = os.environ["SIGMASWEEP"]
MPIEXEC = shlex.split(os.environ["MPIEXEC"])
SPEC = """
title = "Small"
[sweep]
integrator = ["gear5", "rk4"]
N = [1, 10]
epsilon = [0.05, 0.9]
steps_per_tc = [2, 10, 50, 200]
sigma = 0.1
v0 = 1.0
tc = 2e-5
[plot]
kind = "stability"
y_scale = "log"
"""


class Stability(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory(prefix="sigma sweep ")
        self.path = pathlib.Path(self.directory.name)
        (self.path / "small.toml").write_text(SPEC)

    def tearDown(self):
        self.directory.cleanup()

    def run_program(self, *arguments, before=()):
        return subprocess.run([*before, PROGRAM, *arguments], capture_output=True, text=True, timeout=100,
                              cwd=self.path)

    def rows(self):
        with h5py.File(self.path / "small.h5") as file:
            return file["results"][()], h5py.check_enum_dtype(file["results"].dtype["status"])

    def test_text_table_and_pictures(self):
        ended = self.run_program("stability", "small.toml")
        self.assertEqual(ended.returncode, 0, ended)  # though rows are unstable
        self.assertEqual(len(re.findall(r"integrator = \w+, N = \d+\n", ended.stdout)), 4)
        rows, status = self.rows()
        unstable = rows["status"] == status["unstable"]
        self.assertTrue(unstable.any() and not unstable.all())
        self.assertTrue(((rows["predicted_growth"] > 1.05) | ~unstable).all(), "unstable, but predicted to be stable")
        self.assertTrue(math.isnan(rows["eps_eff"][unstable][0]))
        xml.etree.ElementTree.parse(self.path / "small.svg")
        self.assertTrue((self.path / "small.png").read_bytes().startswith(b"\x89PNG"))
        self.assertEqual(sorted(p.name for p in self.path.iterdir()),
                         ["small.h5", "small.png", "small.svg", "small.toml"])
        again = self.run_program("stability", "small.toml", "-q", "--no-plots")
        self.assertEqual((again.returncode, again.stdout), (0, ended.stdout))

    # gear5 with one evaluation a step is stable while about 2 zeta omega_max dt < 0.16; for N = 10 the stiffest mode
    # has 2 zeta omega = 3.978 L/tc, L = -ln 0.05.
    def test_the_predicted_limit(self):
        ended = self.run_program("stability", "small.toml", "--no-plots")
        block = ended.stdout.split("integrator = gear5, N = 10\n")[1]
        limit = float(re.search(r"^\s+0\.05\s.*tc/([\d.]+)$", block, re.MULTILINE).group(1))
        self.assertAlmostEqual(3.978 * -math.log(0.05) / limit, 0.16, delta=0.02)

    def test_ranks_make_no_difference(self):
        alone = self.run_program("stability", "small.toml", "-q", "--no-plots")
        rows, _ = self.rows()
        (self.path / "small.h5").unlink()
        shared = self.run_program("stability", "small.toml", "-q", "--no-plots", before=[*MPIEXEC, "-n", "3"])
        self.assertEqual((shared.returncode, shared.stdout), (0, alone.stdout), shared.stderr)
        self.assertEqual(self.rows()[0].tobytes(), rows.tobytes())

    def test_plot_of_a_table(self):
        self.run_program("stability", "small.toml", "-q", "--no-plots")
        for arguments in ((), ("--kind", "stability")):
            self.assertEqual(self.run_program("plot", "small.h5", "-o", "map.svg", *arguments).returncode, 0)
            text = (self.path / "map.svg").read_text()
            self.assertIn("predicted limit", text)
            (self.path / "map.svg").unlink()

    def test_refusals(self):
        (self.path / "exact.toml").write_text("[sweep]\nN = 2\nepsilon = 0.9\nv0 = 1.0\ntc = 1e-5\n"
                                              "sigma = [0.0, 1.0]\n")
        (self.path / "extra.toml").write_text(SPEC + 'series = "N"\n')
        for spec, code, word in (("exact.toml", 65, "gear5"), ("extra.toml", 65, "is not used by"),
                                 ("absent.toml", 66, "absent.toml")):
            ended = self.run_program("stability", spec)
            self.assertEqual(ended.returncode, code, ended)
            self.assertIn(word, ended.stderr)
            self.assertEqual(len(ended.stderr.strip().splitlines()), 1, ended.stderr)


if __name__ == "__main__":
    unittest.main()
