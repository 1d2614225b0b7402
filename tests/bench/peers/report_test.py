"""The report puts measurements where they belong; codes that are installed compute the collisions that are meant."""

import pathlib
import shutil
import tempfile
import unittest
import xml.etree.ElementTree

import lammps
import liggghts
import measure
import report
import yade


def cell(method, setting, seconds, error, **group):
    return {"method": method, "setting": setting, "seconds": seconds, "failed": 0, "error_max": error,
            "error_median": error / 2, **group}


FOUND = {
    "date": "2000-01-01", "revision": "abc", "processor": "P", "core": 0, "compiler": "c++", "load": 0.0, "rounds": 1,
    "tuples": 1, "tuples_of_codes": 1, "processes": [{"method": "LAMMPS gran/hooke", "cpu": 0.06, "wall": 0.5}],
    "cells": [cell("exact, side by side", "1e-12", 2e-6, 1e-15, sigma=0.0),
              cell("exact, side by side", "1e-12", 4e-6, 2e-15, sigma=1.0),
              cell("exact, side by side", "1e-12", 5e-6, 2e-15, order="like"),
              cell("odeint dopri5, events", "1e-12", 3e-4, 1e-12, sigma=0.0),
              cell("odeint dopri5, events", "1e-12", 7e-4, 4e-12, sigma=1.0)]}


class Readme(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "docs").mkdir()
        self.readme = self.root / "README.md"

    def test_only_what_stands_between_the_marks_is_replaced(self):
        self.readme.write_text(f"before\n{report.BEGIN}\nold\n{report.END}\nafter\n", encoding="utf-8")
        report.put_into_readme(FOUND, self.root)
        once = self.readme.read_text(encoding="utf-8")
        report.put_into_readme(FOUND, self.root)
        self.assertEqual(self.readme.read_text(encoding="utf-8"), once)
        self.assertTrue(once.startswith(f"before\n{report.BEGIN}\n"))
        self.assertTrue(once.endswith(f"{report.END}\nafter\n"))
        self.assertNotIn("old", once)
        self.assertIn("| odeint dopri5, events | 10⁻¹² | 10⁻¹² | 4 · 10⁻¹² | 500 | 100 |", once)
        self.assertIn("LAMMPS 60.0 ms of CPU time and 500 ms in all", once.replace("\n", " "))
        xml.etree.ElementTree.parse(self.root / "docs" / "peers.svg")

    def test_a_readme_without_a_place_is_refused_and_kept(self):
        for text in ("nothing", report.BEGIN, f"{report.END}{report.BEGIN}"):
            self.readme.write_text(text, encoding="utf-8")
            with self.assertRaisesRegex(SystemExit, "needs one line"):
                report.put_into_readme(FOUND, self.root)
            self.assertEqual(self.readme.read_text(encoding="utf-8"), text)


class Numbers(unittest.TestCase):
    def test_they_are_written_as_in_readme(self):
        self.assertEqual([report.power(x) for x in (4.2e-8, 1e-10, 0.0, None)], ["4 · 10⁻⁸", "10⁻¹⁰", "0", "none"])
        self.assertEqual([report.three_digits(x) for x in (12345.6, 1234.5, 62.04, 1.2345, 0.012345)],
                         ["12,300", "1230", "62.0", "1.23", "0.0123"])

    def test_of_rounds_the_least_times_are_kept(self):
        kept = {}
        measure.keep_least(kept, [cell("a", "1", 3.0, 1.0, sigma=0.0)])
        measure.keep_least(kept, [cell("a", "1", 2.0, 1.0, sigma=0.0), cell("a", "1", 9.0, 1.0, sigma=1.0)])
        measure.keep_least(kept, [cell("a", "1", 4.0, 1.0, sigma=0.0)])
        self.assertEqual([c["seconds"] for c in kept.values()], [2.0, 9.0])

    def test_of_loops_the_least_times_of_each_tuple_are_kept(self):
        kept = {}
        for loops in ([1.0, 5.0], [2.0, 3.0]):
            measure.keep_least(kept, [{"method": "a", "setting": "1", "sigma": 0.0, "loops": loops}])
        self.assertEqual([c["seconds"] for c in kept.values()], [2.0])


class Codes(unittest.TestCase):
    # eps_eff of N = 10, eps = 0.9, sigma = 0.3, computed in 113 bits; when the collision is over, rounded up.
    TUPLE = {"sigma": 0.3, "gap": 0.3, "phase": 0.5, "duration": 13.0, "eps_eff": 0.7998803446388}

    def test_what_is_installed_computes_the_same_collision(self):
        for code in (lammps, liggghts, yade):
            with self.subTest(code.NAME):
                if not shutil.which(code.PROGRAM):
                    self.skipTest(f"{code.PROGRAM} is not installed")
                (found, seconds), = code.results(measure.run(code, code.script([self.TUPLE], 200))[0])
                # Schemes of first order: an error of about 5 % of a step.
                self.assertAlmostEqual(found, self.TUPLE["eps_eff"], delta=1e-3)
                self.assertGreater(seconds, 0.0)


if __name__ == "__main__":
    unittest.main()
