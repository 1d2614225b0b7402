"""Numbers on their way in and out: to the bit, in every form that people type, and in a table all that the spec gives."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import h5py
import numpy

PROGRAM = os.environ["SIGMASWEEP"]
TWO = "--v0 1 --tc 2e-5 --N 2 --epsilon 0.9".split()
COLUMN = "[sweep]\nN = 3\nv0 = 1.0\ntc = 2e-5\nepsilon = 0.9\n"


def sigmasweep(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], text=True, timeout=60,
                          **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **options})


class Numbers(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.path = pathlib.Path(directory.name)

    def ok(self, *arguments):
        ended = sigmasweep(*arguments)
        self.assertEqual(ended.returncode, 0, ended)
        return ended

    def one(self, *arguments):
        return json.loads(self.ok("one", *arguments, "--json").stdout)

    def spec(self, text):
        (self.path / "spec.toml").write_text(text)
        return self.path / "spec.toml"

    def run_spec(self, text, *options):
        return self.ok("run", "-q", self.spec(text), "-o", self.path / "t.h5", *options)

    def results(self):
        return h5py.File(self.path / "t.h5")["results"][()]

    def exported(self):
        return json.loads(self.ok("export", self.path / "t.h5", "--format", "json").stdout)

    def test_forms_of_numbers_on_the_command_line(self):
        self.assertEqual(self.one(*TWO, "--s0", "1e-310")["s0"], 1e-310)
        for typed, number in (("+10", 10), ("10.0", 10), ("1e1", 10)):
            self.assertEqual(self.one("--v0", "+1", *TWO[2:4], "--epsilon", ".9", "--s0", 0, "--N", typed)["N"], number)
        seed = 9007199254740993
        given = self.one(*TWO, "--s0", 1e-6, "--random-separation", "true", "--seed", seed)
        self.assertEqual(given["seed"], seed)
        self.ok("plan", self.spec(COLUMN + "s0 = 0\n"), "--ranks", "1e1")
        for options, words in (((*TWO, "--s0", "2*10^-5"), "(write 2e-5)"), ((*TWO[:4], "--N", "2.5"), "whole number")):
            ended = sigmasweep("one", *options)
            self.assertEqual(ended.returncode, 64)
            self.assertIn(words, ended.stderr)

    def test_forms_of_times_and_slices(self):
        spec = self.spec(COLUMN + "s0 = 0\n")
        for options, words in ((("--max-time", "24h"), "24:00:00"), (("--slice", "3/3"), "0/3, 1/3 and 2/3"),
                               (("--slice", "0/1000001"), "N up to 1000000")):
            ended = sigmasweep("run", spec, *options)
            self.assertEqual(ended.returncode, 64)
            self.assertIn(words, ended.stderr)

    def test_seeds_are_kept_to_the_bit(self):
        seeds = [9007199254740991, 9007199254740992, 9007199254740993]
        self.run_spec(COLUMN + f"s0 = 1e-6\nrandom_separation = true\nseed = {seeds}\n")
        results = self.results()
        self.assertEqual(results["seed"].tolist(), seeds)
        self.assertEqual(len(set(results["eps_eff"])), 3)
        self.assertEqual([row["seed"] for row in self.exported()], seeds)

    def test_tables_hold_what_the_spec_gives(self):
        self.run_spec(COLUMN + 's0 = 1e-6\nlaw = "hertz"\nrandom_separation = true\nseed = 5.0\n')
        results = self.results()
        self.assertEqual(h5py.check_enum_dtype(results.dtype["law"])["hertz"], results["law"][0])
        self.assertEqual(results.dtype["random_separation"], numpy.dtype(bool))
        self.assertTrue(results["random_separation"][0])
        self.assertEqual(results["seed"][0], 5)
        row = self.exported()[0]
        self.assertEqual((row["law"], row["random_separation"]), ("hertz", True))

    def test_one_shows_springs_and_diameters(self):
        given = self.one(*TWO, "--s0", 0)
        again = self.one("--v0", 1, "--N", 2, "--s0", 0, "--K-over-m", repr(given["K_over_m"]), "--D-n",
                         repr(given["D_n"]))
        self.assertAlmostEqual(again["tc"] / 2e-5, 1.0, places=12)
        self.assertAlmostEqual(again["epsilon"], 0.9, places=12)
        unequal = self.one(*TWO, "--s0", 0, "--width", 1e-4, "--seed", 7)["diameters"]
        self.assertEqual(len(set(unequal)), 2)
        self.assertTrue(all(abs(d - 1e-3) <= 0.5e-4 for d in unequal))
        self.assertNotIn("diameters", given)

    def test_what_is_not_said_is_remarked(self):
        elastic = ("--v0", 1, "--N", 2, "--s0", 0, "--K-over-m", 1e10)
        self.assertIn("elastic", self.ok("one", *elastic).stderr)
        self.assertEqual(self.ok("one", *elastic, "--D-n", 0).stderr, "")
        hard = ("--v0", 1, "--N", 2, "--s0", 0, "--method", "ed", "--law", "hertz", "--material", "steel")
        self.assertIn("at v0", self.ok("one", *hard).stderr)

    def test_sobol_samples_are_a_net(self):
        axis = '{{ sample = "sobol", from = {}, to = {}, count = 64{} }}'
        self.run_spec('[sweep]\nmethod = "ed"\nN = 2\ns0 = 0.0\n'
                      f"epsilon = {axis.format(0.2, 1.0, '')}\n"
                      f"v0 = {axis.format(1e-2, 1e2, ', scale = ' + chr(34) + 'log' + chr(34))}\n"
                      'zip = [["epsilon", "v0"]]\n')
        results = self.results()
        self.assertEqual((results["epsilon"][0], results["v0"][0]), (0.2, 1e-2))
        log = numpy.log(results["v0"] / 1e-2) / numpy.log(1e4)
        parts = numpy.floor(64 * log + 1e-9).astype(int)
        self.assertEqual(sorted(parts), list(range(64)))

    def test_a_table_of_other_samples_is_not_mixed_with_its_spec(self):
        sample = 'sigma = { sample = "sobol", from = 0, to = 1, count = 2 }\n'
        self.run_spec(COLUMN + "sigma = [0.5, 0.75]\n")
        old = self.results()
        self.run_spec(COLUMN + sample, "--fresh")
        with h5py.File(self.path / "t.h5", "r+") as file:  # the rows of a program whose samples began with the second point
            rows = file["results"][()]
            rows["sigma"] = old["sigma"]
            del file["results"].attrs["checksum"]
            file["results"][()] = rows
        ended = sigmasweep("run", self.path / "spec.toml", "-o", self.path / "t.h5")
        self.assertEqual(ended.returncode, 73, ended)

    def test_standard_output_that_is_full(self):
        self.run_spec(COLUMN + "s0 = { from = 0, to = 1e-6, count = 400 }\n")
        table = self.path / "t.h5"
        for command in (("show", table), ("export", table), ("export", table, "--format", "json"), ("status", table),
                        ("plan", self.path / "spec.toml"), ("one", *TWO, "--s0", 0), ("--help",)):
            with open("/dev/full", "w") as full:
                ended = sigmasweep(*command, stdout=full)
            self.assertEqual(ended.returncode, 74, (command, ended))
            self.assertIn("standard output", ended.stderr)


if __name__ == "__main__":
    unittest.main()
