"""kill -9 of any rank, or of mpirun, at any time: run again, the sweep goes on with every row that had come in, and the
results are the same to the bit as without the kill. KILL_TRIALS says how often (10)."""

import os
import random
import signal
import time
import unittest

from sweep_process import Sweep, end_of, ranks_of, wait_until_unlocked

TRIALS = int(os.environ.get("KILL_TRIALS", "10"))


class KillAndResume(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        seed = int(os.environ.get("KILL_SEED", random.SystemRandom().randrange(10**9)))
        print(f"KILL_SEED={seed}")
        cls.random = random.Random(seed)
        cls.whole = Sweep()
        start = time.monotonic()
        ended = cls.whole.run(2)
        assert ended.code == 0, ended
        cls.duration = time.monotonic() - start
        cls.results = cls.whole.results()

    def kill_once(self, sweep):
        """Starts the run and kills a part of it. Rows and run times in the journal that is left."""
        process = sweep.start(self.random.randint(2, 4))
        sweep.wait_for_rows(process, len(sweep.journalled()) + 1)
        time.sleep(self.random.uniform(0.0, 0.5 * self.duration))
        victims = ranks_of(process)
        if self.random.random() < 0.2:
            victims = [process.pid]
        try:
            if victims:
                os.kill(self.random.choice(victims), signal.SIGKILL)
        except ProcessLookupError:
            pass  # it was faster
        end_of(process)
        wait_until_unlocked(sweep)
        return sweep.journalled()

    def test_random_kills(self):
        rows = len(self.whole.timings())
        in_the_middle = 0
        for trial in range(TRIALS):
            with self.subTest(trial=trial):
                sweep = Sweep()
                kept = {}
                kills = self.random.randint(1, 2)
                for _ in range(kills):
                    left = self.kill_once(sweep)
                    if sweep.table.exists():
                        break
                    self.assertEqual({row: left.get(row) for row in kept}, kept, "rows were lost or computed again")
                    kept = left
                in_the_middle += 0 < len(kept) < rows
                finished_before = sweep.table.exists()
                ended = sweep.run(self.random.randint(1, 4))
                first = ended.err
                if ended.code == 1 and kills == 2:  # both hit the same row: that looks like the row's fault
                    self.assertIn("is left out", ended.err)
                    ended = sweep.run(2, "--retry")
                self.assertEqual(ended.code, 0, ended)
                self.assertEqual(sweep.results(), self.results)
                run_time = sweep.timings()["run_time"]
                self.assertEqual({row: run_time[row] for row in kept}, kept, "finished rows were computed again")
                if kept and not finished_before:
                    self.assertIn(f"going on with {len(kept)} of {rows} rows", first)
                self.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])
        print(f"{in_the_middle} of {TRIALS} kills hit a run in the middle")
        self.assertGreater(in_the_middle, TRIALS // 3, "the kills came too late to test anything")


if __name__ == "__main__":
    unittest.main(verbosity=2)
