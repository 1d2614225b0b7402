"""Runs on a full file system: a small tmpfs that is mounted for this process and its children only. The test is skipped
(exit 77) where mounting is not allowed."""

import ctypes
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

from sweep_process import Sweep, spec

QUICK = spec(steps=20)
CLONE_NEWNS, CLONE_NEWUSER = 0x00020000, 0x10000000


def own_mounts():
    """Gives this process mounts of its own; False where that is not allowed."""
    flags = CLONE_NEWNS | (CLONE_NEWUSER if os.getuid() else 0)
    uid, gid = os.getuid(), os.getgid()
    if ctypes.CDLL(None).unshare(flags) != 0:
        return False
    if flags & CLONE_NEWUSER:
        for name, text in (("setgroups", "deny"), ("uid_map", f"0 {uid} 1"), ("gid_map", f"0 {gid} 1")):
            with open(f"/proc/self/{name}", "w") as file:
                file.write(text)
    with tempfile.TemporaryDirectory() as place:
        tries = (["mount", "--make-rprivate", "/"], ["mount", "-t", "tmpfs", "none", place], ["umount", place])
        return all(subprocess.run(each, capture_output=True).returncode == 0 for each in tries)


class FullDisk(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = Sweep(QUICK)
        assert cls.whole.run(0).code == 0
        cls.table_size = cls.whole.table.stat().st_size

    def disk(self, size):
        sweep = Sweep(QUICK)
        sweep.table = sweep.path / "disk" / "table.h5"
        sweep.journal = sweep.path / "disk" / "table.h5.journal"
        sweep.table.parent.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "none", str(sweep.table.parent)], check=True)
        self.addCleanup(self.unmount, sweep)
        return sweep

    def unmount(self, sweep):
        subprocess.run(["umount", str(sweep.table.parent)], check=True)

    def check(self, size, words, ranks):
        """Number of rows that were kept when the disk was full."""
        sweep = self.disk(size)
        ended = sweep.run(ranks)
        self.assertIn(ended.code, (73, 74), ended)
        self.assertEqual(ended.err.count("No space left on device"), 1, ended)
        self.assertEqual(ended.err.count(words), 1, ended)
        self.assertFalse(sweep.table.exists())
        kept = sweep.journalled()
        self.assertNotEqual(sweep.run(ranks).code, 0)
        self.assertEqual({row: sweep.journalled().get(row) for row in kept}, kept)
        subprocess.run(["mount", "-o", "remount,size=4M", str(sweep.table.parent)], check=True)
        kept = sweep.journalled()
        ended = sweep.run(ranks)
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(sweep.results(), self.whole.results())
        run_time = sweep.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")
        return len(kept)

    def test_journal_does_not_fit(self):
        for ranks in (0, 2):
            self.assertLess(self.check("40k", "table.h5.journal", ranks), 360)

    def test_table_does_not_fit(self):
        """The first size has room for the journal, the run's notes and half of the table, the second for no table."""
        for ranks in (0, 2):
            notes = 4096 * (1 + max(ranks, 1))
            for room in (self.table_size // 2, 4096):
                size = self.journal_size() + notes + room
                self.assertEqual(self.check(str(size), "table.h5: no room for", ranks), 360)

    def journal_size(self):
        sweep = Sweep(QUICK)
        sweep.run(0, env=dict(os.environ, LD_PRELOAD=os.environ["FAILING_CALLS"], FAIL_CALL="H5Fcreate", FAIL_AT="1",
                              FAIL_ERRNO="5", FAIL_PATH=""))
        return sweep.journal.stat().st_size

    def test_nothing_fits(self):
        sweep = self.disk("4k")
        (sweep.table.parent / "full").write_bytes(bytes(4096))
        for ranks in (0, 2):
            ended = sweep.run(ranks)
            self.assertEqual(ended.code, 73, ended)
            self.assertEqual(ended.err.count("No space left on device"), 1, ended)


if __name__ == "__main__":
    if not shutil.which("mount") or not own_mounts():
        print("mounting is not allowed here")
        sys.exit(77)
    unittest.main(verbosity=2)
