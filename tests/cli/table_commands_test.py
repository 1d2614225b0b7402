"""One small run, then everything that reads its table: show, export, plot. h5py is the independent reader."""

import csv
import json
import os
import pathlib
import shlex
import struct
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

import h5py

PROGRAM = os.environ["SIGMASWEEP"]
TITLE = "A table, with 'quotes', `touch pwned` and $(touch pwned); | touch pwned"
# Two time steps a contact are too few for verlet: its eight rows fail. sigma = 0 has no place on a logarithmic axis.
SPEC = f"""
title = "{TITLE}"
[sweep]
integrator = ["exact", "verlet"]
steps_per_tc = 2.0
N = 5
epsilon = [0.9, 0.1]
v0 = 2.0
tc = 1e-5
sigma = [0.0, 0.1, 1, 10]
[plot]
series = ["integrator", "epsilon"]
"""


def bits(number):
    return struct.pack("<d", number) if number == number else b"nan"


class TableCommands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.directory = tempfile.TemporaryDirectory(prefix="sigma sweep ")
        cls.path = pathlib.Path(cls.directory.name)
        (cls.path / "spec.toml").write_text(SPEC)
        cls.run_ended = cls.sigmasweep("run", "spec.toml", "-o", "table.h5")
        with h5py.File(cls.path / "table.h5") as file:
            cls.table = file["results"][()]

    @classmethod
    def tearDownClass(cls):
        cls.directory.cleanup()

    @classmethod
    def sigmasweep(cls, *arguments):
        return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=60, cwd=cls.path)

    def ok(self, *arguments):
        ended = self.sigmasweep(*arguments)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
        return ended.stdout

    def test_rows_without_a_result_are_exit_code_3(self):
        self.assertEqual(self.run_ended.returncode, 3, self.run_ended)
        self.assertEqual(self.sigmasweep("run", "spec.toml", "-o", "table.h5").returncode, 3)

    def test_show_json_has_the_bits_of_the_file(self):
        document = json.loads(self.ok("show", "table.h5", "--json"))
        self.assertEqual((document["title"], document["rows"], len(document["results"])), (TITLE, 16, 16))
        for row, stored in zip(document["results"], self.table):
            for name in ("v0", "tc", "s0", "sigma", "epsilon", "eps_eff", "eps_eff_error", "Er_Ef", "t_k"):
                shown = row[name] if row[name] is not None else float("nan")
                self.assertEqual(bits(shown), bits(stored[name]), name)
            self.assertEqual((row["N"], row["contacts"]), (stored["N"], stored["contacts"]))
            self.assertIn(row["integrator"], ("exact", "verlet"))

    def test_show_where(self):
        def count(condition):
            return json.loads(self.ok("show", "table.h5", "--json", "--where", condition))["matching"]

        self.assertEqual(count("sigma >= 1"), 8)
        self.assertEqual(count("integrator == exact && sigma > 1"), 2)
        self.assertEqual(count("status != ok"), 8)
        self.assertEqual(count("eps_eff > 0.5"), sum(self.table["eps_eff"] > 0.5))
        self.assertEqual(count("steps_per_tc == 2"), 16)  # no column: it comes from the spec
        wrong = self.sigmasweep("show", "table.h5", "--where", "sigm > 1")
        self.assertEqual((wrong.returncode, wrong.stdout), (64, ""))
        self.assertIn("sigma", wrong.stderr)

    def test_show_fields_in_an_order(self):
        rows = json.loads(self.ok("show", "table.h5", "--json", "--fields", "sigma,eps_eff,run_time", "--sort", "-eps_eff",
                                  "--limit", 10))
        self.assertEqual((rows["matching"], len(rows["results"])), (16, 10))
        shown = [row["eps_eff"] for row in rows["results"]]
        known = sorted((value for value in self.table["eps_eff"] if value == value), reverse=True)
        self.assertEqual(shown, known + [None] * 2)  # rows without a result come last
        self.assertNotIn("epsilon", rows["results"][0])
        lines = self.ok("show", "table.h5", "--fields", "N,sigma", "--sort", "sigma").splitlines()
        self.assertEqual(lines[3].split(), ["row", "N", "sigma"])
        self.assertEqual([line.split()[2] for line in lines[5:]], sorted([line.split()[2] for line in lines[5:]], key=float))
        for options in (["--fields", "sigm"], ["--sort", "-eps_ef"]):
            wrong = self.sigmasweep("show", "table.h5", *options)
            self.assertEqual((wrong.returncode, wrong.stdout), (64, ""))
            self.assertRegex(wrong.stderr, "sigma|eps_eff")

    def test_show_spec(self):
        self.assertEqual(self.ok("show", "table.h5", "--spec"), SPEC)

    def test_show_text(self):
        shown = self.ok("show", "table.h5", "--limit", 3)
        for words in (TITLE, "16 rows (ok 8, unstable 8)", "eps_eff", "... 13 more"):
            self.assertIn(words, shown)
        self.assertIn("no such rows", self.ok("show", "table.h5", "--where", "sigma > 100"))

    def test_failed_rows_come_with_the_command_that_repeats_them(self):
        lines = [line.strip() for line in self.ok("show", "table.h5", "--failed").splitlines()]
        commands = [line for line in lines if line.startswith("sigmasweep one ")]
        self.assertEqual(len(commands), 8)
        rows = [row for row in json.loads(self.ok("show", "table.h5", "--json", "--failed"))["results"]]
        self.assertEqual([row["repeat"] for row in rows], commands)
        for row in rows:
            again = self.sigmasweep(*shlex.split(row["repeat"])[1:], "--json")
            self.assertEqual(again.returncode, 3, again)
            result = json.loads(again.stdout)
            for name in ("v0", "tc", "s0", "sigma", "N", "epsilon", "status"):
                self.assertEqual(result[name], row[name])

    def test_export(self):
        self.assertEqual(self.ok("export", "table.h5", "-o", "table.csv"), "")
        data = (self.path / "table.csv").read_bytes().decode()
        self.assertEqual((data.count("\n"), data.count("\r")), (17, 0))
        self.assertEqual(data.count("\n"), 17)
        self.assertEqual(self.sigmasweep("export", "table.h5").stdout, data)
        rows = list(csv.DictReader(data.splitlines()))
        self.assertEqual(list(rows[0]), list(self.table.dtype.names))
        for row, stored in zip(rows, self.table):
            for name in ("s0", "sigma", "eps_eff", "t_k", "x_max"):
                self.assertEqual(bits(float(row[name])), bits(stored[name]))
        self.assertIn("run_time", self.ok("export", "table.h5", "--timings").splitlines()[0])
        self.assertEqual(self.sigmasweep("export", "table.h5", "-o", "missing/table.csv").returncode, 73)

    def equals_the_table(self, objects):
        self.assertEqual(len(objects), len(self.table))
        for row, stored in zip(objects, self.table):
            self.assertEqual(list(row), list(self.table.dtype.names))
            for name in ("s0", "sigma", "eps_eff", "t_k", "x_max"):
                value = row[name] if row[name] is not None else float("nan")
                self.assertEqual(bits(value), bits(stored[name]))
            self.assertIn(row["integrator"], ("exact", "verlet"))

    def test_export_json(self):
        text = self.ok("export", "table.h5", "--format", "json")
        self.equals_the_table(json.loads(text))
        self.assertEqual(text.count("\n"), 18)
        self.ok("export", "table.h5", "-o", "table.json")  # by the ending
        self.assertEqual((self.path / "table.json").read_text(), text)
        csv_text = self.sigmasweep("export", "table.h5", "--format", "csv", "-o", "also.json")
        self.assertEqual(csv_text.returncode, 0)
        self.assertEqual((self.path / "also.json").read_bytes(), self.csv_bytes())
        self.assertEqual(self.sigmasweep("export", "table.h5", "--format", "xls").returncode, 64)

    def test_export_json_lines(self):
        text = self.ok("export", "table.h5", "--format", "jsonl")
        self.equals_the_table([json.loads(line) for line in text.splitlines()])
        self.assertTrue(text.endswith("}\n"))
        self.ok("export", "table.h5", "-o", "table.jsonl")
        self.assertEqual((self.path / "table.jsonl").read_text(), text)

    def csv_bytes(self):
        self.ok("export", "table.h5", "-o", "bytes.txt")  # no format's ending: CSV
        return (self.path / "bytes.txt").read_bytes()

    def test_plot(self):
        for form, magic in (("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")):
            self.ok("plot", "table.h5", "-o", f"a plot; `touch pwned`.{form}")
            self.assertTrue((self.path / f"a plot; `touch pwned`.{form}").read_bytes().startswith(magic))
        self.assertEqual(self.ok("plot", "table.h5"), "table.svg\n")
        words = " ".join(xml.etree.ElementTree.parse(self.path / "table.svg").getroot().itertext())
        words = " ".join(words.split())
        for expected in (TITLE, "8 rows that failed", "2 rows with", "exact, ε"):
            self.assertIn(expected, words)
        self.assertFalse((self.path / "pwned").exists())

    def test_several_plots_and_fits(self):
        plots = SPEC.split("[plot]")[0] + """
[[plot]]
name = "first"
[[plot]]
name = "loss"
x = "sigma"
y = "1 - eps_eff"
y_scale = "log"
where = "integrator == exact"
series = "epsilon"
fit = { form = "power", from = 0.1, to = 1 }
guides = [{ slope = 0.5, label = "a guide" }, { y = 0.2 }]
"""
        (self.path / "plots.toml").write_text(plots)
        self.assertEqual(self.sigmasweep("run", "plots.toml", "-o", "plots.h5").returncode, 3)
        lines = self.ok("plot", "plots.h5").splitlines()
        self.assertEqual(lines[:2], ["plots.svg", "plots-loss.svg"])
        self.assertEqual(lines[2].split(), ["series", "slope", "error", "prefactor", "points"])
        self.assertEqual(lines[3].split()[:3], ["epsilon", "=", "0.9"])
        self.assertEqual([line.split()[-1] for line in lines[3:]], ["2", "2"])
        words = " ".join(xml.etree.ElementTree.parse(self.path / "plots-loss.svg").getroot().itertext())
        self.assertIn("a guide", " ".join(words.split()))
        self.assertEqual(self.ok("plot", "plots.h5", "-q", "-o", "b.png"), "b.png\nb-loss.png\n")
        self.assertEqual(self.ok("plot", "plots.h5", "-q", "--name", "loss"), "plots-loss.svg\n")
        self.assertEqual(self.ok("plot", "plots.h5", "-q", "--name", "loss", "-o", "c.svg"), "c.svg\n")
        self.assertEqual(self.ok("plot", "plots.h5", "--y", "sqrt(eps_eff)", "-o", "d.svg"), "d.svg\n")
        wrong = self.sigmasweep("plot", "plots.h5", "--name", "los")
        self.assertEqual((wrong.returncode, wrong.stdout), (64, ""))
        self.assertIn("did you mean 'loss'?", wrong.stderr)

    def test_plot_overrides_and_refusals(self):
        self.ok("plot", "table.h5", "--x", "epsilon", "--x-scale", "linear", "--y", "contacts", "--series", "sigma",
                "-o", "other.svg")
        for arguments in (["-o", "plot.gif"], ["--x", "sigm"], ["--y", "method"], ["--x-scale", "cubic"]):
            self.assertEqual(self.sigmasweep("plot", "table.h5", *arguments).returncode, 64)
        self.assertEqual(self.sigmasweep("plot", "table.h5", "-o", "missing/plot.svg").returncode, 73)
        environment = dict(os.environ, PATH="/nowhere")
        ended = subprocess.run([PROGRAM, "plot", "table.h5", "-o", "no.svg"], env=environment, cwd=self.path,
                               capture_output=True, text=True, timeout=60)
        self.assertEqual(ended.returncode, 73)
        self.assertIn("gnuplot is not installed", ended.stderr)
        self.assertFalse(list(self.path.glob("*.part*")))

    def test_not_a_table(self):
        for command in ("show", "export", "plot"):
            ended = self.sigmasweep(command, "spec.toml")
            self.assertEqual((ended.returncode, ended.stdout), (74, ""))
            self.assertEqual(ended.stderr.count("\n"), 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
