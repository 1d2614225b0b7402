"""Trajectories beside a table: are they H5MD 1.1 (h5py is the independent reader, the rules are written out here from
https://www.nongnu.org/h5md/releases/h5md-1.1.0.html), are they the collisions, and does a run treat them as a user
expects."""

import pathlib
import signal
import subprocess
import sys
import unittest

import h5py
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import PROGRAM, Sweep, end_of  # noqa: E402

SWEEP = """
[sweep]
method  = ["md", "ed"]
N       = [1, 3]
epsilon = 0.9
v0      = 0.2
tc      = 7e-6
s0      = [0.0, 1e-6]
width   = 1e-4
"""
FILMED = SWEEP + "[trajectory]\nsamples = 101\n[plot]\nkind = 'trajectories'\n"


class Films(Sweep):
    def file(self, row):
        return self.path / "table.trajectories" / f"row-{row:06}.h5"

    def names(self):
        directory = self.path / "table.trajectories"
        return sorted(entry.name for entry in directory.iterdir()) if directory.exists() else []

    def bytes(self):
        return {name: (self.path / "table.trajectories" / name).read_bytes() for name in self.names()}


ALL = [f"row-{row:06}.h5" for row in range(8)]


LATTICE = """
[sweep]
geometry   = "lattice"
rows       = 3
columns    = 2
side_walls = ["periodic", "fixed"]
D_t        = 300.0
epsilon    = 0.9
v0         = 0.2
tc         = 7e-6
s0         = 1e-6
width      = 1e-4
random_separation = true
tolerance  = 1e-6
[trajectory]
samples = 101
[plot]
kind = "trajectories"
"""


class Rules(unittest.TestCase):
    """Of H5MD 1.1."""

    def fixed_text(self, attribute, shape=()):
        """Strings are of fixed length."""
        self.assertEqual(attribute.shape, shape)
        info = h5py.check_string_dtype(attribute.dtype)
        self.assertIsNotNone(info.length, attribute.dtype)

    def element(self, group, shape):
        """A time-dependent element with explicit step and time."""
        step, time, value = group["step"], group["time"], group["value"]
        self.assertEqual(step.dtype.kind, "i")
        self.assertEqual(time.dtype.kind, "f")
        self.assertEqual(step.shape, time.shape)
        self.assertTrue((numpy.diff(step[()]) > 0).all() and (numpy.diff(time[()]) > 0).all())
        self.assertEqual(value.shape, step.shape + shape)
        self.assertEqual(group.attrs["time_unit"], b"s")

    def metadata(self, file):
        version = file["h5md"].attrs["version"]
        self.assertEqual((version.dtype.kind, version.tolist()), ("i", [1, 1]))
        for group, key in (("author", "name"), ("creator", "name"), ("creator", "version")):
            self.fixed_text(file["h5md"][group].attrs.get_id(key))
        self.assertEqual(file["h5md/creator"].attrs["name"], b"sigmasweep")
        self.assertEqual(file["h5md/modules/units"].attrs["version"].tolist(), [1, 0])


