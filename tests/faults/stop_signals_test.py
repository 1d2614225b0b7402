"""SIGTERM, SIGINT and SIGUSR1 stop a run: it ends with exit code 75, keeps all finished rows, and the next run goes
on."""

import os
import signal
import unittest

from sweep_process import Sweep, end_of, ranks_of, spec

LONG = spec(steps=8000)  # long enough for a signal before the end on a busy machine
SIGNALS = [signal.SIGTERM, signal.SIGINT, signal.SIGUSR1]


class StopSignals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = Sweep(LONG)
        ended = cls.whole.run(2)
        assert ended.code == 0, ended
        cls.results = cls.whole.results()
        cls.rows = len(cls.whole.timings())

    def check_kept_and_resumed(self, sweep):
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
        for rank in range(3):
            for number in SIGNALS:
                with self.subTest(rank=rank, signal=number):
                    sweep = Sweep(LONG)
                    process = sweep.start(3)
                    sweep.wait_for_rows(process)
                    os.kill(ranks_of(process)[rank], number)
                    ended = end_of(process)
                    self.assertEqual(ended.code, 75, ended)
                    self.assertFalse(sweep.table.exists())
                    self.assertGreater(len(sweep.journalled()), 0)

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
