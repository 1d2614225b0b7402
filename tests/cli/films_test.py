"""Films for viewers: what independent readers find in them is what the H5MD files hold. ASE and VTK are asked where they
are installed."""

import importlib.util
import pathlib
import subprocess
import sys
import unittest
import xml.etree.ElementTree

import h5py
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import PROGRAM, Sweep  # noqa: E402

LATTICE = """
[sweep]
geometry   = "lattice"
rows       = 2
columns    = 3
side_walls = ["periodic", "fixed"]
epsilon    = 0.9
v0         = 0.2
tc         = 7e-6
s0         = 1e-6
width      = 1e-4
[trajectory]
samples = 41
duration = 6e-4
"""
SAMPLES, BEADS = 41, 6


class Films(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.sweep = Sweep(LATTICE)
        assert cls.sweep.run(0).code == 0
        for form in ("lammps", "xyz", "vtk"):
            cls.export(form)

    @classmethod
    def export(cls, *arguments):
        ended = subprocess.run([PROGRAM, "export", "table.h5", "--films", arguments[0], "-o",
                                *(arguments[1:] or [arguments[0]])],
                               cwd=cls.sweep.path, capture_output=True, text=True, timeout=60)
        return ended

    def recorded(self, row, element):
        with h5py.File(self.sweep.path / f"table.trajectories/row-{row:06}.h5") as file:
            return file[f"particles/beads/{element}"][:]

    def names(self, directory):
        return sorted(path.name for path in (self.sweep.path / directory).iterdir())

    def test_lammps_by_mdanalysis(self):
        import MDAnalysis
        self.assertEqual(self.names("lammps"), ["row-000000.contacts.lammpstrj", "row-000000.lammpstrj",
                                                "row-000001.contacts.lammpstrj", "row-000001.lammpstrj"])
        for row in range(2):
            universe = MDAnalysis.Universe(str(self.sweep.path / f"lammps/row-{row:06}.lammpstrj"), format="LAMMPSDUMP",
                                           topology_format="LAMMPSDUMP")
            self.assertEqual((universe.trajectory.n_frames, len(universe.atoms)), (SAMPLES, BEADS))
            for sample in (0, 7, SAMPLES - 1):
                found = universe.trajectory[sample].positions
                # MDAnalysis shifts positions to the box's corner.
                expected = self.recorded(row, "position/value")[sample]
                numpy.testing.assert_allclose(found - found[0], expected - expected[0], atol=1e-9)

    def test_lammps_contacts(self):
        text = (self.sweep.path / "lammps/row-000001.contacts.lammpstrj").read_text()
        frames = text.split("ITEM: TIMESTEP\n")[1:]
        self.assertEqual(len(frames), SAMPLES)
        contacts = [line.split() for frame in frames
                    for line in frame.split("ITEM: ENTRIES i j overlap fx fy fz\n")[1].splitlines()]
        self.assertGreater(len(contacts), 5)
        for i, j, overlap, *_ in contacts:
            self.assertTrue(1 <= int(i) <= BEADS and 0 <= int(j) <= BEADS and int(i) != int(j))
            self.assertGreater(float(overlap), 0)

    @unittest.skipUnless(importlib.util.find_spec("ase"), "ASE is not installed")
    def test_xyz_by_ase(self):
        import ase.io
        for row in range(2):
            frames = ase.io.read(self.sweep.path / f"xyz/row-{row:06}.xyz", index=":")
            self.assertEqual(len(frames), SAMPLES)
            for sample in (0, 7, SAMPLES - 1):
                frame = frames[sample]
                numpy.testing.assert_array_equal(frame.positions, self.recorded(row, "position/value")[sample])
                numpy.testing.assert_array_equal(frame.arrays["velo"], self.recorded(row, "velocity/value")[sample])
                numpy.testing.assert_array_equal(2 * frame.arrays["radius"], self.recorded(row, "diameter"))
                self.assertEqual(list(frame.pbc), [row == 0, False, False])

    def test_xyz(self):
        lines = (self.sweep.path / "xyz/row-000000.xyz").read_text().splitlines()
        self.assertEqual(len(lines), SAMPLES * (BEADS + 2))
        self.assertEqual(lines[0], str(BEADS))
        found = numpy.array([line.split()[1:4] for line in lines[-BEADS:]], dtype=float)
        numpy.testing.assert_array_equal(found, self.recorded(0, "position/value")[-1])

    def test_vtk(self):
        pvd = xml.etree.ElementTree.parse(self.sweep.path / "vtk/row-000000.pvd")
        files = [entry.get("file") for entry in pvd.iter("DataSet")]
        self.assertEqual([float(entry.get("timestep")) for entry in pvd.iter("DataSet")],
                         list(self.recorded(0, "position/time")))
        piece = xml.etree.ElementTree.parse(self.sweep.path / "vtk" / files[7]).find("PolyData/Piece")
        points = numpy.array(piece.find("Points/DataArray").text.split(), dtype=float).reshape(-1, 3)
        numpy.testing.assert_array_equal(points, self.recorded(0, "position/value")[7])

    @unittest.skipUnless(importlib.util.find_spec("vtk"), "VTK is not installed")
    def test_vtk_by_itself(self):
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy
        lines = 0
        for sample in range(SAMPLES):
            reader = vtk.vtkXMLPolyDataReader()
            reader.SetFileName(str(self.sweep.path / f"vtk/row-000001/{sample:05}.vtp"))
            reader.Update()
            data = reader.GetOutput()
            self.assertEqual((data.GetNumberOfPoints(), data.GetNumberOfVerts()), (BEADS, BEADS))
            lines += data.GetNumberOfLines()
            overlap = vtk_to_numpy(data.GetCellData().GetArray("overlap"))
            self.assertEqual(len(overlap), BEADS + data.GetNumberOfLines())
            self.assertTrue((overlap[BEADS:] > 0).all())
        self.assertGreater(lines, 1)

    def test_what_cannot_be(self):
        for arguments, code, words in ((("xyz", "-"), 64, "needs a directory"), (("xyz", "table.h5"), 73, "table.h5"),
                                       (("pdb", "x"), 64, "lammps")):
            ended = self.export(*arguments)
            self.assertEqual(ended.returncode, code, ended)
            self.assertIn(words, ended.stderr)
        plain = Sweep(LATTICE.split("[trajectory]")[0])
        self.assertEqual(plain.run(0).code, 0)
        ended = subprocess.run([PROGRAM, "export", "table.h5", "--films", "xyz", "-o", "x"], cwd=plain.path,
                               capture_output=True, text=True, timeout=60)
        self.assertEqual(ended.returncode, 64, ended)
        self.assertIn("no table [trajectory]", ended.stderr)


if __name__ == "__main__":
    unittest.main()
