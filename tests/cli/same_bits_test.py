"""tests/same_bits/compare finds that a program gives the same bits as itself, and sees another result."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(os.environ["SIGMASWEEP"])
COMPARE = pathlib.Path(__file__).parents[1] / "same_bits" / "compare"


def compare(before, after, *options):
    return subprocess.run([sys.executable, "-B", COMPARE, "--before", before, "--after", after, "--tuples", "20", *options],
                          capture_output=True, text=True, timeout=280)


class SameBits(unittest.TestCase):
    def test_a_program_against_itself(self):
        ended = compare(PROGRAM, PROGRAM)
        self.assertEqual(ended.returncode, 0, ended)
        self.assertIn("the same to the bit", ended.stdout)

    def test_one_contact_more_is_seen(self):
        with tempfile.TemporaryDirectory(prefix="sigmasweep-") as directory:
            other = pathlib.Path(directory) / "sigmasweep"
            other.write_text(f"""#!/bin/sh
'{PROGRAM}' "$@" | sed 's/"contacts": */&1/'
""")
            other.chmod(0o755)
            ended = compare(PROGRAM, other, "--no-tables")
        self.assertEqual(ended.returncode, 1, ended)
        self.assertIn("DIFFERENT contacts", ended.stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
