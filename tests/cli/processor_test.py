"""What the processor has to have. Where qemu-x86_64 is installed, the program under processors that are not here."""

import os
import pathlib
import shutil
import subprocess
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import PROGRAM  # noqa: E402

QEMU = os.environ.get("QEMU") or shutil.which("qemu-x86_64")
TUPLES = ["one", "--v0", "1", "--tc", "1e-5", "--epsilon", "0.9", "--N", "10", "--json", "--sigma"]


def run(*command):
    return subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=100)


def own_lines(ended):
    """What the program itself, not qemu, wrote to standard error."""
    return "\n".join(line for line in ended.stderr.splitlines() if not line.startswith("qemu-x86_64:"))


@unittest.skipUnless(QEMU, "qemu-x86_64 is not installed")
class OtherProcessors(unittest.TestCase):
    def test_an_old_one_gets_one_line(self):
        ended = run(QEMU, "-cpu", "Nehalem", PROGRAM, "--version")
        self.assertEqual((ended.returncode, ended.stdout), (69, ""), ended)
        self.assertRegex(own_lines(ended), r"\Asigmasweep: this processor lacks AVX2[^\n]*\Z")

    def test_one_without_avx512_gives_the_same_bits(self):
        for sigma in "0", "0.3", "3":
            there, here = run(QEMU, "-cpu", "Haswell", PROGRAM, *TUPLES, sigma), run(PROGRAM, *TUPLES, sigma)
            if there.returncode == 69 and "built for processors with AVX-512" in own_lines(there):
                self.skipTest("a build with SIGMASWEEP_ARCH=native, on a processor with AVX-512")
            self.assertEqual((there.returncode, there.stdout), (0, here.stdout), there)


class Objects(unittest.TestCase):
    def test_code_for_avx512_is_called_by_nothing_else(self):
        """Functions that other sources compile, too, are one in the program: it might be the wrong one."""
        library = pathlib.Path(PROGRAM).parent / "src/solve/libsigmasweep_solve.a"
        object_name, own, shared = "", 0, []
        for line in run("nm", "-C", "--defined-only", library).stdout.splitlines():
            if line.endswith(".o:"):
                object_name = line
            elif object_name in ("advance_8.cpp.o:", "jump_8.cpp.o:") and line[17:18] in ("T", "W", "V", "u"):
                own += 1
                if "side_by_side" not in line:
                    shared.append(line)
        self.assertGreater(own, 0)
        self.assertEqual(shared, [])


if __name__ == "__main__":
    unittest.main()
