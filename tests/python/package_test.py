"""The Python package as a notebook uses it: simulate() against the program's own tables, tables as frames and datasets."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import h5py
import numpy as np

import sigmasweep as ss

PROGRAM = os.environ["SIGMASWEEP"]
SPEC = """
title = "a grid"
[sweep]
method = ["md", "ed"]
N = [1, 3, 10]
epsilon = 0.9
v0 = [1.0, 2.0]
tc = [1e-5, 2e-5]
sigma = { from = 0.01, to = 10, count = 5, scale = "log" }
zip = [["v0", "tc"]]
"""
COLUMN = {"N": 10, "epsilon": 0.9, "v0": 1.0, "tc": 1e-5}


class Simulate(unittest.TestCase):
    def test_rows_are_those_of_a_table_to_the_bit(self):
        table = Tables.table(SPEC)
        stored = table.results
        given = {name: stored[name] for name in ("N", "epsilon", "v0", "tc", "sigma")}
        names = np.array(["md", "ed"])
        for threads in (1, 2, 3):
            rows = ss.simulate(**given, method=names[stored["method"]], threads=threads)
            self.assertEqual(rows.dtype.names, stored.dtype.names)
            self.assertEqual(rows.tobytes(), stored.astype(rows.dtype).tobytes())

    def test_parameters_broadcast(self):
        sigma = np.geomspace(1e-3, 1e2, 7)
        rows = ss.simulate(N=np.array([[2], [5]]), epsilon=0.9, v0=1.0, tc=1e-5, sigma=sigma)
        self.assertEqual(rows.shape, (2, 7))
        one = ss.simulate(**(COLUMN | {"N": 5}), sigma=sigma[3])
        self.assertEqual((one.shape, one["eps_eff"]), ((), rows["eps_eff"][1, 3]))

    def test_a_single_collision_has_the_restitution_of_its_pair(self):
        row = ss.simulate(N=2, epsilon=0.7, v0=1.0, tc=1e-5, sigma=1e3, wall="matched")
        self.assertLess(abs(ss.simulate(N=1, epsilon=0.7, v0=1.0, tc=1e-5, s0=0.0, wall="matched")["eps_eff"] - 0.7), 1e-15)
        self.assertEqual(row["status"], 0)

    def test_enumerations_are_as_h5py_has_them(self):
        rows = ss.simulate(**COLUMN, s0=1e-6, random_separation=[False, True])
        self.assertEqual(rows["random_separation"].dtype, bool)
        self.assertEqual(h5py.check_enum_dtype(rows.dtype["method"]), {"md": 0, "ed": 1})
        self.assertEqual(h5py.check_enum_dtype(rows.dtype["status"])["ok"], 0)

    def test_all_geometries_and_laws(self):
        rows = ss.simulate(**COLUMN, sigma=0.3, law=["hooke", "hertz", "taguchi"])
        self.assertEqual(len(set(rows["eps_eff"])), 3)
        plate = ss.simulate(geometry="vibrated-column", N=3, epsilon=0.9, tc=1e-4, alpha=2.0, periods=5, transient=1)
        self.assertGreater(plate["h_cm"], 0)
        lattice = ss.simulate(geometry="lattice", rows=2, columns=3, v0=0.05, tc=2e-5, sigma=0.1, epsilon=0.9)
        self.assertTrue(0 < lattice["eps_eff"] < 1)

    def test_bad_values(self):
        for given, words in (
            ({"N": 10}, "missing"),
            (COLUMN | {"s0": 0.0, "nonsense": 1}, "no parameter"),
            (COLUMN | {"s0": 0.0, "law": "hook"}, "hertz"),
            (COLUMN | {"s0": 0.0, "gravity": 9.81}, "vibrated"),
            (COLUMN | {"s0": 0.0, "sigma": 1.0}, "sigma"),
            (COLUMN | {"s0": 0.0, "N": 2.5}, "whole"),
            (COLUMN | {"s0": 0.0, "v0": "fast"}, "number"),
            (COLUMN | {"s0": [0.0, float("nan")]}, "s0"),
            (COLUMN | {"s0": 0.0, "epsilon": [0.9] * 9 + [1.5]}, "epsilon = 1.5"),
            (COLUMN | {"s0": []}, "empty"),
        ):
            with self.subTest(words), self.assertRaisesRegex(ValueError, words):
                ss.simulate(**given)
        with self.assertRaises(ValueError):
            ss.simulate(**COLUMN, s0=np.zeros(2), threads=0)
        with self.assertRaises(ValueError):
            ss.simulate(**(COLUMN | {"N": [1, 2]}), s0=np.zeros(3))

    def test_a_row_without_a_result_has_its_status(self):
        row = ss.simulate(**(COLUMN | {"epsilon": 0.1}), sigma=1.0, integrator="verlet", steps_per_tc=2.0)
        self.assertNotEqual(row["status"], 0)
        self.assertTrue(np.isnan(row["eps_eff"]))

    def test_ctrl_c_ends_it(self):
        code = ("import numpy as np, sigmasweep as ss\n"
                "print('begun', flush=True)\n"
                "ss.simulate(N=60, epsilon=0.9, v0=1.0, tc=1e-5, sigma=np.linspace(0.3, 0.4, 1000000))")
        process = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.assertEqual(process.stdout.readline(), "begun\n")
        time.sleep(1.0)
        process.send_signal(signal.SIGINT)
        self.assertIn("KeyboardInterrupt", process.communicate(timeout=60)[1])

    def test_threads_of_python_go_on_meanwhile(self):
        beats = []
        done = threading.Event()

        def beat():
            while not done.wait(0.01):
                beats.append(1)

        other = threading.Thread(target=beat)
        other.start()
        ss.simulate(N=60, epsilon=0.9, v0=1.0, tc=1e-5, sigma=np.linspace(0.3, 0.4, 200), threads=1)
        done.set()
        other.join()
        self.assertGreater(len(beats), 2)


class Tables(unittest.TestCase):
    @staticmethod
    def table(spec):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "spec.toml").write_text(spec)
            path = pathlib.Path(folder) / "spec.h5"
            subprocess.run([PROGRAM, "run", "spec.toml", "--quiet"], cwd=folder, check=True, capture_output=True, timeout=60)
            return ss.open(path)

    def test_numpy_and_pandas(self):
        table = self.table(SPEC)
        self.assertEqual((table.title, table.spec, len(table.results)), ("a grid", SPEC, 60))
        self.assertEqual(table.units["tc"], "s")
        self.assertIsNone(table.answers)
        frame = table.pandas()
        self.assertEqual(list(frame["method"].cat.categories), ["md", "ed"])
        self.assertEqual(frame.attrs["units"]["v0"], "m/s")
        np.testing.assert_array_equal(frame["eps_eff"], table.results["eps_eff"])

    def test_xarray_has_the_axes_as_dimensions(self):
        table = self.table(SPEC)
        data = table.xarray()
        self.assertEqual(dict(data.sizes), {"method": 2, "N": 3, "v0-tc": 2, "sigma": 5})
        self.assertEqual(list(data["method"].values), ["md", "ed"])
        self.assertEqual(data["v0"].dims, ("v0-tc",))
        self.assertEqual(data["v0"].attrs["units"], "m/s")
        chosen = data.sel({"method": "ed", "N": 10}).isel({"v0-tc": 1, "sigma": 2})
        rows = table.results
        row = rows[(rows["method"] == 1) & (rows["N"] == 10) & (rows["v0"] == 2.0)][2]
        self.assertEqual((float(chosen.eps_eff), float(chosen.sigma)), (row["eps_eff"], row["sigma"]))

    def test_xarray_of_chosen_tuples_has_rows(self):
        data = self.table(SPEC + 'where = "sigma > 0.1"\n').xarray()
        self.assertEqual(list(data.sizes), ["row"])

    def test_what_is_no_table(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "x.h5"
            with self.assertRaisesRegex(FileNotFoundError, "no table"):
                ss.open(path)
            (pathlib.Path(folder) / "x.h5.journal").touch()
            with self.assertRaisesRegex(FileNotFoundError, "not complete"):
                ss.open(path)
            path.write_bytes(b"nonsense")
            with self.assertRaises(ValueError):
                ss.open(path)
            with h5py.File(path, "w"):
                pass
            with self.assertRaisesRegex(ValueError, "no table"):
                ss.open(path)


if __name__ == "__main__":
    unittest.main()
