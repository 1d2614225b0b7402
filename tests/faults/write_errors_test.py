"""Every write, sync, rename, truncation and reservation of space fails once: exit 73 or 74 with the file's name, what
was stored stays readable, and the run goes on when there is room again. WRITE_ERRORS=all tries every call of each
kind."""

import errno
import os
import unittest

from sweep_process import Sweep, failing, spec

ALL = os.environ.get("WRITE_ERRORS") == "all"
QUICK = spec(steps=20)
MOST = 400 if ALL else 0


class WriteErrors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = Sweep(QUICK)
        ended = cls.whole.run(2)
        assert ended.code == 0, ended
        cls.results = cls.whole.results()

    def check(self, ranks, **how):
        """Whether the failure came to pass."""
        sweep = Sweep(QUICK)
        ended = sweep.run(ranks, env=failing(**{"path": "table.h5", **how}))
        if ended.code != 0:
            self.assertIn(ended.code, (73, 74), ended)
            self.assertIn("table.h5", ended.err)
            self.assertFalse(sweep.table.exists())
            kept = sweep.journalled()
            again = sweep.run(2)
            self.assertEqual(again.code, 0, again)
            run_time = sweep.timings()["run_time"]
            self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")
        self.assertEqual(sweep.results(), self.results)
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])
        return ended.code != 0

    def sweep_over(self, ranks, samples, **how):
        came = 0
        for at in range(1, MOST) if ALL else samples:
            with self.subTest(at=at, **how):
                failed = self.check(ranks, at=at, **how)
                came += failed
                if ALL and not failed and at > 3:
                    break
        return came

    def test_writes(self):
        for path, samples in ((".journal", [1, 2, 50, 361]), (".part", [1, 5])):
            self.assertGreater(self.sweep_over(0, samples, call="write", path=path, number=errno.ENOSPC), 0)

    def test_disk_stays_full(self):
        for ranks in (0, 2):
            self.assertTrue(self.check(ranks, call="write", at=100, number=errno.ENOSPC, path=".journal", on=True))
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
