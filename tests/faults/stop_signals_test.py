"""Signals from outside stop a run on purpose: it ends with exit code 75, keeps all finished rows and blames none of the
others, and the next run goes on. A closed terminal, or a pipe that nobody reads, is no error."""

import fcntl
import os
import pty
import signal
import subprocess
import termios
import unittest

from sweep_process import LIMIT, Sweep, end_of, ranks_of, spec, wait_until_caught, wait_until_unlocked

# A test suite that runs in the background ignores these, and would hand that on.
for number in (signal.SIGINT, signal.SIGQUIT, signal.SIGHUP):
    signal.signal(number, signal.SIG_DFL)

LONG = spec(steps=8000)  # long enough for a signal before the end on a busy machine
SIGNALS = [signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGQUIT, signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU,
           signal.SIGPIPE]


class StopSignals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = Sweep(LONG)
        ended = cls.whole.run(2)
        assert ended.code == 0, ended
        cls.results = cls.whole.results()
        cls.rows = len(cls.whole.timings())

    def check_kept_and_resumed(self, sweep):
        self.assertEqual(sweep.files(), ["sweep.toml", "table.h5.journal"], "something is held against a row")
        self.assertFalse(sweep.table.exists())
        kept = sweep.journalled()
        self.assertGreater(len(kept), 0)
        self.assertLess(len(kept), self.rows)
        ended = sweep.run(3)
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(sweep.results(), self.results)
        run_time = sweep.timings()["run_time"]
        self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")

    def test_alone(self):
        for number in SIGNALS:
            with self.subTest(signal=number):
                sweep = Sweep(LONG)
                process = sweep.start(0)
                sweep.wait_for_rows(process)
                process.send_signal(number)
                ended = end_of(process)
                self.assertEqual(ended.code, 75, ended)
                self.assertEqual(ended.err.count("run it again to go on"), 1, ended)
                self.check_kept_and_resumed(sweep)

    def test_usr1_to_mpirun_reaches_all_ranks(self):
        sweep = Sweep(LONG)
        process = sweep.start(3)
        sweep.wait_for_rows(process)
        process.send_signal(signal.SIGUSR1)
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        self.assertEqual(ended.err.count("run it again to go on"), 1, ended)
        self.check_kept_and_resumed(sweep)

    def test_any_rank_alone(self):
        for k, number in enumerate(SIGNALS):
            for rank in range(3) if number == signal.SIGTERM else [k % 3]:
                with self.subTest(rank=rank, signal=number):
                    sweep = Sweep(LONG)
                    process = sweep.start(3)
                    sweep.wait_for_rows(process)
                    os.kill(ranks_of(process)[rank], number)
                    ended = end_of(process)
                    self.assertEqual(ended.code, 75, ended)
                    self.assertGreater(len(sweep.journalled()), 0)
                    self.assertEqual(sweep.files(), ["sweep.toml", "table.h5.journal"])

    def test_before_mpi_is_there(self):
        """As soon as a process can be told to stop at all, it stops as it should."""
        for ranks in (0, 2):
            sweep = Sweep(LONG)
            process = sweep.start(ranks)
            wait_until_caught(process, ranks, signal.SIGUSR1)
            process.send_signal(signal.SIGUSR1)
            ended = end_of(process)
            self.assertEqual(ended.code, 75, ended)

    def test_terminal_closed(self):
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                sweep = Sweep(spec(steps=20000))
                terminal, inside = pty.openpty()
                process = subprocess.Popen(sweep.command(ranks), stdin=inside, stdout=inside, stderr=inside,
                                           start_new_session=True,
                                           preexec_fn=lambda: fcntl.ioctl(0, termios.TIOCSCTTY, 0))
                os.close(inside)
                sweep.wait_for_rows(process)
                os.close(terminal)
                code = process.wait(LIMIT)
                self.assertNotEqual(code, 0)
                if not ranks:
                    self.assertEqual(code, 75)
                wait_until_unlocked(sweep)
                self.assertGreater(len(sweep.journalled()), 0)
                if not ranks:
                    self.assertEqual(sweep.files(), ["sweep.toml", "table.h5.journal"])
                ended = sweep.run(2, "--max-time", "0.5")
                self.assertIn("going on with", ended.err)

    def test_nobody_reads_what_is_printed(self):
        """sigmasweep run 2>&1 | head"""
        for ranks in (0, 2):
            for closed in ("stderr", "stdout"):
                with self.subTest(ranks=ranks, closed=closed):
                    sweep = Sweep(spec(steps=500))
                    process = sweep.start(ranks)
                    getattr(process, closed).close()
                    self.assertEqual(process.wait(LIMIT), 0)
                    process.stdout.close()
                    process.stderr.close()
                    self.assertEqual(len(sweep.timings()), 360)
                    self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])

    def test_nohup(self):
        sweep = Sweep(spec(steps=1000))
        process = sweep.start(0, preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
        sweep.wait_for_rows(process)
        process.send_signal(signal.SIGHUP)
        ended = end_of(process)
        self.assertEqual(ended.code, 0, ended)

    def test_mpirun_terminated(self):
        """Finished rows are kept when mpirun is terminated. It passes the signal on after a second, kills the ranks
        after another, and has its own exit code."""
        for number in (signal.SIGTERM, signal.SIGINT):
            with self.subTest(signal=number):
                sweep = Sweep(spec(steps=20000))  # much longer than a second
                process = sweep.start(3)
                sweep.wait_for_rows(process)
                process.send_signal(number)
                ended = end_of(process)
                self.assertNotEqual(ended.code, 0, ended)
                self.assertFalse(sweep.table.exists(), ended)
                kept = sweep.journalled()
                self.assertGreater(len(kept), 0)
                ended = sweep.run(2, "--max-seconds", "0.5")
                self.assertEqual(ended.code, 75, ended)
                self.assertIn(f"going on with {len(kept)} of", ended.err)
                self.assertEqual({row: sweep.journalled().get(row) for row in kept}, kept, "rows were lost")


if __name__ == "__main__":
    unittest.main(verbosity=2)
