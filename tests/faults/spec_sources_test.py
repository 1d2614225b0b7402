"""Specs that were edited, come from a pipe, have dots in their names, or say the same thing twice."""

import subprocess
import unittest

from sweep_process import PROGRAM, Sweep, spec, stopped_sweep

QUICK = """
[sweep]
N = [2, 3]
v0 = 1.0
tc = 2e-5
epsilon = 0.9
s0 = 0.0
"""


class EditedSpecs(unittest.TestCase):
    def test_an_unfinished_sweep_goes_on_when_its_tuples_are_the_same(self):
        sweep = stopped_sweep()
        edited = "# a comment\n" + spec().replace("0.9, 0.8", "9e-1, 0.80") + "[plot]\nx_scale = 'log'\n"
        sweep.spec.write_text(edited)
        kept = sweep.finish_keeping_rows()
        self.assertGreaterEqual(len(kept), 5)
        whole = Sweep()
        self.assertEqual(whole.run(2).code, 0)
        self.assertEqual(sweep.results(), whole.results())
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def test_other_tuples_are_refused_with_the_way_to_keep_rows(self):
        for edit in (("0.9, 0.8", "0.8, 0.9"), ("count = 15", "count = 14")):
            sweep = stopped_sweep()
            before = sweep.journal.read_bytes()
            sweep.spec.write_text(spec().replace(*edit))
            ended = sweep.run(0)
            self.assertEqual(ended.code, 73, ended)
            self.assertIn("--extend, which keeps the rows", ended.err)
            self.assertEqual(sweep.journal.read_bytes(), before)


class SourcesOfSpecs(unittest.TestCase):
    def setUp(self):
        self.sweep = Sweep(QUICK)
        self.path = self.sweep.path

    def call(self, *arguments, text=None):
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60, cwd=self.path,
                              input=text or "")

    def test_dots_belong_to_the_name(self):
        for name, table in (("fig.2a.toml", "fig.2a.h5"), ("sweep.v2", "sweep.v2.h5"), ("sweep.v3", "sweep.v3.h5")):
            (self.path / name).write_text(QUICK)
            ended = self.call("run", "-q", name)
            self.assertEqual(ended.returncode, 0, ended)
            self.assertTrue((self.path / table).exists(), self.sweep.files())
        self.assertEqual(self.call("plot", "sweep.v2.h5").stdout, "sweep.v2.svg\n")
        (self.path / "sweep.v3.h5").rename(self.path / "table.3")
        self.assertEqual(self.call("plot", "table.3").stdout, "table.3.svg\n")

    def test_standard_input(self):
        self.assertEqual(self.call("run", "-q", "sweep.toml", "-o", "table.h5").returncode, 0)
        expected = self.sweep.results()
        self.sweep.table.unlink()
        self.assertIn("tuples         2", self.call("plan", "-", text=QUICK).stdout)
        ended = self.call("run", "-q", "-", "-o", "table.h5", text=QUICK)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
        self.assertEqual(self.sweep.results(), expected)
        nameless = self.call("run", "-", text=QUICK)
        self.assertEqual(nameless.returncode, 64, nameless)
        self.assertIn("-o TABLE.h5", nameless.stderr)
        wrong = self.call("plan", "-", text=QUICK.replace("epsilon", "epsilom"))
        self.assertEqual(wrong.returncode, 65, wrong)
        self.assertIn("standard input:6:", wrong.stderr)
        self.assertEqual(self.sweep.files(), ["sweep.toml", "table.h5"])

    def test_a_pipe(self):
        shell = subprocess.run(["bash", "-c", f"'{PROGRAM}' run -q <(cat sweep.toml) -o table.h5"], capture_output=True,
                               text=True, timeout=60, cwd=self.path)
        self.assertEqual((shell.returncode, shell.stderr), (0, ""), shell)
        self.assertEqual(len(self.sweep.timings()), 2)

    def test_values_that_stand_there_twice_get_a_word(self):
        self.sweep.spec.write_text(QUICK.replace("[2, 3]", "[2, 3, 2]"))
        for command in ("plan", "run"):
            ended = self.call(command, "sweep.toml")
            self.assertEqual(ended.returncode, 0, ended)
            self.assertIn("1 of 3 rows repeat the tuple of another row (row 2 that of row 0)", ended.stderr)
        self.sweep.spec.write_text(QUICK)
        self.assertEqual(self.call("plan", "sweep.toml").stderr, "")


if __name__ == "__main__":
    unittest.main(verbosity=2)
