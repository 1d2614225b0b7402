"""The README's sweep, commands and Python lines do what it says."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(os.environ["SIGMASWEEP"])
README = (pathlib.Path(__file__).parents[2] / "README.md").read_text()


def blocks(language):
    return re.findall(rf"^```{language}\n(.*?)^```", README, re.MULTILINE | re.DOTALL)


def commands():
    """Those of the program and of h5dump, but for the ones that need a cluster."""
    lines = [line.strip() for line in re.findall(r"^    (.*)$", README, re.MULTILINE) + blocks("sh")[0].splitlines()]
    return [line for line in lines if re.match(r"(mpirun )?(sigmasweep|h5dump) ", line)]


class Readme(unittest.TestCase):
    def setUp(self):
        directory = tempfile.TemporaryDirectory(prefix="sigmasweep-")
        self.addCleanup(directory.cleanup)
        self.path = pathlib.Path(directory.name)
        self.environment = dict(os.environ, PATH=f"{PROGRAM.parent}:{os.environ['PATH']}")

    def execute(self, command, **options):
        ended = subprocess.run(command, cwd=self.path, env=self.environment, capture_output=True, text=True,
                               timeout=100, **options)
        self.assertEqual(ended.returncode, 0, ended)
        return ended.stdout

    def test_commands_in_their_order(self):
        (spec,) = blocks("toml")
        (self.path / "beads.toml").write_text(spec)
        self.assertGreaterEqual(len(commands()), 6)
        for command in commands():
            self.execute(command, shell=True)
        self.assertTrue({"beads.h5", "beads.png", "beads.csv"} <= {entry.name for entry in self.path.iterdir()})
        (script,) = blocks("python")
        printed = self.execute([sys.executable, "-c", script])
        self.assertIn("0.01", printed)


if __name__ == "__main__":
    unittest.main(verbosity=2)
