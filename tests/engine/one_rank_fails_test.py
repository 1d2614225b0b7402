"""What goes wrong on one rank alone, anywhere in what the ranks do together, ends all with one clear message."""

import concurrent.futures
import errno
import os
import pathlib
import signal
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "faults"))
from sweep_process import Sweep, end_of, failing, ranks_of, spec  # noqa: E402

QUICK = spec(steps=20)


class OneRankFails(unittest.TestCase):
    def check(self, code, words, rank, **how):
        """The journal's rows when it failed."""
        sweep = Sweep(QUICK)
        start = time.monotonic()
        ended = sweep.run(2, env=failing(rank=rank, **how))
        self.assertEqual(ended.code, code, ended)
        self.assertEqual(ended.err.count(words), 1, ended)
        self.assertLess(time.monotonic() - start, 60)
        self.assertFalse(sweep.table.exists())
        kept = sweep.finish_keeping_rows()
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])
        return kept

    def test_leaves_a_collective_call_early(self):
        """The others are still in it: only the rank that failed can end them, and waits half a minute before."""
        cases = [("H5Fcreate", 1, "rank 1: cannot create"), ("H5Dwrite", 0, "rank 0: cannot write dataset results"),
                 ("H5Dwrite", 1, "rank 1: cannot write dataset results"), ("H5Fflush", 1, "rank 1: cannot sync")]
        with concurrent.futures.ThreadPoolExecutor(len(cases) + 1) as pool:
            ended = [pool.submit(self.check, 74, words, rank, call=call) for call, rank, words in cases]
            hangs = pool.submit(self.check_other_hangs)  # the same half a minute
        for case in ended:
            self.assertEqual(len(case.result()), 360)
        hangs.result()

    def check_other_hangs(self):
        """The manager has said what is wrong with the spec; at its end MPI would wait for a rank that never comes."""
        sweep = Sweep(QUICK)
        sweep.spec.unlink()
        os.mkfifo(sweep.spec)  # the manager waits for its spec, and the other rank for the manager
        process = sweep.start(2)
        with open(sweep.spec, "w") as spec_file:
            os.kill(ranks_of(process)[1], signal.SIGSTOP)
            start = time.monotonic()
            spec_file.write("nonsense = 1\n")
        ended = end_of(process)
        self.assertEqual(ended.code, 65, ended)
        self.assertEqual(ended.err.count("unknown key nonsense"), 1, ended)
        self.assertGreater(time.monotonic() - start, 29, "nobody waited: this tests nothing")
        self.assertLess(time.monotonic() - start, 60)
        self.assertEqual(sweep.files(), ["sweep.toml"])

    def test_does_not_see_the_directory(self):
        kept = self.check(73, "rank 1 does not find", 1, call="open to read", path="table.h5.running", on=True,
                          number=errno.ENOENT)
        self.assertEqual(kept, {}, "it was found out too late")

    def test_cannot_write_in_the_directory(self):
        kept = self.check(73, "rank 1 cannot write", 1, call="open to write", path="table.h5.running",
                          number=errno.EROFS)
        self.assertEqual(kept, {}, "it was found out too late")

    def test_loses_the_directory_meanwhile(self):
        kept = self.check(73, "rank 1 cannot open", 1, call="open to write", path="table.h5.part", on=True,
                          number=errno.ESTALE)
        self.assertEqual(len(kept), 360)


if __name__ == "__main__":
    unittest.main(verbosity=2)