class H5md(Rules):
    """The rules, then what our files say beyond them."""

    @classmethod
    def setUpClass(cls):
        cls.sweep = Films(FILMED)
        ended = cls.sweep.run(0)
        assert ended.code == 0, ended

    def test_rules(self):
        for name in ALL:
            with self.subTest(name), h5py.File(self.sweep.path / "table.trajectories" / name) as file:
                self.metadata(file)
                beads = file["particles/beads"]
                N = file["parameters"].attrs["N"]
                dimension = beads["box"].attrs.get_id("dimension")
                self.assertEqual((dimension.shape, dimension.dtype.kind), ((), "i"))
                self.assertEqual(beads["box"].attrs["dimension"], 3)
                self.fixed_text(beads["box"].attrs.get_id("boundary"), (3,))
                self.assertEqual(beads["box"].attrs["boundary"].tolist(), [b"none"] * 3)  # then edges may be left out
                self.assertFalse(beads["position/value"][:, :, :2].any())  # a column is along z
                for name, unit, size in (("position", b"m", 3), ("velocity", b"m s-1", 3), ("reduced_height", b"m", 1)):
                    self.element(beads[name], (N, size))
                    self.assertEqual(beads[name].attrs["unit"], unit)
                    for shared in ("step", "time"):  # hard links: the same object
                        self.assertEqual(beads[name][shared], beads["position"][shared])
                self.element(file["observables/kinetic_energy"], ())
                self.assertEqual(beads["mass"].shape, (N,))
                self.assertEqual(beads["mass"].dtype.kind, "f")

    def test_parameters_and_physics(self):
        with h5py.File(self.sweep.table) as table:
            rows = table["results"][()]
        for k, row in enumerate(rows):
            with self.subTest(row=k), h5py.File(self.sweep.file(k)) as file:
                given = file["parameters"].attrs
                for name in ("v0", "tc", "s0", "sigma", "N", "epsilon"):
                    self.assertEqual(given[name], row[name])
                self.assertEqual((given["row"], given["method"]), (k, (b"md", b"ed")[row["method"]]))
                beads = file["particles/beads"]
                d, mass = beads["diameter"][()], beads["mass"][()]
                numpy.testing.assert_allclose(mass, (d / 1e-3) ** 3, rtol=1e-14)
                base = numpy.cumsum(d) - d / 2
                z, h = beads["reduced_height/value"][:, :, 0], beads["position/value"][:, :, 2]
                numpy.testing.assert_allclose(h, z + base, atol=1e-18)  # some roundings of 3e-3 m
                numpy.testing.assert_allclose(z[0], row["s0"] * numpy.arange(1, row["N"] + 1), atol=1e-20)
                energy = file["observables/kinetic_energy/value"][()]
                v = beads["velocity/value"][:, :, 2]
                numpy.testing.assert_allclose(energy, (v**2 @ mass) / (0.2**2 * mass.sum()), rtol=1e-13)
                self.assertEqual(len(energy), 101)
                if row["N"] == 1:  # it has left the wall by then
                    self.assertAlmostEqual(energy[-1] ** 0.5, row["eps_eff"], delta=1e-12)
                end = 1.5 * (row["s0"] / 0.2 + row["t_k"]) or 1.5 * row["N"] * 7e-6
                self.assertAlmostEqual(beads["position/time"][-1] / end, 1.0, delta=1e-14)

    def test_mdanalysis(self):
        import MDAnalysis
        universe = MDAnalysis.Universe.empty(3, trajectory=False)
        universe.load_new(str(self.sweep.file(3)), format="H5MD", convert_units=False)  # it knows no metres
        with h5py.File(self.sweep.file(3)) as file:
            position = file["particles/beads/position/value"][-1]
        numpy.testing.assert_allclose(universe.trajectory[-1].positions, position, rtol=1e-6)  # floats
        self.assertIsNone(universe.dimensions)

    def test_plot(self):
        for form in ("svg", "png"):
            ended = subprocess.run([PROGRAM, "plot", "table.h5", "-o", f"film.{form}"], cwd=self.sweep.path,
                                   capture_output=True, text=True, timeout=60)
            self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
        picture = (self.sweep.path / "film.svg").read_text()
        self.assertIn("µs", picture)
        self.assertIn("(h) ED", picture)
        self.file_gone_and_back()

    def file_gone_and_back(self):
        self.sweep.file(3).unlink()
        ended = subprocess.run([PROGRAM, "plot", "table.h5"], cwd=self.sweep.path, capture_output=True, text=True,
                               timeout=60)
        self.assertEqual(ended.returncode, 66, ended)
        self.assertIn("row-000003.h5", ended.stderr)
        self.assertEqual(self.sweep.run(0).code, 0)
        self.assertEqual(self.sweep.names(), ALL)


