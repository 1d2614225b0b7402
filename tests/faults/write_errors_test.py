"""A run survives the failure of any write, sync, rename, truncation or reservation of space: it ends with exit code 73
or 74 and the name of the file, stored rows stay readable, and the next run goes on. WRITE_ERRORS=all tries every call
of each kind."""

import concurrent.futures
import errno
import os
import unittest

from sweep_process import Sweep, failing, spec

ALL = os.environ.get("WRITE_ERRORS") == "all"
QUICK = spec(steps=20).replace("count = 15", "count = 3")  # 72 rows
MOST = 200  # largest number of calls of a kind
AT_ONCE, BATCH = 3, 12  # a run mostly waits for MPI to begin and end


class WriteErrors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = Sweep(QUICK)
        ended = cls.whole.run(2)
        assert ended.code == 0, ended
        cls.results = cls.whole.results()

    def check(self, ranks, **how):
        """Whether the failure occurred."""
        sweep = Sweep(QUICK)
        ended = sweep.run(ranks, env=failing(**{"path": "table.h5", **how}))
        if ended.code != 0:
            self.assertIn(ended.code, (73, 74), ended)
            self.assertIn("table.h5", ended.err)
            self.assertFalse(sweep.table.exists())
            sweep.finish_keeping_rows()
        self.assertEqual(sweep.results(), self.results)
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])
        return ended.code != 0

    def sweep_over(self, ranks, samples, **how):
        """Number of failures that occurred in the calls `samples`, or in all calls of this kind."""
        came, numbers = 0, range(1, MOST) if ALL else samples
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            for first in range(0, len(numbers), BATCH):
                batch = numbers[first:first + BATCH]
                ended = [(at, pool.submit(self.check, ranks, at=at, **how)) for at in batch]
                before = came
                for at, check in ended:
                    with self.subTest(at=at, **how):
                        came += check.result()
                if came == before:
                    break
        print(f"{came} failures of {how}", flush=True)
        return came

    def test_writes(self):
        for path, samples in ((".journal", [1, 2, 3, 4]), (".part", [1, 5])):
            self.assertGreater(self.sweep_over(0, samples, call="write", path=path, number=errno.ENOSPC), 0)

    def test_disk_stays_full(self):
        for ranks in (0, 2):
            self.assertTrue(self.check(ranks, call="write", at=3, number=errno.ENOSPC, path=".journal", on=True))
            self.assertTrue(self.check(ranks, call="write", at=2, number=errno.ENOSPC, path="table.h5.part", on=True))

    def test_another_rank_cannot_write(self):
        self.check(2, call="write", at=1, number=errno.EIO, path="table.h5.part", on=True, rank=1)

    def test_syncs(self):
        self.assertGreater(self.sweep_over(0, [1, 2], call="fdatasync", number=errno.EIO), 0)
        self.assertGreater(self.sweep_over(0, [1, 2, 3], call="fsync", number=errno.EIO, path="table.h5"), 0)

    def test_renames_and_space(self):
        self.assertGreater(self.sweep_over(0, [1, 2, 3], call="rename", number=errno.EIO), 0)
        self.assertGreater(self.sweep_over(0, [1, 2], call="posix_fallocate", number=errno.ENOSPC), 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
