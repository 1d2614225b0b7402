"""A tiny precision study, alone and under mpirun; h5py reads what it leaves. And error against time of a table."""

import math
import os
import pathlib
import shlex
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

import h5py

PROGRAM = os.environ["SIGMASWEEP"]
MPIEXEC = shlex.split(os.environ["MPIEXEC"])
SPEC = """
title = "Tiny"
[sweep]
N = [1, 3]
epsilon = 0.9
v0 = 2.0
tc = 1e-5
sigma = [0.0, 0.5]
[precision]
steps_per_tc = [1, 50, 200]
tolerances = [1e-3, 1e-10]
tuples = 20
checks = 3
repeats = 2
[plot]
where = "sigma > 0"
"""
SETTINGS = 2 + 4 * 3  # two tolerances of exact, three steps of each scheme


class Precision(unittest.TestCase):
    def setUp(self):
        self.directory = tempfile.TemporaryDirectory(prefix="sigma sweep ")
        self.path = pathlib.Path(self.directory.name)
        (self.path / "tiny.toml").write_text(SPEC)

    def tearDown(self):
        self.directory.cleanup()

    def run_program(self, *arguments, before=()):
        return subprocess.run([*before, PROGRAM, *arguments], capture_output=True, text=True, timeout=100,
                              cwd=self.path)

    def study(self, *arguments, before=()):
        ended = self.run_program("precision", "tiny.toml", *arguments, before=before)
        self.assertEqual(ended.returncode, 0, ended)
        with h5py.File(self.path / "tiny.h5") as file:
            attributes = dict(file.attrs)
            units = {k: v for k, v in file["precision"].attrs.items() if k.startswith("unit:")}
            return ended, file["precision"][()], attributes, units

    def test_outputs(self):
        ended, rows, attributes, units = self.study()
        self.assertEqual(attributes["format"], "sigmasweep-precision")
        self.assertEqual(attributes["spec"], SPEC)
        self.assertEqual(len(rows), 4 * SETTINGS)
        self.assertEqual({units[f"unit:{name}"] for name in ("run_time", "tc", "s0")} - {"s", "m"}, set())
        self.assertEqual(set(units), {f"unit:{name}" for name in rows.dtype.names})
        self.assertEqual(sorted(set(rows["scene"])), [0, 1, 2, 3])
        names = {v: k for k, v in h5py.check_enum_dtype(rows.dtype["integrator"]).items()}
        for row in rows:
            self.assertEqual(row["tuples"], 1 if names[row["integrator"]] == "exact" and row["sigma"] == 0 else 20)
            self.assertGreater(row["run_time"], 0)
            self.assertEqual(row["chaotic"], 0)
            self.assertLess(row["noise"], 1e-15)
            self.assertEqual(row["compared"] + row["failures"], row["tuples"])
            if names[row["integrator"]] == "exact":
                self.assertLessEqual(row["error_max"], max(row["setting"], 1e-15))
                self.assertTrue(math.isnan(row["evaluations"]))
            elif row["setting"] > 1:
                self.assertEqual(row["failures"], 0)
                self.assertLess(row["error_max"], 0.02)
                self.assertGreater(row["error_max"], 1e-9)
        self.assertIn("N = 3, sigma = 0.5", ended.stdout)
        self.assertIn("gear5", ended.stdout)
        picture = (self.path / "tiny.svg").read_text()
        xml.etree.ElementTree.fromstring(picture)
        self.assertTrue((self.path / "tiny.png").read_bytes().startswith(b"\x89PNG"))
        self.assertEqual(sorted(p.name for p in self.path.iterdir()), ["tiny.h5", "tiny.png", "tiny.svg", "tiny.toml"])

    def test_stored_study_is_drawn(self):
        spec = self.path / "tiny.toml"
        spec.write_text(SPEC.replace("[plot]", "[[plot]]") + '[[plot]]\nname = "one"\nwhere = "N == 1"\n')
        ended, *_ = self.study("--tuples", "3", "--repeats", "1")
        self.assertEqual(sorted(ended.stderr.split()[-5:]),
                         ["tiny-one.png", "tiny-one.svg", "tiny.h5", "tiny.png", "tiny.svg"])
        ended = self.run_program("plot", "tiny.h5", "--name", "one", "-o", "again.svg")
        self.assertEqual((ended.returncode, ended.stdout), (0, "again.svg\n"), ended)
        self.assertEqual((self.path / "again.svg").read_text(), (self.path / "tiny-one.svg").read_text())
        for arguments, code, words in ((["--name", "two"], 64, "no plot 'two'"), (["--x", "N"], 64, "its own axes")):
            ended = self.run_program("plot", "tiny.h5", *arguments)
            self.assertEqual(ended.returncode, code, ended)
            self.assertIn(words, ended.stderr)

    def test_ranks_share_the_scenes(self):
        _, alone, _, _ = self.study("--no-plots", "--tuples", "5", "--repeats", "1")
        _, shared, attributes, _ = self.study("--no-plots", "--tuples", "5", "--repeats", "1",
                                              before=[*MPIEXEC, "-n", "3"])
        self.assertEqual(attributes["ranks"], 3)
        for name in alone.dtype.names:
            if name not in ("run_time", "rank", "ranks_per_core"):
                self.assertEqual(alone[name].tobytes(), shared[name].tobytes(), name)

    def test_refusals(self):
        (self.path / "plain.toml").write_text(SPEC[: SPEC.index("[precision]")])
        for spec, code, word in (("plain.toml", 65, "[precision]"), ("absent.toml", 66, "absent.toml")):
            for before in ([], [*MPIEXEC, "-n", "2"]):
                ended = self.run_program("precision", spec, before=before)
                self.assertEqual(ended.returncode, code, ended)
                self.assertIn(word, ended.stderr)

    def test_plot_of_a_table(self):
        (self.path / "sweep.toml").write_text(
            SPEC[: SPEC.index("[precision]")] + 'integrator = ["exact", "verlet"]\nsteps_per_tc = [2, 100]\n')
        self.assertIn(self.run_program("run", "sweep.toml", "-q").returncode, (0, 3))
        ended = self.run_program("plot", "sweep.h5", "--kind", "precision", "-o", "cost.svg")
        self.assertEqual((ended.returncode, ended.stdout), (0, "cost.svg\n"), ended)
        text = (self.path / "cost.svg").read_text()
        xml.etree.ElementTree.fromstring(text)
        self.assertIn("verlet", text)


if __name__ == "__main__":
    unittest.main()
