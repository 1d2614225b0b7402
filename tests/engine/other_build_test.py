"""Ranks that run different builds of the program, as on hosts that were not all updated, notice it at the start."""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import MPIEXEC, PROGRAM, Sweep, spec  # noqa: E402


class OtherBuilds(unittest.TestCase):
    def other_build(self, path):
        """The program with another compiler in its description."""
        version = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, timeout=60).stdout
        compiler = next(line.split()[1:3] for line in version.splitlines() if line.startswith("compiler"))
        old = " ".join(compiler).encode()
        data = pathlib.Path(PROGRAM).read_bytes()
        self.assertGreater(data.count(old + b"\0"), 0, compiler)
        other = path / "other"
        other.write_bytes(data.replace(old + b"\0", old[:-1] + b"?\0"))
        shutil.copymode(PROGRAM, other)
        return other

    def test_they_are_refused_before_anything_is_written(self):
        sweep = Sweep(spec(steps=20))
        other = self.other_build(sweep.path)
        run = ["run", str(sweep.spec), "-o", str(sweep.table)]
        command = [*MPIEXEC, "-n", "2", PROGRAM, *run, ":", "-n", "1", str(other), *run]
        ended = subprocess.run(command, capture_output=True, text=True, timeout=60, cwd=sweep.path, stdin=subprocess.DEVNULL)
        self.assertEqual(ended.returncode, 64, ended)
        self.assertEqual(ended.stderr.count("rank 2 runs another build of the program than rank 0"), 1, ended)
        os.remove(other)
        self.assertEqual(sweep.files(), ["sweep.toml"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
