"""/results is the same to the bit for any number of ranks; who computed what is in /timings only."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import Sweep, spec  # noqa: E402


class SameResults(unittest.TestCase):
    def check(self, text, exit_code=0):
        one = Sweep(text)
        ended = one.run(0)
        self.assertEqual(ended.code, exit_code, ended)
        self.assertEqual(one.files(), ["sweep.toml", "table.h5"])
        for ranks in (1, 2, 3, 4):
            many = Sweep(text)
            ended = many.run(ranks)
            self.assertEqual(ended.code, exit_code, ended)
            self.assertEqual(many.results(), one.results(), f"{ranks} ranks")
            timings = many.timings()
            self.assertTrue((timings["attempt"] == 1).all())
            self.assertTrue(((0 <= timings["rank"]) & (timings["rank"] < ranks)).all())

    def test_fixed_steps(self):
        self.check(spec(steps=50))

    def test_all_methods(self):
        self.check("""
            title = "Hard and soft"
            [sweep]
            method  = ["md", "ed"]
            N       = [1, 3, 10]
            epsilon = [0.9, 1.0]
            v0      = [14.0, 0.008]
            tc      = [2.5e-6, 2.2e-3]
            s0      = { from = 1e-9, to = 1e-3, count = 13, scale = "log" }
            zip     = [["v0", "tc"]]
        """)

    def test_one_row(self):
        self.check('[sweep]\nN = 10\nepsilon = 0.9\nv0 = 1.0\ntc = 1e-5\nsigma = 0.5\n')


if __name__ == "__main__":
    unittest.main(verbosity=2)