class H5mdOfLattices(Rules):
    @classmethod
    def setUpClass(cls):
        cls.sweep = Films(LATTICE)
        ended = cls.sweep.run(0)
        assert ended.code == 0, ended

    def test_rules_and_physics(self):
        with h5py.File(self.sweep.table) as table:
            rows = table["results"][()]
        for k, row in enumerate(rows):
            with self.subTest(row=k), h5py.File(self.sweep.file(k)) as file:
                self.metadata(file)
                beads, box = file["particles/beads"], file["particles/beads/box"]
                self.assertEqual(box.attrs["dimension"], 3)
                self.fixed_text(box.attrs.get_id("boundary"), (3,))
                self.assertEqual(box.attrs["boundary"].tolist(), [(b"periodic", b"none")[k], b"none", b"none"])
                self.element(box["edges"], (3, 3))
                self.assertEqual(box["edges"].attrs["unit"], b"m")
                for name, unit in (("position", b"m"), ("velocity", b"m s-1")):
                    self.element(beads[name], (6, 3))
                    self.assertEqual(beads[name].attrs["unit"], unit)
                    for shared in ("step", "time"):
                        self.assertEqual(beads[name][shared], beads["position"][shared])
                self.assertNotIn("reduced_height", beads)
                given = file["parameters"].attrs
                self.assertEqual([given[name] for name in ("rows", "columns", "N", "D_t", "side_walls")],
                                 [3, 2, 6, 300.0, (b"periodic", b"fixed")[k]])
                self.physics(file, beads, row, periodic=k == 0)

    def physics(self, file, beads, row, periodic):
        x, y, h = numpy.moveaxis(beads["position/value"][()], 2, 0)
        self.assertFalse(y.any())
        d, mass, edges = beads["diameter"][()], beads["mass"][()], numpy.diag(beads["box/edges/value"][-1])
        a = 1.05e-3 + 1e-6  # of the largest beads that width allows, and s0
        self.assertAlmostEqual(edges[0] / (2 * a if periodic else 2.5 * a + 1e-6), 1.0, delta=1e-14)
        self.assertEqual(edges[1], d.max())
        self.assertEqual(edges[2], (h + d / 2).max())
        numpy.testing.assert_allclose(mass, (d / 1e-3) ** 3, rtol=1e-14)
        self.assertTrue((h[0] - d / 2 > 0).all() and (h - d / 2 > -1e-5).all())  # the bottom; overlaps are some v0 tc
        if not periodic:
            self.assertTrue((x - d / 2 > -1e-5).all() and (x + d / 2 < edges[0] + 1e-5).all())
        v = beads["velocity/value"][()]
        numpy.testing.assert_allclose(v[0], [[0.0, 0.0, -0.2]] * 6, atol=1e-16)
        energy = file["observables/kinetic_energy/value"][()]
        numpy.testing.assert_allclose(energy, ((v**2).sum(axis=2) @ mass) / (0.2**2 * mass.sum()), rtol=1e-13)
        self.assertAlmostEqual(energy[0], 1.0, delta=1e-14)
        self.assertGreater(energy[-1] ** 0.5, row["eps_eff"] - 1e-6)  # the film may end before the last contact

    def test_mdanalysis(self):
        import MDAnalysis
        for k in range(2):
            with self.subTest(k), h5py.File(self.sweep.file(k)) as file:
                beads = file["particles/beads"]
                universe = MDAnalysis.Universe.empty(6, trajectory=False)
                universe.load_new(str(self.sweep.file(k)), format="H5MD", convert_units=False)  # it knows no metres
                frame = universe.trajectory[-1]
                self.assertEqual(universe.trajectory.n_frames, 101)
                numpy.testing.assert_allclose(frame.positions, beads["position/value"][-1], rtol=1e-6)  # floats
                numpy.testing.assert_allclose(frame.velocities, beads["velocity/value"][-1], rtol=1e-6)
                edges = numpy.diag(beads["box/edges/value"][-1])
                numpy.testing.assert_allclose(frame.dimensions, [*edges, 90, 90, 90], rtol=1e-6)

    def test_plot(self):
        for form in ("svg", "png", "pdf"):
            ended = subprocess.run([PROGRAM, "plot", "table.h5", "-o", f"film.{form}"], cwd=self.sweep.path,
                                   capture_output=True, text=True, timeout=60)
            self.assertEqual((ended.returncode, ended.stderr), (0, ""), ended)
        picture = (self.sweep.path / "film.svg").read_text()
        self.assertIn("first contact", picture)
        self.assertIn("(b) side", picture)

    def test_not_with_columns_on_one_picture(self):
        spec = LATTICE.replace('"lattice"', '["lattice", "column"]').replace("columns ", "N = 3\ncolumns ")
        mixed = Films(spec)
        self.assertEqual(mixed.run(0).code, 0)
        self.assertEqual(len(mixed.names()), 4)
        ended = subprocess.run([PROGRAM, "plot", "table.h5"], cwd=mixed.path, capture_output=True, text=True, timeout=60)
        self.assertEqual(ended.returncode, 64, ended)
        self.assertIn("'where'", ended.stderr)


