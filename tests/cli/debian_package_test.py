"""The package of Debian that cpack makes: unpacked, it runs, and has all that belongs to the program."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import PROGRAM  # noqa: E402

BUILD = pathlib.Path(PROGRAM).parent
TOOLS = ("cpack", "dpkg-deb", "dpkg-shlibdeps", "file")


@unittest.skipUnless(all(map(shutil.which, TOOLS)), "one of " + ", ".join(TOOLS) + " is not installed")
class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        directory = tempfile.TemporaryDirectory()
        cls.addClassCleanup(directory.cleanup)
        cls.root = pathlib.Path(directory.name)
        made = subprocess.run(["cpack", "-G", "DEB", "--config", BUILD / "CPackConfig.cmake", "-B", cls.root / "made"],
                              capture_output=True, text=True, cwd=BUILD)
        assert made.returncode == 0, made
        (cls.package,) = (cls.root / "made").glob("*.deb")
        subprocess.run(["dpkg-deb", "-x", cls.package, cls.root / "unpacked"], check=True)

    def test_what_it_needs(self):
        control = subprocess.run(["dpkg-deb", "-f", self.package], capture_output=True, text=True, check=True).stdout
        self.assertRegex(control, r"(?m)^Package: sigmasweep$")
        for needed in ("openmpi-bin", "gnuplot", "libhdf5-openmpi", "libboost-mpi"):
            self.assertIn(needed, control)

    def test_what_it_has(self):
        for name in ("bin/sigmasweep", "share/sigmasweep/sigmasweep.schema.json", "share/sigmasweep/sweeps/fig2a.toml",
                     "share/sigmasweep/slurm/sweep.sbatch", "share/bash-completion/completions/sigmasweep",
                     "share/zsh/site-functions/_sigmasweep", "share/doc/sigmasweep/copyright",
                     "share/doc/sigmasweep/docs/spec.md"):
            self.assertTrue((self.root / "unpacked/usr" / name).is_file(), name)
        self.assertTrue(os.access(self.root / "unpacked/usr/share/sigmasweep/slurm/sweep.sbatch", os.X_OK))
        self.assertFalse((self.root / "unpacked/usr/include").exists())

    def test_it_runs(self):
        program = self.root / "unpacked/usr/bin/sigmasweep"
        ran = subprocess.run([program, "run", self.root / "unpacked/usr/share/sigmasweep/sweeps/fig2c.toml", "-o", "t.h5"],
                             capture_output=True, text=True, cwd=self.root)
        self.assertEqual(ran.returncode, 0, ran)
        shown = subprocess.run([program, "show", "t.h5"], capture_output=True, text=True, cwd=self.root)
        self.assertRegex(shown.stdout, re.compile(r"t\.h5: \d+ rows \(ok"))


if __name__ == "__main__":
    unittest.main()
