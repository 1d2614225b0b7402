"""A rank that does not answer, because it is stopped (SIGSTOP stands for a lost host and a stuck file system, too), holds up
no run for ever: half a minute after a stop or the end of --max-time it is named and given up, with exit code 75.

SILENT_TRIALS=30 SILENT_SEED=1 run the long tier: ctest -R silent_rank.
"""

import concurrent.futures
import os
import random
import re
import signal
import time
import unittest

from long_tuple_test import LONG, LONG_ROW, start_long_rows
from sweep_process import Sweep, at_once, end_of, failing, ranks_of, spec, wait_until_caught

TRIALS = int(os.environ.get("SILENT_TRIALS", "4"))
AT_ONCE = 4  # they mostly wait
TEXT = spec(steps=4000)
WITHIN = 60  # s, from the stop to the end


class Trial:
    """Stops a rank at a random moment, then, a moment later, the run."""

    def __init__(self, test, seed):
        self.test, self.random = test, random.Random(seed)
        self.sweep = Sweep(TEXT)

    def __call__(self):
        ranks = self.random.randint(2, 4)
        by_time = self.random.random() < 0.3
        options = ["--max-time", f"{self.random.uniform(1, 4):.2f}"] if by_time else []
        start = time.monotonic()
        process = self.sweep.start(ranks, *options)
        wait_until_caught(process, ranks, signal.SIGUSR1)
        # Half of them while MPI begins and in the first moments, half in the midst of the rows.
        time.sleep(self.random.choice([self.random.uniform(0.0, 0.7), self.random.uniform(0.7, 3.0)]))
        self.silent = self.random.randrange(ranks)
        pids = ranks_of(process)
        if len(pids) == ranks:
            os.kill(pids[self.silent], signal.SIGSTOP)
        if not by_time:
            time.sleep(self.random.uniform(0.0, 0.5))
            process.send_signal(signal.SIGUSR1)
        stop = time.monotonic()
        self.let_go_on_after_the_end(process, pids)
        self.ended = end_of(process)
        self.seconds = time.monotonic() - stop
        self.sort = (f"rank {self.silent} of {ranks}, {'--max-time' if by_time else 'USR1'} "
                     f"{stop - start:.1f} s after the start: exit {self.ended.code} after {self.seconds:.1f} s")
        return self

    def let_go_on_after_the_end(self, process, pids):
        """A rank that is stopped after the end of MPI keeps mpirun waiting, while all others have ended well: nobody is
        left who could give it up."""
        end = time.monotonic() + WITHIN
        while process.poll() is None and time.monotonic() < end:
            left = ranks_of(process)
            if self.sweep.table.exists() and len(pids) > 1 and left == [pids[self.silent]]:
                time.sleep(1)
                if ranks_of(process) == left:
                    os.kill(left[0], signal.SIGCONT)
                return
            time.sleep(0.05)

    def check(self):
        test = self.test
        test.assertIn(self.ended.code, (0, 75) if self.sweep.table.exists() else (75,), self.ended)
        test.assertLess(self.seconds, WITHIN, self.ended)
        kept = self.sweep.journalled()
        again = self.sweep.run(2)
        test.assertEqual(again.code, 0, again)
        test.assertEqual(self.sweep.results(), test.results)
        test.assertEqual(self.sweep.files(), ["sweep.toml", "table.h5"])
        run_time = self.sweep.timings()["run_time"]
        test.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")


class SilentRank(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        whole = Sweep(TEXT)
        ended = whole.run(2)
        assert ended.code == 0, ended
        cls.results = whole.results()

    def test_at_random_moments(self):
        seed = int(os.environ.get("SILENT_SEED", random.SystemRandom().randrange(10**9)))
        print(f"SILENT_SEED={seed}", flush=True)
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            trials = [pool.submit(Trial(self, seed + number)) for number in range(TRIALS)]
            for number, trial in enumerate(trials):
                with self.subTest(trial=number, seed=seed):
                    ended = trial.result()
                    print(ended.sort, flush=True)
                    ended.check()

    def test_names_the_rank_and_its_row(self):
        at_once(self.check_named, 0, 1)

    def check_named(self, silent):
        sweep = Sweep(LONG)
        process, [busy] = start_long_rows(sweep, 2)
        others = [rank for rank in range(2) if rank != busy]
        victim = busy if busy == silent else others[0]
        os.kill(ranks_of(process)[victim], signal.SIGSTOP)
        start = time.monotonic()
        process.send_signal(signal.SIGUSR1)
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        self.assertGreater(time.monotonic() - start, 25)
        self.assertLess(time.monotonic() - start, WITHIN)
        row = rf" \(row {LONG_ROW}\)" if victim == busy else r"( \(row \d+\))?"  # one of the short ones, or none
        self.assertRegex(ended.err, rf"rank {victim} on \S+{row} does not answer")
        self.assertEqual(len(re.findall("given up", ended.err)), 1, ended)

    def test_an_overdue_row_is_computed_by_another_rank(self):
        """The rank that has the last row is stopped for good. Another has nothing to do: all rows come in."""
        sweep = Sweep(LONG.replace("1e6]", "2e3]"))
        process, [busy] = start_long_rows(sweep, 3)
        os.kill(ranks_of(process)[busy], signal.SIGSTOP)
        if busy == 0:
            process.send_signal(signal.SIGUSR1)  # nothing is handed out without the manager
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        if busy != 0:
            self.assertEqual(set(sweep.journalled()), set(range(4)), ended)
            self.assertRegex(ended.err, rf"rank {busy} on \S+ does not answer")
            self.assertIn("4 of 4 rows done", ended.err)
        ended = sweep.run(2)
        self.assertEqual(ended.code, 0, ended)

    def test_while_the_table_is_written(self):
        """Nobody asks for a stop; the rank that is silent is named, and the next run finishes from the journal."""
        at_once(lambda silent_call: self.check_silent_at(*silent_call), (0, "fsync"), (1, "open to write"))

    def check_silent_at(self, silent, call):
        sweep = Sweep(TEXT)
        environment = failing(call, at=1, path=".h5.part", rank=silent)
        environment["FAIL_STOP"] = "1"
        start = time.monotonic()
        ended = sweep.run(3, env=environment)
        self.assertEqual(ended.code, 75, ended)
        self.assertGreater(time.monotonic() - start, 30)
        self.assertRegex(ended.err, rf"rank {silent} on \S+ does not answer")
        self.assertFalse(sweep.table.exists())
        kept = sweep.finish_keeping_rows()
        self.assertGreater(len(kept), 0)
        self.assertEqual(sweep.results(), self.results)

    def test_a_rank_that_goes_on_in_time(self):
        """Half a minute is enough for everybody who lives."""
        sweep = Sweep(LONG)
        process, [busy] = start_long_rows(sweep, 2)
        rank = ranks_of(process)[busy]
        os.kill(rank, signal.SIGSTOP)
        process.send_signal(signal.SIGUSR1)
        time.sleep(10)
        os.kill(rank, signal.SIGCONT)
        ended = end_of(process)
        self.assertEqual(ended.code, 75, ended)
        self.assertNotIn("given up", ended.err)


if __name__ == "__main__":
    unittest.main(verbosity=2)