class Runs(unittest.TestCase):
    def test_same_bytes_for_any_number_of_ranks_and_same_results_without(self):
        plain = Films(SWEEP)
        self.assertEqual(plain.run(0).code, 0)
        self.assertEqual(plain.names(), [])
        one = Films(FILMED)
        self.assertEqual(one.run(0).code, 0)
        self.assertEqual(one.files(), ["sweep.toml", "table.h5", "table.trajectories"])
        self.assertEqual(one.names(), ALL)
        self.assertEqual(one.results(), plain.results())
        for ranks in (1, 3):
            many = Films(FILMED)
            ended = many.run(ranks)
            self.assertEqual(ended.code, 0, ended)
            self.assertEqual(many.bytes(), one.bytes())
            self.assertEqual(many.results(), one.results())

    def test_deleted_files_come_back_and_the_others_stay(self):
        sweep = Films(FILMED)
        self.assertEqual(sweep.run(0).code, 0)
        before = sweep.bytes()
        kept = sweep.file(1).stat().st_mtime_ns
        sweep.file(0).unlink()
        sweep.file(7).unlink()
        ended = sweep.run(3)
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(sweep.bytes(), before)
        self.assertEqual(sweep.file(1).stat().st_mtime_ns, kept)

    def test_files_of_something_else(self):
        sweep = Films(FILMED)
        self.assertEqual(sweep.run(0).code, 0)
        whole = sweep.bytes()
        for foreign in (b"something else", whole["row-000003.h5"]):
            for ranks in (0, 3):
                sweep.file(2).write_bytes(foreign)
                ended = sweep.run(ranks)
                self.assertEqual(ended.code, 73, ended)
                self.assertEqual(ended.err.count("row-000002.h5"), 1, ended)
                self.assertEqual(sweep.file(2).read_bytes(), foreign)
        self.assertEqual(sweep.run(2, "--fresh").code, 0)
        self.assertEqual(sweep.bytes(), whole)

    def test_fresh_with_another_spec(self):
        sweep = Films(FILMED)
        self.assertEqual(sweep.run(0).code, 0)
        sweep.spec.write_text(FILMED.replace("0.9", "0.8").replace("samples", "where = 'N == 3'\nsamples"))
        self.assertEqual(sweep.run(0).code, 73)
        self.assertEqual(sweep.names(), ALL)
        self.assertEqual(sweep.run(0, "--fresh").code, 0)
        self.assertEqual(sweep.names(), [ALL[2], ALL[3], ALL[6], ALL[7]])

    def test_no_directory(self):
        sweep = Films(FILMED)
        (sweep.path / "table.trajectories").write_text("in the way")
        for ranks in (0, 3):
            ended = sweep.run(ranks)
            self.assertEqual(ended.code, 73, ended)
            self.assertEqual(ended.err.count("table.trajectories"), 1, ended)
        self.assertEqual((sweep.path / "table.trajectories").read_text(), "in the way")

    def test_stopped_and_gone_on_with(self):
        many = FILMED.replace("[0.0, 1e-6]", "{ from = 1e-7, to = 1e-5, count = 400 }").replace("101", "20001")
        sweep = Films(many.replace("N       = [1, 3]", "N = 10"))
        process = sweep.start(2)
        while not sweep.names() and process.poll() is None:
            pass
        process.send_signal(signal.SIGUSR1)
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        self.assertEqual(ended.err.count("run it again to go on"), 1, ended)
        self.assertTrue(sweep.table.exists())
        names = sweep.names()
        self.assertTrue(0 < len(names) < 800 and all(name.endswith(".h5") for name in names))
        ended = sweep.run(0, "--max-seconds", "0.5")  # goes on a little: never fewer
        self.assertIn(ended.code, (0, 75), ended)
        self.assertGreater(len(sweep.names()), len(names))

    def test_specs(self):
        for wrong, words in (("samples = 1", "from 2 to"), ("duration = 0", "> 0"), ("sample = 3", "samples"),
                             ("where = 'N == 7'", "no row"), ("where = 'N'", "where"),
                             ("where = 'eps_eff > 0'", "eps_eff"), ("samples = 1000000\nwhere = 'N == 3'\nx = 1", "x")):
            sweep = Films(SWEEP + "[trajectory]\n" + wrong + "\n")
            ended = sweep.run(0)
            self.assertEqual(ended.code, 65, ended)
            self.assertIn("trajectory", ended.err)
            self.assertIn(words, ended.err)
            self.assertEqual(sweep.files(), ["sweep.toml"])
        big = Films(SWEEP.replace("[0.0, 1e-6]", "{ from = 1e-7, to = 1e-5, count = 4000 }") + "[trajectory]\n")
        ended = big.run(0)
        self.assertEqual(ended.code, 65, ended)
        self.assertIn("10000", ended.err)
        lonely = Films(SWEEP + "[plot]\nkind = 'trajectories'\n")
        ended = lonely.run(0)
        self.assertEqual(ended.code, 65, ended)
        self.assertIn("[trajectory]", ended.err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
