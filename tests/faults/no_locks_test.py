"""File systems without locks: a file keeps other runs away, with a warning, and that of a dead run is recognised."""

import errno
import os
import signal
import time
import unittest

from sweep_process import Sweep, end_of, ranks_of, spec

QUICK = spec(steps=20)


def without_locks(number=errno.ENOSYS):
    return dict(os.environ, LD_PRELOAD=os.environ["NO_LOCKS"], NO_LOCKS_ERRNO=str(number))


class NoLocks(unittest.TestCase):
    def test_a_run_goes_on_with_a_warning(self):
        expected = Sweep(QUICK)
        self.assertEqual(expected.run(0).code, 0)
        for ranks, number in ((0, errno.ENOSYS), (0, errno.ENOLCK), (2, errno.EOPNOTSUPP)):
            sweep = Sweep(QUICK)
            ended = sweep.run(ranks, env=without_locks(number))
            self.assertEqual(ended.code, 0, ended)
            self.assertEqual(ended.err.count("this file system has no locks"), 1, ended)
            self.assertEqual(sweep.results(), expected.results())
            self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def test_two_runs_on_one_table(self):
        sweep = Sweep()
        first = sweep.start(2, env=without_locks())
        sweep.wait_for_rows(first)
        manager = ranks_of(first)[0]
        os.kill(manager, signal.SIGSTOP)
        try:
            for ranks, options in ((0, []), (2, ["--fresh"])):
                second = sweep.run(ranks, *options, env=without_locks())
                self.assertEqual(second.code, 73, second)
                self.assertEqual(second.err.count("another run is working on"), 1, second)
                self.assertIn(f"process {manager} on ", second.err)
        finally:
            os.kill(manager, signal.SIGCONT)
        ended = end_of(first)
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def killed(self):
        sweep = Sweep()
        process = sweep.start(0, env=without_locks())
        sweep.wait_for_rows(process)
        process.kill()
        end_of(process)
        self.assertIn("table.h5.owner", sweep.files())
        return sweep, sweep.path / "table.h5.owner"

    def test_a_dead_process_of_this_machine_owns_nothing(self):
        sweep, _ = self.killed()
        ended = sweep.run(0, env=without_locks())
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def test_of_another_machine_the_file_is_touched_while_it_lives(self):
        sweep, owner = self.killed()
        data = bytearray(owner.read_bytes())
        data[24] ^= 1  # the machine's name for its start
        owner.write_bytes(data)
        ended = sweep.run(0, env=without_locks())
        self.assertEqual(ended.code, 73, ended)
        self.assertIn("another run is working on", ended.err)
        os.utime(owner, (time.time() - 150,) * 2)
        ended = sweep.run(0, env=without_locks())
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def test_a_torn_file_counts_as_fresh_until_it_is_old(self):
        sweep = Sweep(QUICK)
        owner = sweep.path / "table.h5.owner"
        owner.write_bytes(b"SSS")
        self.assertEqual(sweep.run(0, env=without_locks()).code, 73)
        os.utime(owner, (time.time() - 150,) * 2)
        self.assertEqual(sweep.run(0, env=without_locks()).code, 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
