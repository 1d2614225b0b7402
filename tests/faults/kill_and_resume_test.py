"""A sweep survives kill -9 of any rank, or of mpirun, at any time: the next run goes on with every row that was
finished, and the results are the same to the bit as without the kill. KILL_TRIALS is the number of trials (10).

There is one exception: if the same row alone was being computed at two kills, the processes may have died of it, and it
is left out until --retry. The test allows this only for such rows."""

import collections
import concurrent.futures
import contextlib
import ctypes
import os
import random
import re
import signal
import subprocess
import time
import unittest

from sweep_process import LIMIT, Sweep, ranks_of, spec, wait_until_gone

TRIALS = int(os.environ.get("KILL_TRIALS", "10"))
AT_ONCE = 4  # trials; most of a trial is waiting for mpirun, which gives the other ranks two seconds
TEXT = spec()


class Trial:
    """One sweep that is killed once or twice and then finished."""

    def __init__(self, test, seed):
        self.test, self.random, self.sweep = test, random.Random(seed), Sweep(TEXT)
        self.kept = {}    # run_time by row, after the last kill
        self.alone = {}   # the only row that was being computed, by run that was killed
        self.hits = []    # the phase of the run at each kill
        self.left_out = set()

    def __call__(self):
        for _ in range(self.random.randint(1, 2)):
            self.kill_once()
            if self.sweep.table.exists():
                break
        self.finish()
        return self

    def wait_for_the_moment(self, process):
        moment = self.random.random()
        if moment < 0.15:  # MPI begins
            time.sleep(self.random.uniform(0.0, 0.5))
        elif moment < 0.65:  # rows are computed: just after one was written, or later
            self.sweep.wait_for_rows(process, len(self.sweep.journalled()) + self.random.randint(1, 250))
            time.sleep(self.random.choice([0.0, self.random.uniform(0.0, 0.1)]))
        else:  # the ranks write the table together
            part, end = self.sweep.path / "table.h5.part", time.monotonic() + LIMIT
            while process.poll() is None and not part.exists() and time.monotonic() < end:
                time.sleep(0.0005)
            time.sleep(self.random.uniform(0.0, 0.03))

    def kill_once(self):
        sweep = self.sweep
        process = sweep.start(self.random.randint(2, 4))
        self.wait_for_the_moment(process)
        process.send_signal(signal.SIGSTOP)  # mpirun must not start another rank now
        ranks = ranks_of(process)
        if self.random.random() < 0.2 or not ranks:
            process.kill()
        else:
            with contextlib.suppress(ProcessLookupError):  # the rank has ended before
                os.kill(self.random.choice(ranks), signal.SIGKILL)
        process.send_signal(signal.SIGCONT)
        wait_until_gone(ranks)
        try:
            process.communicate(timeout=30)
        except subprocess.TimeoutExpired:  # mpirun may hang at the end of its PMIx server, once in 250
            self.hits.append("mpirun hung without ranks")
            process.kill()
            process.communicate()
        if sweep.table.exists():
            return self.hits.append("the end")
        left = sweep.journalled()
        self.test.assertEqual({row: left.get(row) for row in self.kept}, self.kept, "rows were lost or computed again")
        self.hits.append("the table" if (sweep.path / "table.h5.part").exists() else
                         "rows" if len(left) > len(self.kept) else "the start")
        self.kept = left
        run, rows = sweep.in_flight()
        if len(rows) == 1:
            self.alone[run] = min(rows)

    def expected_to_be_left_out(self):
        return {row for row, deaths in collections.Counter(self.alone.values()).items()
                if deaths > 1 and row not in self.kept}

    def finish(self):
        test, sweep = self.test, self.sweep
        finished_before = sweep.table.exists()
        ended = sweep.run(self.random.randint(1, 4))
        if self.kept and not finished_before:
            test.assertIn(f"going on with {len(self.kept)} of {test.rows} rows", ended.err)
        self.left_out = {int(row) for row in re.findall(r"row (\d+) is left out", ended.err)}
        test.assertEqual(self.left_out, self.expected_to_be_left_out(), ended)
        test.assertEqual(ended.code, 3 if self.left_out else 0, ended)
        if self.left_out:
            ended = sweep.run(2, "--retry")
            test.assertEqual(ended.code, 0, ended)
        test.assertEqual(sweep.results(), test.results)
        run_time = sweep.timings()["run_time"]
        test.assertEqual({row: run_time[row] for row in self.kept}, self.kept, "finished rows were computed again")
        test.assertEqual(sweep.files(), ["sweep.toml", "table.h5"])


class KillAndResume(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        whole = Sweep(TEXT)
        ended = whole.run(2)
        assert ended.code == 0, ended
        cls.results, cls.rows = whole.results(), len(whole.timings())

    def test_random_kills(self):
        seed = int(os.environ.get("KILL_SEED", random.SystemRandom().randrange(10**9)))
        print(f"KILL_SEED={seed}", flush=True)
        hits, left_out = collections.Counter(), 0
        with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
            trials = [pool.submit(Trial(self, seed + number)) for number in range(TRIALS)]
        for number, trial in enumerate(trials):
            with self.subTest(trial=number, seed=seed):
                ended = trial.result()
                hits.update(ended.hits)
                left_out += len(ended.left_out)
        print(f"{TRIALS} trials; kills by what they hit: {dict(hits)}; {left_out} rows left out until --retry")
        self.assertGreater(hits["rows"] + hits["the table"], TRIALS // 3, "the kills came too late to test anything")

    def test_what_a_kill_leaves_in_the_machine(self):
        """A semaphore that a killed run left locked does not stop other runs, and its files are removed. Open MPI opens
        a file under a semaphore with the file's base name, and keeps files of its own beside it."""
        sweep = Sweep(spec(steps=20))
        sweep.table = sweep.path / f"taken-{os.getpid()}.h5"
        part = f"{sweep.table.name}.part"
        for name in (f"{part}-257622017-25513.lock", f"{part}.data.0", f"{part}.metadata.0", f"{part}ial.txt"):
            (sweep.path / name).write_text("")
        library, name = ctypes.CDLL(None, use_errno=True), f"OMPIO_{part}".encode()
        taken = library.sem_open(name, os.O_CREAT | os.O_EXCL, 0o600, 0)
        self.assertNotEqual(taken, 0, os.strerror(ctypes.get_errno()))
        try:
            ended = sweep.run(2)
        finally:
            library.sem_unlink(name)
        self.assertEqual(ended.code, 0, ended)
        self.assertEqual(sweep.files(), ["sweep.toml", sweep.table.name, f"{part}ial.txt"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
